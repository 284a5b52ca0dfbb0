#pragma once
/// Observations, each as likely as the others.

#include "uq/marginals/shapes/shape_form.hpp"

#include <vector>

namespace uq {

struct Empirical {
    std::vector<double> sorted; ///< observations, at least one, ascending, finite
    static constexpr std::string_view name = "empirical";
};

/// @throws std::invalid_argument naming what is wrong with the observations
void check(const Empirical&);
[[nodiscard]] inline std::span<const double> values_of(const Empirical& s) { return s.sorted; }
/// In text it has values instead of named parameters.
[[nodiscard]] inline std::span<const ShapeForm<Empirical>> forms(const Empirical*)
{
    return {};
}

} // namespace uq
