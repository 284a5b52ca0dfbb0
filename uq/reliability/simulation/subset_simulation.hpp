#pragma once
/// Small probabilities as a product of larger ones (Au and Beck 2001), by conditional sampling
/// (Papaioannou, Betz, Zwirglmaier, Straub 2015).

#include "uq/reliability/limit_state/exceedance.hpp"

#include <limits>

namespace uq {

struct SubsetOptions {
    std::size_t samples = 1000; ///< per level, a multiple of 1 / level_share
    /// Share of a level that seeds the next: 1 / length of the chains. [1 / samples, 1/2]
    double level_share = 0.1;
    int max_levels = 20; ///< including the first, >= 1
    /// No level, and no further run, is begun that would need more evaluations than this in
    /// all.
    std::size_t max_evaluations = std::numeric_limits<std::size_t>::max();
    /// Coefficient of variation [-], > 0. Independent runs are added until their mean has it.
    double target_cov = std::numeric_limits<double>::infinity();
    double confidence = 0.95; ///< of the interval, (0, 1)
    std::uint64_t seed = 1;
};

struct SubsetLevel {
    double threshold;      ///< g at the level's end; the last one's is 0
    double share;          ///< of the level's samples at or below it
    double acceptance;     ///< of the moves that made the level [-]; 1 for the first
    std::size_t ancestors; ///< first-level samples that those at or below it descend from
};

struct SubsetResult {
    Exceedance exceedance;
    std::vector<SubsetLevel> levels; ///< of the first run, in which failed samples are safe
    bool arrived = false; ///< a tenth (level_share) of the first run's last level passed
    std::size_t runs = 1; ///< of which the answer is the mean
};

/// With fewer ancestors the standard error is uncertain, and a warning says so. Tuned, see
/// tests.
constexpr std::size_t kFewAncestors = 10;

/// The standard error is that of the numbers of passed descendants of the first level's
/// samples, which are independent of each other: correlation inside chains, between chains and
/// between levels is all in it. (Of generalised splitting: Botev and Kroese 2012; for particle
/// filters: Lee and Whiteley 2018.) The interval is log-normal with Student's factor, since few
/// large families tell little of their own scatter.
///
/// Where a run ends with evaluations left and the target_cov is not reached, as many are begun
/// as fit by the evaluations of the longest so far; they are independent, and the answer is
/// their mean. A run has a bias of the order of its squared coefficient of variation (Au and
/// Beck 2001), which the mean keeps; stopping on the result adds one of the order of
/// target_cov^2.
///
/// A failed evaluation is a rejected move. If there is any, no run is added for the target, and
/// the analysis is run once more with failed samples passed, for the upper bound; where the
/// evaluations allowed do not suffice for that, the upper bound is 1. If the limit state cannot
/// be reached (max_levels, max_evaluations, or g takes one value over a whole level) and
/// nothing has passed, the outcome is none_passed and the upper end of the interval is that of
/// the last level reached. The outcome is target_reached if the estimate has the target_cov,
/// else limit_reached.
/// @throws std::invalid_argument naming the option that is out of range
[[nodiscard]] SubsetResult subset_simulation(const LimitState& s, const SubsetOptions& o = {});

} // namespace uq
