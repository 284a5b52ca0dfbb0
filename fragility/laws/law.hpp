#pragma once
/// Laws of a limit displacement, all with a location and a dispersion.

#include <optional>
#include <string_view>

namespace fragility {

enum class Law {
    lognormal, ///< location: mean of ln x, dispersion: standard deviation of ln x
    normal,    ///< location: mean [x], dispersion: standard deviation [x]
    weibull,   ///< location: ln scale, dispersion: 1 / shape
    gamma      ///< location: ln mean, dispersion: coefficient of variation, 1 / sqrt(shape)
};

[[nodiscard]] constexpr bool positive(Law law) { return law != Law::normal; }
[[nodiscard]] std::string_view name(Law law); ///< "lognormal", ...
[[nodiscard]] std::optional<Law> law(std::string_view name);

struct Distribution {
    Law law = Law::lognormal;
    double location = 0.0;   ///< see Law
    double dispersion = 1.0; ///< see Law, > 0
};

[[nodiscard]] double cdf(const Distribution& d, double x);
[[nodiscard]] double survival(const Distribution& d, double x);
/// @throws std::invalid_argument if p is not in (0, 1)
[[nodiscard]] double quantile(const Distribution& d, double p);
/// Shape and scale of a Weibull or gamma law.
[[nodiscard]] double shape(const Distribution& d);
[[nodiscard]] double scale(const Distribution& d);

} // namespace fragility
