#pragma once
/// The normal distribution.

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Normal {
    double mean, sd; ///< sd > 0
    static constexpr std::string_view name = "normal";
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Normal&);
/// @param cov coefficient of variation = sd / |mean| [-], > 0
[[nodiscard]] Normal normal_from_moments(double mean, double cov);

// The meaning of each function is in uq/marginals/shapes/shape.hpp.
[[nodiscard]] Range support(const Normal&);
[[nodiscard]] double density(const Normal&, double x);
[[nodiscard]] double lower_tail(const Normal&, double x);
[[nodiscard]] double upper_tail(const Normal&, double x);
[[nodiscard]] double at_lower(const Normal&, double p);
[[nodiscard]] double at_upper(const Normal&, double q);
[[nodiscard]] MeanSd mean_sd(const Normal&);
[[nodiscard]] std::span<const ShapeForm<Normal>> forms(const Normal*);

} // namespace uq
