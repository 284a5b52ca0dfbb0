#pragma once
/// The Weibull distribution of minima: P(X > x) = exp(-(x / scale)^shape).

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Weibull {
    double shape, scale; ///< both > 0
    static constexpr std::string_view name = "weibull";
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Weibull&);
/// @param mean > 0  @param cov coefficient of variation [-], in [0.001, 100]
[[nodiscard]] Weibull weibull_from_moments(double mean, double cov);

// The meaning of each function is in uq/marginals/shapes/shape.hpp.
[[nodiscard]] Range support(const Weibull&);
[[nodiscard]] double density(const Weibull&, double x);
[[nodiscard]] double lower_tail(const Weibull&, double x);
[[nodiscard]] double upper_tail(const Weibull&, double x);
[[nodiscard]] double at_lower(const Weibull&, double p);
[[nodiscard]] double at_upper(const Weibull&, double q);
[[nodiscard]] MeanSd mean_sd(const Weibull&);
[[nodiscard]] std::span<const ShapeForm<Weibull>> forms(const Weibull*);

} // namespace uq
