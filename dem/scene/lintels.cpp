#include "dem/scene/lintels.hpp"

#include "dem/scene/bond.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace dem {

namespace {

/// A stretch along the wall [m].
struct Span {
    double x0 = 0.0, x1 = 0.0;
};

bool is_shorter(double a, double b) { return a < b - kSmallestPiece; }

bool overlap(const Span& a, const Span& b)
{
    return is_shorter(a.x0, b.x1) && is_shorter(b.x0, a.x1);
}

/// The openings that end below a course, and those that go through it, from left to right.
struct Openings {
    std::vector<Span> below, through;
};

Openings openings_at(const WallGeometry& wall, int course)
{
    const double z0 = top_of_course(wall, course - 1), z1 = top_of_course(wall, course);
    Openings at;
    for (const Opening& o : wall.openings) {
        const double top = o.z + o.height;
        const Span span{o.x, o.x + o.width};
        if (std::abs(top - z0) < kSmallestPiece) at.below.push_back(span);
        if (!is_shorter(z0, o.z) && !is_shorter(top, z1)) at.through.push_back(span);
    }
    std::ranges::sort(at.below, {}, &Span::x0);
    std::ranges::sort(at.through, {}, &Span::x0);
    return at;
}

/// Whether an opening goes on above, over all its width.
bool goes_on(const Span& below, const std::vector<Span>& through)
{
    double reached = below.x0;
    for (const Span& t : through)
        if (!is_shorter(reached, t.x0)) reached = std::max(reached, t.x1);
    return !is_shorter(reached, below.x1);
}

/// Spans of one lintel each: openings with piers between them that are too narrow for two
/// bearings.
std::vector<Span> spanned_by_one(const WallGeometry& wall, const Openings& at)
{
    const double least = 2.0 * kLeastBearing * wall.lintel_bearing;
    std::vector<Span> spans;
    for (const Span& o : at.below) {
        if (goes_on(o, at.through)) continue;
        const bool narrow = !spans.empty() && is_shorter(o.x0 - spans.back().x1, least);
        const auto parts = [&](const Span& t) { return overlap(t, {spans.back().x1, o.x0}); };
        if (narrow && std::ranges::none_of(at.through, parts))
            spans.back().x1 = o.x1;
        else
            spans.push_back(o);
    }
    return spans;
}

void check_bearings(const Lintel& lintel, const Span& openings,
                    const std::vector<Span>& through)
{
    if (!is_shorter(lintel.x0, openings.x0) || !is_shorter(openings.x1, lintel.x1))
        throw std::invalid_argument("a lintel has no bearing beside its opening; leave room, "
                                    "or write lintel.bearing = 0 m "
                                    "for openings without lintels");
    if (std::ranges::any_of(through, [&](const Span& t) { return overlap(t, openings); }))
        throw std::invalid_argument("an opening cuts the lintel of another one below it");
}

} // namespace

std::vector<Lintel> lintels_of(const WallGeometry& wall, int course)
{
    if (!(wall.lintel_bearing > 0.0)) return {};
    const Openings at = openings_at(wall, course);
    const std::vector<Span> spans = spanned_by_one(wall, at);
    std::vector<Lintel> lintels;
    for (std::size_t k = 0; k < spans.size(); ++k) {
        const Span& s = spans[k];
        Lintel l{std::max(0.0, s.x0 - wall.lintel_bearing),
                 std::min(wall.length, s.x1 + wall.lintel_bearing)};
        if (k > 0) l.x0 = std::max(l.x0, 0.5 * (spans[k - 1].x1 + s.x0));
        if (k + 1 < spans.size()) l.x1 = std::min(l.x1, 0.5 * (s.x1 + spans[k + 1].x0));
        for (const Span& t : at.through) {
            if (!is_shorter(s.x0, t.x1)) l.x0 = std::max(l.x0, t.x1);
            if (!is_shorter(t.x0, s.x1)) l.x1 = std::min(l.x1, t.x0);
        }
        check_bearings(l, s, at.through);
        lintels.push_back(l);
    }
    return lintels;
}

} // namespace dem
