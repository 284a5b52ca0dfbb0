#include "uq/marginals/marginal.hpp"

#include "uq/marginals/shapes/shape_checks.hpp"
#include "uq/marginals/shapes/truncated.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace uq {
namespace {

template <Discrete S> double share_left(const S& s, const Marginal& m)
{
    const auto is_left = [&](double x) { return m.lower <= x && x <= m.upper; };
    return std::ranges::any_of(values_of(s), is_left) ? 1.0 : 0.0;
}

template <class S> double share_left(const S& s, const Marginal& m)
{
    return truncated::cut(s, m.lower, m.upper).mass;
}

} // namespace

double share_left(const Marginal& m)
{
    return std::visit([&](const auto& s) { return share_left(s, m); }, m.shape);
}

void check(const Marginal& m)
{
    std::visit([](const auto& s) { check(s); }, m.shape);
    if (std::isnan(m.lower) || std::isnan(m.upper) || m.lower > m.upper)
        refuse("cut: upper end", m.upper, "a number, not below the lower end of the cut");
    constexpr double kSmallest = 1e-290; // below it quotients of probabilities lose digits
    if (!(share_left(m) >= kSmallest)) {
        std::ostringstream text;
        text << "cut: nothing of the distribution is left between " << m.lower << " and "
             << m.upper;
        throw std::invalid_argument(text.str());
    }
}

} // namespace uq
