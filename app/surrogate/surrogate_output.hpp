#pragma once
/// Files and words of the verb surrogate.

#include "app/output/table/table.hpp"
#include "app/surrogate/mode_surrogate.hpp"
#include "app/surrogate/surrogate_fit.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace app {

constexpr const char* kSurrogateFormat = "drystone surrogate 1";
/// With coordinates (jacobi, laguerre) or noise (noise_slopes) that version 0.3 would misread.
constexpr const char* kNewerSurrogateFormat = "drystone surrogate 2";

/// The surrogates of one response of a study. All files of the verb are made of it.
struct SurrogateStudy {
    const StudyWalls* walls;
    const WallNumber* response;
    std::vector<std::size_t> inputs; ///< places in StudyWalls::inputs
    std::vector<LevelSurrogate> levels;
    std::vector<ModeSurrogate> modes; ///< of each level
};

/// Both surrogates of the response, and the modes, of every stress.
/// @param most walls of a stress that are learned from
[[nodiscard]] SurrogateStudy surrogate_study(const StudyWalls& walls,
                                             const WallNumber& response,
                                             std::size_t most = kMostSurrogateWalls);

/// Whether the response or the mode can be predicted under any stress.
[[nodiscard]] bool predicts(const SurrogateStudy& s);

/// Rows by stress and kind of surrogate: walls, Q2, RMSE, whether it is the better one and is
/// to be trusted.
[[nodiscard]] Table surrogate_table(const SurrogateStudy& s);

/// Rows by stress and input: indices of Sobol' from the chaos, Cramer-von Mises, HSIC,
/// independence. Only results are printed: an index that the walls do not give is an empty cell
/// with a note.
[[nodiscard]] Table surrogate_index_table(const SurrogateStudy& s);

/// Rows by wall: the response, and what the better surrogate predicts for the wall when it has
/// not seen it.
[[nodiscard]] Table surrogate_wall_table(const SurrogateStudy& s);

/// Rows by stress: how well the failure mode of a wall is told from its inputs.
[[nodiscard]] Table surrogate_mode_table(const SurrogateStudy& s);

/// Everything that is needed to predict; the format is in docs/surrogates.md.
[[nodiscard]] nlohmann::ordered_json surrogate_data(const SurrogateStudy& s);
/// surrogate_data as text.
[[nodiscard]] std::string surrogate_json(const SurrogateStudy& s);

/// Predicted against true, of walls left out.
[[nodiscard]] std::string surrogate_picture(const SurrogateStudy& s,
                                            const LevelSurrogate& level);

/// Walls of a stress that were left out, with names: a line for each reason.
[[nodiscard]] std::string left_out_text(const SurrogateStudy& s, const LevelSurrogate& level);

/// Doubts, and walls that were left out.
[[nodiscard]] std::string surrogate_remarks(const SurrogateStudy& s);

} // namespace app
