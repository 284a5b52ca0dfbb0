#include "fragility/curve/first_loading.hpp"

#include "fragility/curve/path_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace fragility {
namespace {

/// Displacements and forces in a direction.
Backbone turned_to(const Path& path, int direction)
{
    Backbone b;
    for (const double x : path.displacement) b.displacement.push_back(direction * x);
    for (const double f : path.force) b.force.push_back(direction * f);
    return b;
}

/// FirstLoading::residual of a path that comes from the other side and is out at point `out`,
/// up to point `last` before it turns back. Where the force has no zero up to there, it goes on
/// to it.
double zero_near(const Backbone& path, std::size_t out, std::size_t last)
{
    const auto &x = path.displacement, &f = path.force;
    const double at_zero = between(x[out - 1], f[out - 1], x[out], f[out], 0.0);
    std::size_t i = out;
    if (at_zero > 0.0)
        while (i > 1 && f[i - 1] > 0.0) --i;
    else
        while (i < last && f[i] < 0.0) ++i;
    if (f[i] < 0.0) return f[i] > at_zero ? at_zero * x[i] / (f[i] - at_zero) : 0.0;
    return f[i] == f[i - 1] ? 0.0 : -between(f[i - 1], x[i - 1], f[i], x[i], 0.0);
}

/// The farthest point before the first turn back.
std::size_t first_turn(const Backbone& path, std::size_t out, std::size_t last)
{
    std::size_t i = out;
    while (i < last && path.displacement[i + 1] >= path.displacement[i]) ++i;
    return i;
}

} // namespace

FirstLoading first_loading(const Path& path, int direction, double most)
{
    check_path(path);
    if (direction != 1 && direction != -1)
        throw std::invalid_argument("first loading: the direction must be 1 or -1");
    const Backbone turned = turned_to(path, direction);
    const auto &x = turned.displacement, &f = turned.force;
    const double at_rest = !x.empty() && x.front() == 0.0 ? f.front() : 0.0;
    FirstLoading first;
    bool comes_from_other_side = false, is_first = true;
    for (const Excursion& e : excursions(path)) {
        if (e.side != direction) {
            comes_from_other_side = true;
            continue;
        }
        const std::size_t out = x[e.begin] > 0.0 ? e.begin : e.begin + 1; // already out there
        const bool crosses = comes_from_other_side && out > 0;
        const double at_zero = crosses ? between(x[out - 1], f[out - 1], x[out], f[out], 0.0)
                                       : at_rest,
                     left = std::max(0.0, at_zero - at_rest);
        if (is_first) {
            const std::size_t turn = first_turn(turned, out, e.end);
            first.force = left;
            first.turn = x[turn];
            first.residual = crosses ? zero_near(turned, out, turn)
                                     : residual_at_rest({std::span(x).first(turn + 1),
                                                         std::span(f).first(turn + 1)});
        }
        is_first = false;
        if (left > most) break;
        for (std::size_t i = e.begin; i <= e.end; ++i)
            first.reach = std::max(first.reach, x[i]);
    }
    return first;
}

double residual_at_rest(const Curve& curve)
{
    constexpr double kFirst = 0.05; // of the rise; a free choice
    const auto &x = curve.displacement, &f = curve.force;
    if (x.empty() || x.front() != 0.0 || f.front() == 0.0) return 0.0;
    const double at_rest = f.front(),
                 rise = kFirst * (*std::max_element(f.begin(), f.end()) - at_rest);
    if (!(rise > 0.0)) return 0.0;
    if (at_rest < 0.0)
        for (std::size_t i = 1; i < x.size(); ++i)
            if (f[i] >= 0.0) return -between(f[i - 1], x[i - 1], f[i], x[i], 0.0);
    for (std::size_t i = 1; i < x.size(); ++i)
        if (f[i] - at_rest >= rise) return at_rest * x[i] / (f[i] - at_rest);
    return 0.0;
}

Backbone from_own_zero(const Curve& curve, double residual)
{
    Backbone b{{0.0}, {0.0}};
    for (std::size_t i = 0; i < curve.displacement.size(); ++i) {
        const double x = curve.displacement[i] + residual;
        if (x < 0.0 || (x == 0.0 && curve.force[i] == 0.0)) continue;
        b.displacement.push_back(x);
        b.force.push_back(curve.force[i]);
    }
    return b;
}

double share_within(const Curve& curve, double reach, double share)
{
    const double top = peak(curve).force;
    if (reach <= 0.0 || !(top > 0.0)) return share;
    double reached = 0.0;
    for (std::size_t i = 0; i < curve.displacement.size(); ++i) {
        if (curve.displacement[i] > reach) break;
        reached = std::max(reached, curve.force[i]);
        if (curve.displacement[i] == reach) break; // a step there is of the next cycle
    }
    return reached > 0.0 ? std::min(share, reached / top) : share;
}

} // namespace fragility
