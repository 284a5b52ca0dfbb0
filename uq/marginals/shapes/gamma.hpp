#pragma once
/// The gamma distribution.

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Gamma {
    double shape, scale; ///< both > 0
    static constexpr std::string_view name = "gamma";
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Gamma&);
/// @param mean > 0  @param cov coefficient of variation [-], > 0
[[nodiscard]] Gamma gamma_from_moments(double mean, double cov);

// The meaning of each function is in uq/marginals/shapes/shape.hpp.
[[nodiscard]] Range support(const Gamma&);
[[nodiscard]] double density(const Gamma&, double x);
[[nodiscard]] double lower_tail(const Gamma&, double x);
[[nodiscard]] double upper_tail(const Gamma&, double x);
[[nodiscard]] double at_lower(const Gamma&, double p);
[[nodiscard]] double at_upper(const Gamma&, double q);
[[nodiscard]] MeanSd mean_sd(const Gamma&);
[[nodiscard]] std::span<const ShapeForm<Gamma>> forms(const Gamma*);

} // namespace uq
