#include "dem/scene/mechanism/points_excess.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace dem {

namespace {

/// Gap along a face, straight between its points.
struct Gap {
    std::vector<double> at, wide; ///< place along the face [m]; opening [m]
    explicit Gap(const FaceState& face)
    {
        const Point& from = face.contacts.front().at;
        for (const ContactState& c : face.contacts) {
            at.push_back(std::hypot(c.at.x - from.x, c.at.z - from.z));
            wide.push_back(c.opening);
        }
    }
};

/// Closure along a face.
struct ClosedPart {
    double area = 0.0;  ///< integral of the closure [m2], <= 0
    double first = 0.0; ///< the same times the place [m3]
    [[nodiscard]] double centre() const { return first / area; }
};

/// Closure of a gap that is wider by `more`.
ClosedPart closure_of(const Gap& gap, double more)
{
    ClosedPart sum;
    for (std::size_t i = 0; i + 1 < gap.at.size(); ++i) {
        double a = gap.at[i], b = gap.at[i + 1], ga = gap.wide[i] + more,
               gb = gap.wide[i + 1] + more;
        if (ga >= 0.0 && gb >= 0.0) continue;
        if (ga > 0.0) {
            a += ga / (ga - gb) * (b - a);
            ga = 0.0;
        } else if (gb > 0.0) {
            b = a + ga / (ga - gb) * (b - a);
            gb = 0.0;
        }
        const double length = b - a, area = 0.5 * length * (ga + gb);
        sum.area += area;
        sum.first += area * a + length * length * (ga + 2.0 * gb) / 6.0;
    }
    return sum;
}

/// The closure along the face that has the area of the points' own, the gap shifted as a whole.
ClosedPart closure_with(const Gap& gap, double area)
{
    const auto [least, most] = std::ranges::minmax(gap.wide);
    double tight = 2.0 * least - most, loose = -least; // with and without enough closure
    while (closure_of(gap, tight).area > area) tight *= 2.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (tight + loose);
        (closure_of(gap, middle).area > area ? loose : tight) = middle;
    }
    return closure_of(gap, tight);
}

/// Opening per length of the straight line that fits the gap best [-].
double slope_of(const FaceState& face)
{
    const Gap gap(face);
    double sum = 0.0, x = 0.0, u = 0.0, xx = 0.0, xu = 0.0;
    for (std::size_t i = 0; i < gap.at.size(); ++i) {
        const double w = face.contacts[i].area;
        sum += w;
        x += w * gap.at[i];
        u += w * gap.wide[i];
        xx += w * gap.at[i] * gap.at[i];
        xu += w * gap.at[i] * gap.wide[i];
    }
    return (sum * xu - x * u) / (sum * xx - x * x);
}

bool is_partly_open(const FaceState& face)
{
    const auto& c = face.contacts;
    const auto pulls = [](const ContactState& k) { return k.sigma > 0.0 || k.crushed > 0.0; };
    const auto presses = [](const ContactState& k) { return k.sigma < 0.0; };
    return std::ranges::none_of(c, pulls) && std::ranges::any_of(c, presses) &&
           !std::ranges::all_of(c, presses);
}

/// Moment by which the points of a face hold it more than a joint along it [N m]: its work is
/// that on a rotation that opens the face at its last point.
double excess_moment(const FaceState& face)
{
    const Gap gap(face);
    double area = 0.0, closed = 0.0, first = 0.0, thrust = 0.0;
    for (std::size_t i = 0; i < gap.at.size(); ++i) {
        const ContactState& c = face.contacts[i];
        const double closure = std::min(0.0, c.opening) * c.area;
        area += c.area;
        closed += closure;
        first += closure * gap.at[i];
        thrust -= c.sigma * c.area;
    }
    const double length = gap.at.back();
    if (!(closed < 0.0) || !(length > 0.0)) return 0.0;
    thrust *= std::hypot(face.acting.x, face.acting.z); // the share that is in contact
    const ClosedPart along = closure_with(gap, closed * length / area);
    return thrust * (along.centre() - first / closed);
}

} // namespace

double points_excess(const Snapshot& wall)
{
    if (wall.displacement == 0.0) return 0.0;
    double work = 0.0;
    for (const FaceState& face : wall.faces)
        if (is_partly_open(face)) work += excess_moment(face) * slope_of(face);
    return work / wall.displacement;
}

} // namespace dem
