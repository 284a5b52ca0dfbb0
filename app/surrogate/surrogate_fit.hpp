#pragma once
/// Both surrogates of the walls of one stress, what they are worth and what the response
/// depends on.

#include "app/surrogate/surrogate_data.hpp"
#include "uq/estimates/estimate.hpp"
#include "uq/surrogates/chaos_fit.hpp"
#include "uq/surrogates/gaussian_process.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace app {

constexpr double kTrustedQ2 = 0.5; ///< below, a surrogate is not to be trusted; choice
constexpr double kExplainedQ2 =
    0.9; ///< from here on, two heaps are explained by the inputs; choice
constexpr double kOneHeapLevel = 0.05;    ///< of the test of one heap [-]
constexpr double kDependsLevel = 0.05;    ///< of the test of independence [-]
constexpr std::size_t kWallsPerInput = 5; ///< at least; choice
constexpr double kMostBounds = 0.1;       ///< share of walls that outlast the push; choice
constexpr std::size_t kFewestSurrogateWalls = 10; ///< of any surrogate; choice

/// Error on walls that a surrogate has not seen: Q2 = 1 - mean square residual / variance.
struct SurrogateError {
    double q2 = 0.0, rmse = 0.0; ///< [-]; in the shown unit of the response
};

/// Dependence of the response on its inputs by the samples alone, without a surrogate.
struct GivenData {
    /// Index of Cramer and von Mises, and of Da Veiga by HSIC; nothing where the walls do not
    /// show that the response depends on the input, or where the estimate is not in (0, 1].
    std::optional<uq::Estimate> rank, hsic;
    /// Probability of independence, by HSIC and by ranks together (Bonferroni) [-]: the ranks
    /// see periodic laws, HSIC sees weak trends.
    double p_value = 1.0;
};

struct LevelSurrogate {
    SurrogatePoints points;
    std::optional<uq::ChaosFit> chaos;
    std::optional<uq::GaussianProcess> process;
    SurrogateError chaos_error;   ///< terms chosen anew without each tenth of the walls
    SurrogateError process_error; ///< parameters fitted anew, likewise
    /// Variance of a prediction of the process, times this: mean square of what it misses on
    /// walls left out over what it promises, at least 1.
    double inflation = 1.0;
    Eigen::VectorXd left_out; ///< what the better one says of each wall without it
    bool chaos_is_better = false;
    std::optional<double> one_heap; ///< p-value
    std::vector<std::string>
        doubts;             ///< why it is not to be trusted: whole sentences; empty: it is
    std::string no_indices; ///< why there are no indices of Sobol'; empty: there are
    std::vector<GivenData> given; ///< of each input; empty: too few walls, or no response
};

/// Whether there is a surrogate, to be trusted or not.
[[nodiscard]] inline bool predicts(const LevelSurrogate& l) { return l.chaos || l.process; }

/// @param dependent inputs depend on each other, by the study
[[nodiscard]] LevelSurrogate fit_surrogate(SurrogatePoints points,
                                           const std::vector<uq::PolynomialFamily>& families,
                                           bool dependent, std::uint64_t seed);

} // namespace app
