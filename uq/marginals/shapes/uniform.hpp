#pragma once
/// The uniform distribution.

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Uniform {
    double lower, upper; ///< lower < upper
    static constexpr std::string_view name = "uniform";
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Uniform&);

// The meaning of each function is in uq/marginals/shapes/shape.hpp.
[[nodiscard]] Range support(const Uniform&);
[[nodiscard]] double density(const Uniform&, double x);
[[nodiscard]] double lower_tail(const Uniform&, double x);
[[nodiscard]] double upper_tail(const Uniform&, double x);
[[nodiscard]] double at_lower(const Uniform&, double p);
[[nodiscard]] double at_upper(const Uniform&, double q);
[[nodiscard]] MeanSd mean_sd(const Uniform&);
[[nodiscard]] std::span<const ShapeForm<Uniform>> forms(const Uniform*);

} // namespace uq
