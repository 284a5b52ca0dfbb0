#include "fragility/cyclic_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace fragility {
namespace {

void check_path(const Path& path)
{
    if (path.displacement.size() != path.force.size())
        throw std::invalid_argument("path: as many displacements as forces are needed");
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::all_of(path.displacement.begin(), path.displacement.end(), finite) ||
        !std::all_of(path.force.begin(), path.force.end(), finite))
        throw std::invalid_argument("path: a displacement or force is not finite");
}

/// Value of y on the line through two points, at x between them.
double between(double x0, double y0, double x1, double y1, double x)
{
    return x1 == x0 ? y1 : y0 + (y1 - y0) * (x - x0) / (x1 - x0);
}

/// Where the force comes to zero after the point `from`, up to the point `last`.
std::optional<double> zero_force(const Path& p, std::size_t from, std::size_t last)
{
    const double sign = p.force[from] > 0.0 ? 1.0 : -1.0;
    if (p.force[from] == 0.0) return p.displacement[from];
    for (std::size_t i = from + 1; i <= last; ++i)
        if (sign * p.force[i] <= 0.0)
            return between(p.force[i - 1], p.displacement[i - 1], p.force[i], p.displacement[i],
                           0.0);
    return std::nullopt;
}

Cycle cycle_between(const Path& p, std::size_t begin, std::size_t end, bool closed)
{
    Cycle c;
    c.begin = begin;
    c.end = end;
    c.closed = closed;
    std::size_t plus = begin, minus = begin;
    for (std::size_t i = begin; i <= end; ++i) {
        if (p.displacement[i] > p.displacement[plus]) plus = i;
        if (p.displacement[i] < p.displacement[minus]) minus = i;
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
    return c;
}

int sign_of(double x) { return (x > 0.0) - (x < 0.0); }

/// Force of a backbone at a displacement within it; the later one at a step.
double force_at(const Backbone& b, double x)
{
    const auto after = std::upper_bound(b.displacement.begin(), b.displacement.end(), x);
    const auto i = static_cast<std::size_t>(after - b.displacement.begin());
    if (i == b.displacement.size()) return b.force.back();
    return between(b.displacement[i - 1], b.force[i - 1], b.displacement[i], b.force[i], x);
}

/// Recorded points are means over a short way: the last of a path that ends at zero lies this share of its width off.
constexpr double kHome = 0.005;

/// A part of the path on one side of zero displacement, with the points between which it leaves and comes back.
struct Excursion {
    int side = 0;
    std::size_t begin = 0, end = 0;
};

std::vector<Excursion> excursions(const Path& path)
{
    std::vector<Excursion> found;
    bool open = false;
    for (std::size_t i = 0; i < path.displacement.size(); ++i) {
        const int side = sign_of(path.displacement[i]);
        if (open && (side == 0 || side == found.back().side)) {
            found.back().end = i;
            open = side != 0;
        } else if (side != 0) {
            found.push_back({side, i > 0 ? i - 1 : 0, i});
            open = true;
        }
    }
    return found;
}

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
    bool came_back = false; // since the farthest point
    for (std::size_t i = 0; i < path.displacement.size(); ++i) {
        const double x = direction * path.displacement[i], f = direction * path.force[i];
        came_back = came_back || x < farthest;
        if (x <= farthest) continue;
        if (came_back) {
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
    return b;
}

Backbone mean(const Backbone& a, const Backbone& b)
{
    const double reach = std::min(a.displacement.back(), b.displacement.back());
    Backbone m;
    for (const Backbone* one : {&a, &b})
        for (const double x : one->displacement)
            if (x <= reach) m.displacement.push_back(x);
    std::sort(m.displacement.begin(), m.displacement.end());
    m.displacement.erase(std::unique(m.displacement.begin(), m.displacement.end()),
                         m.displacement.end());
    for (const double x : m.displacement)
        m.force.push_back(0.5 * (force_at(a, x) + force_at(b, x)));
    return m;
}

} // namespace fragility
