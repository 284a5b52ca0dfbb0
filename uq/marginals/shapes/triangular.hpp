#pragma once
/// The triangular distribution.

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Triangular {
    double lower, mode, upper; ///< lower <= mode <= upper, lower < upper
    static constexpr std::string_view name = "triangular";
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Triangular&);
/// Probability between x and y, x <= y, both inside the support: the density is made of
/// straight lines.
[[nodiscard]] double between(const Triangular& s, double x, double y);
/// Where the density has a kink: the mode.
[[nodiscard]] double kink(const Triangular& s);

// The meaning of each function is in uq/marginals/shapes/shape.hpp.
[[nodiscard]] Range support(const Triangular&);
[[nodiscard]] double density(const Triangular&, double x);
[[nodiscard]] double lower_tail(const Triangular&, double x);
[[nodiscard]] double upper_tail(const Triangular&, double x);
[[nodiscard]] double at_lower(const Triangular&, double p);
[[nodiscard]] double at_upper(const Triangular&, double q);
[[nodiscard]] MeanSd mean_sd(const Triangular&);
[[nodiscard]] std::span<const ShapeForm<Triangular>> forms(const Triangular*);

} // namespace uq
