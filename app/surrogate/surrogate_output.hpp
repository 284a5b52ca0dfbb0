#pragma once
/// Files and words of the verb surrogate.

#include "app/output/table.hpp"
#include "app/surrogate/surrogate_fit.hpp"

#include <string>
#include <vector>

namespace app {

constexpr const char* kSurrogateFormat = "drystone surrogate 1";

/// Everything that the verb writes is made of this.
struct SurrogateStudy {
    const StudyWalls* walls;
    const WallNumber* response;
    std::vector<std::size_t> inputs; ///< places in StudyWalls::inputs
    std::vector<LevelSurrogate> levels;
};

/// Rows by stress and kind of surrogate: walls, Q2, RMSE, whether it is the better one and is
/// to be trusted.
[[nodiscard]] Table surrogate_table(const SurrogateStudy& s);

/// Rows by stress and input: indices of Sobol' from the chaos, Cramer-von Mises, HSIC,
/// independence. Only results are printed: an index that the walls do not give is an empty cell
/// with a note.
[[nodiscard]] Table surrogate_index_table(const SurrogateStudy& s);

/// Rows by wall: the response and what the better surrogate says of it without it.
[[nodiscard]] Table surrogate_wall_table(const SurrogateStudy& s);

/// JSON text with what is needed to predict; the format is in docs/surrogates.md.
[[nodiscard]] std::string surrogate_json(const SurrogateStudy& s);

/// Predicted against true, of walls left out.
[[nodiscard]] std::string surrogate_picture(const SurrogateStudy& s,
                                            const LevelSurrogate& level);

/// Doubts, and walls that were left out, with names.
[[nodiscard]] std::string surrogate_remarks(const SurrogateStudy& s);

} // namespace app
