#pragma once
/// A variable of one value.

#include "uq/marginals/shapes/shape_form.hpp"

namespace uq {

struct Constant {
    double value; ///< finite
    static constexpr std::string_view name = "constant";
};

/// @throws std::invalid_argument if the value is not finite
void check(const Constant&);
[[nodiscard]] inline std::span<const double> values_of(const Constant& s)
{
    return {&s.value, 1};
}
[[nodiscard]] inline std::span<const ShapeForm<Constant>> forms(const Constant*) { return {}; }

} // namespace uq
