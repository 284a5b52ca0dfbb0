#pragma once
/// P(limit state reached | drift): of one fitted law, and of walls that fail in several modes.

#include "core/interval.hpp"
#include "fragility/fits/censored_fit.hpp"

#include <span>
#include <vector>

namespace fragility {

struct FragilityPoint {
    double drift;        ///< [unit of the fit], > 0 for laws of positive values
    double probability;  ///< [-]
    double std_error;    ///< delta method [-]
    core::Interval band; ///< delta method on the logit: within [0, 1]
};

/// @throws std::invalid_argument if the fit has not converged or a drift is not a number
[[nodiscard]] std::vector<FragilityPoint>
fragility_curve(const Fit& fit, std::span<const double> drifts, double confidence = 0.95);

/// Walls of one mode.
struct ModeGroup {
    std::vector<Observation> limits;
    Law law = Law::lognormal;
    bool described = true; ///< by this law; false: counted like a mode without a fit
};

/// P = sum of shares times curves. Of a mode without a fit (too few of its walls, or none,
/// reached the limit state) only so much is known: `least` counts the share of its walls that
/// had, `most` as many as reached_at_most() allows at that drift, all of them where nobody
/// stood. If no mode has a fit, that is said of all walls together.
struct MixturePoint {
    double drift;
    double least, most;  ///< [-], equal where all modes have fits
    double std_error;    ///< of `least`: shares (multinomial) and fits (delta method)
    core::Interval band; ///< of `least` below and `most` above
};

struct Mixture {
    std::vector<double> shares; ///< of the modes
    std::vector<Fit> fits;
    std::vector<MixturePoint> points;
};

/// 95 % bands hold the truth of 50 walls in 93 to 98 of 100 studies whose runs end apart
/// (docs/bench/fragility/mixture_coverage.md); resampled walls do worse.
/// Neither the curve nor its band falls: a band is cut where those at neighbouring drifts are
/// sharper, as the delta method makes them in far tails.
/// @param drifts ascending
/// @throws std::invalid_argument without walls, for data that are not numbers or drifts that
/// fall
[[nodiscard]] Mixture mixture_curve(std::span<const ModeGroup> modes,
                                    std::span<const double> drifts, double confidence = 0.95);

struct MixtureQuantile {
    double value; ///< drift at which `least` reaches the share; infinite where it never does
    core::Interval
        interval; ///< drifts at which the upper and the lower end of the band reach it
};

/// Quantiles of a mixture: its curve and its band turned round, with Student's quantile in
/// place of the normal one. A mode without a law counts as observed (Kaplan and Meier's share,
/// Greenwood's error), so that the quantiles hold as far as its walls were tested.
/// @param shares in (0, 1)
/// @throws std::invalid_argument as mixture_curve, and as kaplan_meier for a mode without a law
[[nodiscard]] std::vector<MixtureQuantile> mixture_quantiles(std::span<const ModeGroup> modes,
                                                             std::span<const double> shares,
                                                             double confidence = 0.95);

} // namespace fragility
