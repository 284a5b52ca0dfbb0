#pragma once
/// The beta distribution between two ends.

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Beta {
    double alpha, beta, lower, upper; ///< alpha, beta > 0; lower < upper
    static constexpr std::string_view name = "beta";
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Beta&);
/// @param mean between the ends  @param cov coefficient of variation [-], > 0
[[nodiscard]] Beta beta_from_moments(double mean, double cov, double lower, double upper);

// The meaning of each function is in uq/marginals/shapes/shape.hpp.
[[nodiscard]] Range support(const Beta&);
[[nodiscard]] double density(const Beta&, double x);
[[nodiscard]] double lower_tail(const Beta&, double x);
[[nodiscard]] double upper_tail(const Beta&, double x);
[[nodiscard]] double at_lower(const Beta&, double p);
[[nodiscard]] double at_upper(const Beta&, double q);
[[nodiscard]] MeanSd mean_sd(const Beta&);
[[nodiscard]] std::span<const ShapeForm<Beta>> forms(const Beta*);

} // namespace uq
