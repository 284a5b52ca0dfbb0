#include "uq/marginals/marginal.hpp"

#include "uq/marginals/shapes/shape_checks.hpp"
#include "uq/marginals/shapes/truncated.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace uq {
namespace {

template <Discrete S> bool leaves(const S& s, const Marginal& m)
{
    return std::ranges::any_of(values_of(s),
                               [&](double x) { return m.lower <= x && x <= m.upper; });
}

template <class S> bool leaves(const S& s, const Marginal& m)
{
    constexpr double kSmallest = 1e-290; // below it quotients of probabilities lose digits
    return truncated::cut(s, m.lower, m.upper).mass >= kSmallest;
}

} // namespace

void check(const Marginal& m)
{
    std::visit([](const auto& s) { check(s); }, m.shape);
    if (std::isnan(m.lower) || std::isnan(m.upper) || m.lower > m.upper)
        refuse("cut: upper end", m.upper, "a number, not below the lower end of the cut");
    if (!std::visit([&](const auto& s) { return leaves(s, m); }, m.shape)) {
        std::ostringstream text;
        text << "cut: nothing of the distribution is left between " << m.lower << " and "
             << m.upper;
        throw std::invalid_argument(text.str());
    }
}

} // namespace uq
