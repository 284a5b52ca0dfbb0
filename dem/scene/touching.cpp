#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

namespace dem {

namespace {

struct Line {
    Point at, along; ///< unit vector
    double length = 0.0;

    Line(Point from, Point to) : at(from)
    {
        length = std::hypot(to.x - from.x, to.z - from.z);
        along = {(to.x - from.x) / length, (to.z - from.z) / length};
    }
    [[nodiscard]] double place(Point p) const
    {
        return (p.x - at.x) * along.x + (p.z - at.z) * along.z;
    }
    [[nodiscard]] double off(Point p) const
    {
        return (p.z - at.z) * along.x - (p.x - at.x) * along.z;
    }
    [[nodiscard]] bool has(Point p) const { return std::abs(off(p)) < kTouching; }
};

/// A piece along a side of one block.
struct Piece {
    Point from, to;             ///< in the direction of the side
    std::vector<Point> between; ///< where it was joined of others
};

/// The common piece of side p of one block and side q of another: both run counter-clockwise,
/// so against each other.
std::optional<Piece> common(const Line& p, Point p_to, const Line& q, Point q_to)
{
    if (p.along.x * q.along.x + p.along.z * q.along.z > 0.0) return std::nullopt;
    const bool on_p = p.has(q.at) && p.has(q_to), on_q = q.has(p.at) && q.has(p_to);
    if (!on_p && !on_q) return std::nullopt;
    const double q0 = p.place(q_to), q1 = p.place(q.at);
    if (std::min(q1, p.length) - std::max(q0, 0.0) <= 0.0) return std::nullopt;
    return Piece{q0 > 0.0 ? q_to : p.at, q1 < p.length ? q.at : p_to, {}};
}

/// The piece of two that follow each other, if it passes all ends of what it is joined of.
std::optional<Piece> joined(const Piece& a, const Piece& b)
{
    Piece whole{a.from, b.to, a.between};
    whole.between.push_back(a.to);
    whole.between.insert(whole.between.end(), b.between.begin(), b.between.end());
    const Line line(whole.from, whole.to);
    if (!std::ranges::all_of(whole.between, [&](Point p) { return line.has(p); }))
        return std::nullopt;
    return whole;
}

/// Joins pieces that continue each other in a straight line.
void join(std::vector<Piece>& pieces)
{
    const auto near = [](Point a, Point b) {
        return std::hypot(a.x - b.x, a.z - b.z) < kTouching;
    };
    for (bool again = true; again;) {
        again = false;
        for (std::size_t i = 0; i < pieces.size() && !again; ++i)
            for (std::size_t j = 0; j < pieces.size() && !again; ++j) {
                if (i == j || !near(pieces[i].to, pieces[j].from)) continue;
                std::optional<Piece> whole = joined(pieces[i], pieces[j]);
                if (!whole) continue;
                pieces[i] = std::move(*whole);
                pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(j));
                again = true;
            }
    }
}

/// @param one outline of `first`, along which the piece runs
Touch touch_of(int first, int second, const Piece& piece)
{
    const Line line(piece.from, piece.to);
    Touch t{first, second, piece.from, piece.to, {line.along.z + 0.0, 0.0 - line.along.x}};
    const bool level = std::abs(t.normal.z) >= std::abs(t.normal.x);
    if (level ? t.normal.z < 0.0 : t.normal.x < 0.0) {
        std::swap(t.a, t.b);
        t.normal = {0.0 - t.normal.x, 0.0 - t.normal.z};
    }
    if (level ? t.to.x < t.from.x : t.to.z < t.from.z) std::swap(t.from, t.to);
    return t;
}

void touches_of(int first, int second, const std::vector<std::vector<Point>>& outlines,
                std::vector<Touch>& all)
{
    const auto &p = outlines[first], &q = outlines[second];
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < q.size(); ++j) {
            const Point p_to = p[(i + 1) % p.size()], q_to = q[(j + 1) % q.size()];
            if (const auto piece = common(Line(p[i], p_to), p_to, Line(q[j], q_to), q_to))
                pieces.push_back(*piece);
        }
    join(pieces);
    for (const Piece& piece : pieces)
        if (Line(piece.from, piece.to).length >= kShortestFace)
            all.push_back(touch_of(first, second, piece));
}

} // namespace

std::vector<Point> corners_of(const Block& b)
{
    if (!b.outline.empty()) return b.outline;
    return {{b.x0, b.z0}, {b.x1, b.z0}, {b.x1, b.z1}, {b.x0, b.z1}};
}

std::vector<std::pair<double, double>> level_sides(const Block& b, double z, bool up)
{
    const auto at_level = [z](Point p) { return std::abs(p.z - z) < kTouching; };
    std::vector<std::pair<double, double>> sides;
    const std::vector<Point> corners = corners_of(b);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point p = corners[i], q = corners[(i + 1) % corners.size()];
        if (at_level(p) && at_level(q) && (up ? q.x < p.x : q.x > p.x))
            sides.emplace_back(std::min(p.x, q.x), std::max(p.x, q.x));
    }
    return sides;
}

bool has_lower_corner(const Block& b, bool left)
{
    return std::ranges::any_of(corners_of(b), [&](Point p) {
        return std::abs(p.x - (left ? b.x0 : b.x1)) < kTouching &&
               std::abs(p.z - b.z0) < kTouching;
    });
}

std::vector<Touch> touching(const std::vector<Block>& blocks)
{
    std::vector<std::vector<Point>> outlines;
    for (const Block& b : blocks) outlines.push_back(corners_of(b));
    std::vector<int> by_x(blocks.size());
    std::iota(by_x.begin(), by_x.end(), 0);
    std::ranges::stable_sort(by_x, {}, [&](int b) { return blocks[b].x0; });
    std::vector<Touch> all;
    for (std::size_t i = 0; i < by_x.size(); ++i) {
        const Block& a = blocks[by_x[i]];
        for (std::size_t j = i + 1; j < by_x.size(); ++j) {
            const Block& b = blocks[by_x[j]];
            if (b.x0 > a.x1 + kTouching) break;
            if (b.z0 > a.z1 + kTouching || b.z1 < a.z0 - kTouching) continue;
            touches_of(by_x[i], by_x[j], outlines, all);
        }
    }
    return all;
}

} // namespace dem
