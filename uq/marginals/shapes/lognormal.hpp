#pragma once
/// The lognormal distribution: ln x is normal.

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Lognormal {
    double mu_log, sigma_log; ///< mean and standard deviation of ln x; sigma_log > 0
    static constexpr std::string_view name = "lognormal";
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Lognormal&);
/// @param mean > 0  @param cov coefficient of variation [-], > 0
[[nodiscard]] Lognormal lognormal_from_moments(double mean, double cov);

// The meaning of each function is in uq/marginals/shapes/shape.hpp.
[[nodiscard]] Range support(const Lognormal&);
[[nodiscard]] double density(const Lognormal&, double x);
[[nodiscard]] double lower_tail(const Lognormal&, double x);
[[nodiscard]] double upper_tail(const Lognormal&, double x);
[[nodiscard]] double at_lower(const Lognormal&, double p);
[[nodiscard]] double at_upper(const Lognormal&, double q);
[[nodiscard]] MeanSd mean_sd(const Lognormal&);
[[nodiscard]] std::span<const ShapeForm<Lognormal>> forms(const Lognormal*);

} // namespace uq
