#pragma once
/// The methods that begin with the points of the limit state nearest to the origin.

#include "uq/reliability/design_point/form.hpp"
#include "uq/reliability/reliability.hpp"

#include <cstddef>

namespace uq {

/// FORM, within `budget` evaluations.
FormResult search(const ReliabilityProblem& p, std::size_t budget, ReliabilityAnswer& a);

/// SORM at the nearest point, if the budget has what its curvatures need.
void second_order(const ReliabilityProblem& p, const FormResult& first, ReliabilityAnswer& a);

/// Importance sampling about all points, with what the budget leaves.
void important(const ReliabilityProblem& p, const FormResult& first, ReliabilityAnswer& a);

/// Does the event begin elsewhere at about the same distance? Asks in directions at right
/// angles to the design points or beyond, 1.2 beta away, with what the budget leaves, 100
/// evaluations at most.
void look_elsewhere(const ReliabilityProblem& p, const FormResult& found, ReliabilityAnswer& a);

} // namespace uq
