#pragma once
/// Knowledge of one wall's limit displacement: a value, or that it lies between two.

#include "fragility/curve/curve_reading.hpp"

#include <optional>
#include <span>
#include <vector>

namespace fragility {

/// The value lies within [lower, upper]; both ends equal: observed. Lower end -infinity (or 0
/// for laws of positive values): left-censored; upper end infinite: right-censored.
struct Observation {
    double lower;
    double upper;
    double weight = 1.0; ///< how many such walls [-], > 0
    bool capped = false; ///< a drift limit of a code or of the user, not the wall's own
};

[[nodiscard]] Observation observed(double value);
[[nodiscard]] Observation right_censored(double lower); ///< above `lower`
[[nodiscard]] Observation left_censored(double upper);  ///< below `upper`

/// A reading times `scale` (1 / height makes it a drift), capped where it is a drift limit;
/// nothing if it is not defined.
/// @throws std::invalid_argument if the scale is not positive
[[nodiscard]] std::optional<Observation> observation(const LimitDisplacement& reading,
                                                     double scale = 1.0);

enum class Censoring { none, right, left, interval };
/// A lower end of 0 is as good as none if `positive`.
[[nodiscard]] Censoring censoring(const Observation& o, bool positive);

/// Sums of weights.
struct Counts {
    double n = 0.0;
    double observed = 0.0, right = 0.0, left = 0.0, interval = 0.0;
};
[[nodiscard]] Counts count(std::span<const Observation> data, bool positive);

/// Runs of one push end up to one interval of their curve apart: ends that differ by less are
/// one [-].
constexpr double kEndsTogether = 2e-3;

/// Limits that are a drift limit of a code or of the user.
struct Cap {
    double value; ///< [x]
    double walls; ///< sum of weights
    friend bool operator==(const Cap&, const Cap&) = default;
};
/// Ascending, one for each value; empty where all limits are the walls' own.
[[nodiscard]] std::vector<Cap> caps(std::span<const Observation> data);

/// The largest value at which any of these walls reached the limit state or still stood: no
/// wall was tested beyond it. 0 without walls.
[[nodiscard]] double known_to(std::span<const Observation> data);

/// Whether walls that are known to `end` are known at x.
[[nodiscard]] constexpr bool is_known(double x, double end)
{
    return x <= end * (1.0 + kEndsTogether);
}

/// known_to, or where runs ended together there, the first of their ends: beyond it the few
/// that went on would stand for all.
[[nodiscard]] double common_end(std::span<const Observation> data);

} // namespace fragility
