#include "fragility/curve/cyclic_curve.hpp"

#include "fragility/curve/path_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace fragility {
namespace {

/// Where the force comes to zero after the point `from`, up to the point `last`, or on the way
/// on to the next turn: what comes back the way it went has no force at zero displacement, to
/// rounding, and may get there just beyond it. Where the way ends before, a force below
/// kNoForce of that at `from` is none.
std::optional<double> zero_force(const Path& p, std::size_t from, std::size_t last)
{
    constexpr double kNoForce = 0.005; // a free choice
    const double sign = p.force[from] > 0.0 ? 1.0 : -1.0;
    if (p.force[from] == 0.0) return p.displacement[from];
    const auto goes_on = [&](std::size_t i) {
        const double way = p.displacement[last] - p.displacement[from];
        return i < p.force.size() && (p.displacement[i] - p.displacement[i - 1]) * way >= 0.0;
    };
    std::size_t i = from + 1;
    for (; i <= last || goes_on(i); ++i)
        if (sign * p.force[i] <= 0.0)
            return between(p.force[i - 1], p.displacement[i - 1], p.force[i], p.displacement[i],
                           0.0);
    const bool none = i > from + 1 && sign * p.force[i - 1] < kNoForce * sign * p.force[from];
    return none ? std::optional(p.displacement[i - 1]) : std::nullopt;
}

/// Share of the way from a point to the next one at which the path passes zero displacement.
double share_to_zero(const Path& p, std::size_t from)
{
    if (from + 1 >= p.displacement.size()) return 0.0;
    const double a = p.displacement[from], b = p.displacement[from + 1];
    return a * b < 0.0 ? a / (a - b) : 0.0;
}

/// Work from a point to where the path passes zero displacement on its way to the next one.
double work_to_zero(const Path& p, std::size_t from, double share)
{
    if (share == 0.0) return 0.0;
    const double at_zero = p.force[from] + share * (p.force[from + 1] - p.force[from]);
    return -0.5 * (p.force[from] + at_zero) * p.displacement[from];
}

/// Whether the path goes out again on its way back on one side.
bool has_inner_loop(const Path& p, std::size_t begin, std::size_t end, double width)
{
    constexpr double kJitter = 0.02; // of the width: of sensors and of valves; a free choice
    double nearest = std::abs(p.displacement[begin]), farthest = nearest;
    bool comes_back = false;
    for (std::size_t i = begin + 1; i <= end; ++i) {
        const double x = std::abs(p.displacement[i]);
        if (p.displacement[i] * p.displacement[i - 1] <= 0.0) { // a new side
            comes_back = false;
            nearest = farthest = x;
        }
        farthest = std::max(farthest, x);
        if (farthest - x > kJitter * width && !comes_back) {
            comes_back = true;
            nearest = x;
        }
        nearest = std::min(nearest, x);
        if (comes_back && x - nearest > kJitter * width) return true;
    }
    return false;
}

Cycle cycle_between(const Path& p, std::size_t begin, std::size_t end, bool closed)
{
    Cycle c;
    c.begin = begin;
    c.end = end;
    c.closed = closed;
    c.begin_share = share_to_zero(p, begin);
    c.end_share = share_to_zero(p, end);
    c.energy = work_to_zero(p, end, c.end_share) - work_to_zero(p, begin, c.begin_share);
    // the first point may lie on the side that the path comes from: it is no extreme
    std::size_t plus = begin > 0 ? begin + 1 : 0, minus = plus;
    for (std::size_t i = begin; i <= end; ++i) {
        if (i >= plus && p.displacement[i] > p.displacement[plus]) plus = i;
        if (i >= minus && p.displacement[i] < p.displacement[minus]) minus = i;
        c.force_plus = std::max(c.force_plus, p.force[i]);
        c.force_minus = std::min(c.force_minus, p.force[i]);
        if (i > begin)
            c.energy += 0.5 * (p.force[i] + p.force[i - 1]) *
                        (p.displacement[i] - p.displacement[i - 1]);
    }
    if (p.displacement[plus] > 0.0) {
        c.displacement_plus = p.displacement[plus];
        c.force_at_plus = p.force[plus];
        c.residual_plus = zero_force(p, plus, end);
    }
    if (p.displacement[minus] < 0.0) {
        c.displacement_minus = p.displacement[minus];
        c.force_at_minus = p.force[minus];
        c.residual_minus = zero_force(p, minus, end);
    }
    c.inner_loop = has_inner_loop(p, begin, end, c.displacement_plus - c.displacement_minus);
    return c;
}

/// Forces of a backbone at a displacement within it: one unless there is a step.
struct Step {
    double before = 0.0, after = 0.0;
};

Step forces_at(const Backbone& b, double x)
{
    const auto& d = b.displacement;
    const auto last = static_cast<std::size_t>(std::upper_bound(d.begin(), d.end(), x) -
                                               d.begin()),
               first = static_cast<std::size_t>(std::lower_bound(d.begin(), d.end(), x) -
                                                d.begin());
    if (first < last) return {b.force[first], b.force[last - 1]};
    const double f = between(d[first - 1], b.force[first - 1], d[first], b.force[first], x);
    return {f, f};
}

/// Takes out the points below the straight line from point `from` to the largest force after
/// it.
void bridge(Backbone& b, std::size_t from)
{
    const auto largest = std::max_element(
        b.force.begin() + static_cast<std::ptrdiff_t>(from) + 1, b.force.end());
    const auto top = static_cast<std::size_t>(largest - b.force.begin());
    const Backbone whole = b;
    b.displacement.resize(from + 1);
    b.force.resize(from + 1);
    for (std::size_t i = from + 1; i < whole.force.size(); ++i) {
        const double line =
            between(whole.displacement[from], whole.force[from], whole.displacement[top],
                    whole.force[top], whole.displacement[i]);
        if (i < top && whole.force[i] < line) continue;
        b.displacement.push_back(whole.displacement[i]);
        b.force.push_back(whole.force[i]);
    }
}

/// A path that is not the solver's may end this share of its width off zero. The solver's ends
/// there exactly.
constexpr double kHome = 0.005;

} // namespace

std::vector<Cycle> cycles(const Path& path)
{
    check_path(path);
    const std::vector<Excursion> parts = excursions(path);
    std::vector<Cycle> found;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const std::size_t begin = parts[k].begin;
        // A cycle of both sides begins with the side that the path went to first.
        if (parts[k].side == parts.front().side && k + 1 < parts.size() &&
            parts[k + 1].side != parts[k].side)
            ++k;
        found.push_back(cycle_between(path, begin, parts[k].end, k + 1 < parts.size()));
        Cycle& c = found.back();
        const double width = c.displacement_plus - c.displacement_minus;
        c.closed = c.closed || std::abs(path.displacement[c.end]) <= kHome * width;
    }
    return found;
}

double amplitude(const Cycle& c)
{
    const bool both = c.displacement_plus > 0.0 && c.displacement_minus < 0.0;
    return (c.displacement_plus - c.displacement_minus) * (both ? 0.5 : 1.0);
}

std::optional<double> equivalent_damping(const Cycle& c)
{
    if (!c.closed || c.inner_loop) return std::nullopt; // half a loop, or several
    const double fd =
        c.force_at_plus * c.displacement_plus + c.force_at_minus * c.displacement_minus;
    if (!(fd > 0.0)) return std::nullopt;
    return c.energy / (std::numbers::pi * fd);
}

std::optional<double> secant_stiffness(const Cycle& c)
{
    const double width = c.displacement_plus - c.displacement_minus;
    if (!(width > 0.0)) return std::nullopt;
    return (c.force_at_plus - c.force_at_minus) / width;
}

Backbone backbone(const Path& path, int direction)
{
    check_path(path);
    if (direction != 1 && direction != -1)
        throw std::invalid_argument("backbone: the direction must be 1 or -1");
    Backbone b{{0.0}, {0.0}};
    double farthest = 0.0;
    bool came_back = false;          // since the farthest point
    std::optional<std::size_t> left; // the point that the path left and has passed again
    for (std::size_t i = 0; i < path.displacement.size(); ++i) {
        const double x = direction * path.displacement[i], f = direction * path.force[i];
        came_back = came_back || x < farthest;
        if (x <= farthest) continue;
        if (came_back) {
            if (left) bridge(b, *left);
            left = b.force.size() - 1;
            const double again = between(direction * path.displacement[i - 1],
                                         direction * path.force[i - 1], x, f, farthest);
            if (again != b.force.back()) { // else the path passes the point that it left
                b.displacement.push_back(farthest);
                b.force.push_back(again);
            }
            came_back = false;
        }
        b.displacement.push_back(x);
        b.force.push_back(f);
        farthest = x;
    }
    if (left) bridge(b, *left);
    return b;
}

Backbone mean(const Backbone& a, const Backbone& b)
{
    const double reach = std::min(a.displacement.back(), b.displacement.back());
    std::vector<double> all;
    for (const Backbone* one : {&a, &b})
        for (const double x : one->displacement)
            if (x <= reach) all.push_back(x);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    Backbone m;
    const auto add = [&](double x, double f) {
        m.displacement.push_back(x);
        m.force.push_back(f);
    };
    for (const double x : all) {
        const Step p = forces_at(a, x), q = forces_at(b, x);
        add(x, 0.5 * (p.before + q.before));
        if (p.after != p.before || q.after != q.before) add(x, 0.5 * (p.after + q.after));
    }
    return m;
}

LimitDisplacement worse(const LimitDisplacement& a, const LimitDisplacement& b)
{
    for (const LimitDisplacement& one : {a, b})
        if (one.reading == Reading::not_defined) return one;
    const bool equal = a.displacement == b.displacement;
    return b.displacement < a.displacement || (equal && b.reading == Reading::observed) ? b : a;
}

} // namespace fragility
