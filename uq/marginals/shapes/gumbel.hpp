#pragma once
/// The Gumbel distribution of maxima: P(X <= x) = exp(-exp(-(x - location) / scale)).

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Gumbel {
    double location, scale; ///< scale > 0
    static constexpr std::string_view name = "gumbel";
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Gumbel&);
/// @param cov coefficient of variation = sd / |mean| [-], > 0
[[nodiscard]] Gumbel gumbel_from_moments(double mean, double cov);

// The meaning of each function is in uq/marginals/shapes/shape.hpp.
[[nodiscard]] Range support(const Gumbel&);
[[nodiscard]] double density(const Gumbel&, double x);
[[nodiscard]] double lower_tail(const Gumbel&, double x);
[[nodiscard]] double upper_tail(const Gumbel&, double x);
[[nodiscard]] double at_lower(const Gumbel&, double p);
[[nodiscard]] double at_upper(const Gumbel&, double q);
[[nodiscard]] MeanSd mean_sd(const Gumbel&);
[[nodiscard]] std::span<const ShapeForm<Gumbel>> forms(const Gumbel*);

} // namespace uq
