#include "uq/marginals/shapes/empirical.hpp"

#include "uq/marginals/shapes/shape_checks.hpp"

#include <algorithm>
#include <stdexcept>

namespace uq {

void check(const Empirical& s)
{
    if (s.sorted.empty())
        throw std::invalid_argument("empirical: no observations; one at least");
    for (const double x : s.sorted) require_finite("empirical: an observation", x);
    if (!std::ranges::is_sorted(s.sorted))
        throw std::invalid_argument("empirical: observations are not in ascending order");
}

} // namespace uq
