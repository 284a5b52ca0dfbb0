#pragma once
/// Inputs that peak force and ultimate displacement depend on (the paper, Fig. 12).

#include "app/fragility/numbers/fragility_output.hpp"
#include "app/output/table/table.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/study/stored/study_walls.hpp"

#include "uq/estimates/estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// Influence of an input on a response; nothing where that cannot be told.
struct Influence {
    std::string key;
    std::optional<uq::Estimate> pearson, spearman; ///< correlation of values, of ranks
    std::optional<uq::Estimate> standardised,
        partial; ///< coefficient, and partial correlation, of the ranks
};

struct Influences {
    std::size_t walls = 0;         ///< used: those on which the response was observed
    double r2 = 0.0;               ///< of the regression of ranks [-]; NaN: too few walls
    std::vector<Influence> inputs; ///< without values below 4 walls
};
[[nodiscard]] Influences influences(const StudyWalls& walls, const StudyLevel& level,
                                    const WallNumber& response);

/// Per vertical stress, response and input: correlations of values and of ranks, standardised
/// rank regression, share explained. Ultimate displacement: of the walls on which it was
/// observed.
[[nodiscard]] Table input_table(const StudyWalls& walls);

/// Peak force over the joint friction angle, one dot per wall, one colour per mode; a chart of
/// each level. Empty without that random input.
[[nodiscard]] std::vector<NamedPicture> input_pictures(const StudyWalls& walls);

} // namespace app
