#pragma once
/// The ways to write a marginal in text: names of the distributions and of their parameters.

#include "uq/marginals/shapes/shape.hpp"

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace uq {

struct MarginalForm {
    std::string_view name; ///< of the distribution: "gumbel"
    std::vector<ShapeParameter> parameters;
    /// @param values in the order of `parameters`
    /// @throws std::invalid_argument if no distribution has these parameters
    std::function<Shape(std::span<const double> values)> make;
};

/// All forms, in the order of Shape; a distribution may have several.
[[nodiscard]] const std::vector<MarginalForm>& marginal_forms();

} // namespace uq
