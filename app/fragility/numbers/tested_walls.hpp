#pragma once
/// The error of the model as tests show it: walls of Lourenco, Oliveira, Roca and Orduna
/// (2005), J. Struct. Eng. 131(11), 1665-1675, over the medians of the random walls that this
/// program pushes in their place.

#include "core/interval.hpp"
#include "dem/solver/state/solver_options.hpp"
#include "fragility/limits/hierarchical_normal.hpp"
#include "fragility/limits/model_factor.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct FragilityInput;
struct LoadInput;
struct Masonry;
struct Parameters;
struct Study;

/// The answer of the program that a factor multiplies.
enum class Answer { drift, force };

/// A wall that was pushed in a laboratory, and what the program says of such walls.
struct TestedWall {
    std::string name;
    double stress = 0.0;    ///< vertical [Pa]
    double measured = 0.0;  ///< in the unit of `predicted`, > 0
    double predicted = 0.0; ///< median of the random walls, > 0
    bool at_least = false;  ///< the test ended before
};

/// The walls behind the factor `tests`, of displacements at 80 % of the peak [mm] or of peak
/// forces [kN].
[[nodiscard]] std::vector<TestedWall> tested_walls(Answer answer, dem::Damping damping);

/// How far tests and this program differ: "In a laboratory 7 walls ...".
[[nodiscard]] std::string tests_sentence(dem::Damping damping);

/// ln(measured / predicted); walls of one stress are repeats of one level.
[[nodiscard]] std::vector<fragility::LevelledValue>
log_ratios(std::span<const TestedWall> walls);

/// Half-t priors of both scatters: of mean 0.25, so that 95 % of them lie below 0.7. Three or
/// four levels alone do not fix a scatter: a prior twice as wide makes the dispersion of the
/// drifts 0.65 in place of 0.46. docs/bench/fragility/factor_coverage.md has what they hold.
inline constexpr fragility::ScalePrior kFactorPrior{0.25};

/// The factor with its doubt, and intervals of 90 % of both.
struct EstimatedFactor {
    fragility::ModelFactor factor;
    core::Interval median, dispersion;
};
/// @throws std::invalid_argument for fewer than three walls whose values were measured
[[nodiscard]] EstimatedFactor estimated_factor(std::span<const TestedWall> walls);

/// The factor of one stress of a study, and where it comes from.
struct AppliedFactor {
    fragility::ModelFactor factor{};
    std::string source = "none"; ///< "none", "given", "tests" or "tests, median not applied"
    std::string unlike;          ///< why the walls are not like those tested; empty: they are
};

/// The study's own factor. That of the tests corrects walls like those tested only; on others
/// its median is 1, and the error of that is the whole correction: median_error^2 = error^2 +
/// (ln median)^2.
[[nodiscard]] AppliedFactor applied_factor(const Study& study, double stress, Answer answer);

/// "fragility.model_factor = tests. The factor of the tests ... has the median 0.79 [0.55,
/// 1.15] ...", for captions.
[[nodiscard]] std::string factor_text(const dem::SolverOptions& solver,
                                      const FragilityInput& fragility, Answer answer);

/// Why walls are not like those tested: "the load is 3 m above the floor (tested 1.1 m)"; empty
/// where they are. Like them are walls in courses, without openings, of dry joints and units
/// that can crack, 0.75 to 1.25 m long, loaded 0.80 to 1.40 m above the floor, pushed one way,
/// under 0.4 to 1.5 MPa (drifts) or 0.12 to 1.5 MPa (forces).
[[nodiscard]] std::string unlike_tested(const Masonry& masonry, const LoadInput& load,
                                        double stress, Answer answer);

} // namespace app
