#include "fragility/curve/curve_reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace fragility {
namespace {

[[noreturn]] void refuse(std::size_t i, const char* reason)
{
    throw std::invalid_argument("capacity curve: point " + std::to_string(i + 1) + ": " +
                                reason);
}

std::size_t peak_index(const Curve& c)
{
    return static_cast<std::size_t>(std::ranges::max_element(c.force) - c.force.begin());
}

bool rises_to_end(const Curve& c, std::size_t top)
{
    return top + 1 == c.force.size() && c.displacement[top] > 0.0;
}

/// Where the segment from (d0, f0) to (d1, f1), f0 != f1, is at `force`; inside [d0, d1]
/// whatever the rounding.
double interpolate(double d0, double f0, double d1, double f1, double force)
{
    return std::clamp(d0 + (d1 - d0) * ((force - f0) / (f1 - f0)), d0, d1);
}

/// The segment that ends at point i crosses `force`.
double crossing_before(const Curve& c, std::size_t i, double force)
{
    return interpolate(c.displacement[i - 1], c.force[i - 1], c.displacement[i], c.force[i],
                       force);
}

LimitDisplacement censored_at_end(const Curve& c, std::string_view reason)
{
    return {c.displacement.back(), Reading::censored, reason};
}

LimitDisplacement came_down_at_end(const Curve& c)
{
    return {c.displacement.back(), Reading::observed, "the wall came down"};
}

} // namespace

void check(const Curve& c)
{
    if (c.displacement.size() != c.force.size())
        throw std::invalid_argument("capacity curve: not one force for each displacement");
    if (c.force.empty()) throw std::invalid_argument("capacity curve: no points");
    for (std::size_t i = 0; i < c.force.size(); ++i) {
        if (!std::isfinite(c.displacement[i])) refuse(i, "displacement is not a finite number");
        if (!std::isfinite(c.force[i])) refuse(i, "force is not a finite number");
        if (c.displacement[i] < (i == 0 ? 0.0 : c.displacement[i - 1]))
            refuse(i, i == 0 ? "displacement is negative" : "displacement decreases");
    }
}

Peak peak(const Curve& c)
{
    check(c);
    const std::size_t i = peak_index(c);
    return {c.force[i], c.displacement[i], rises_to_end(c, i)};
}

std::optional<double> first_reaching(const Curve& c, double force)
{
    check(c);
    const bool led_from_origin = c.displacement[0] > 0.0;
    if (led_from_origin ? force <= 0.0 : force <= c.force[0]) return 0.0;
    if (force <= c.force[0]) return interpolate(0.0, 0.0, c.displacement[0], c.force[0], force);
    for (std::size_t i = 1; i < c.force.size(); ++i)
        if (c.force[i] >= force) return crossing_before(c, i, force);
    return std::nullopt;
}

double area(const Curve& c, double displacement)
{
    check(c);
    if (!(displacement >= 0.0 && displacement <= c.displacement.back()))
        throw std::invalid_argument("capacity curve: area asked for outside the curve");
    double d0 = 0.0;
    double f0 = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < c.force.size() && d0 < displacement; ++i) {
        const double d1 = std::min(c.displacement[i], displacement);
        const double run = c.displacement[i] - d0;
        const double f1 = run > 0.0 ? f0 + (c.force[i] - f0) * ((d1 - d0) / run) : c.force[i];
        sum += 0.5 * (f0 + f1) * (d1 - d0);
        d0 = d1;
        f0 = f1;
    }
    return sum;
}

std::optional<double> secant_stiffness(const Curve& c, double share)
{
    if (!(share > 0.0 && share <= 1.0))
        throw std::invalid_argument("secant stiffness: share of the peak must be in (0, 1]");
    const double force = share * peak(c).force;
    if (!(force > 0.0)) return std::nullopt;
    const double stiffness = force / first_reaching(c, force).value();
    if (!std::isfinite(stiffness)) return std::nullopt;
    return stiffness;
}

LimitDisplacement drop_after_peak(const Curve& c, double share, Crossing crossing)
{
    check(c);
    if (!(share >= 0.0 && share < 1.0))
        throw std::invalid_argument("drop after the peak: share of the peak must be in [0, 1)");
    const std::size_t top = peak_index(c);
    if (!(c.force[top] > 0.0))
        return {0.0, Reading::not_defined, "the force is nowhere positive"};
    const double level = share * c.force[top];
    const auto above = [&](std::size_t i) { return c.force[i] > level; };

    std::size_t first = top + 1;
    while (first < c.force.size() && above(first)) ++first;
    if (first == c.force.size() && c.came_down) return came_down_at_end(c);
    if (first == c.force.size())
        return censored_at_end(c, rises_to_end(c, top)
                                      ? "the force still rises where the curve ends"
                                      : "the push ended before the force fell that far");
    if (crossing == Crossing::first)
        return {crossing_before(c, first, level), Reading::observed, {}};

    std::size_t last = c.force.size() - 1;
    if (above(last) && c.came_down) return came_down_at_end(c);
    if (above(last)) return censored_at_end(c, "the force has recovered where the curve ends");
    while (!above(last - 1)) --last; // stops at the peak at the latest
    return {crossing_before(c, last, level), Reading::observed, {}};
}

DropRange drop_range(const Curve& c, double share, Crossing crossing, double error)
{
    if (!(error >= 0.0)) return {};
    const double below_peak = std::nextafter(1.0, 0.0);
    return {drop_after_peak(c, std::min(below_peak, share * (1.0 + error)), crossing),
            drop_after_peak(c, std::max(0.0, share * (1.0 - error)), crossing)};
}

} // namespace fragility
