#include "app/study/pushed/wall_openings.hpp"

#include "app/input/study/study.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

using Piece = std::pair<double, double>; ///< from x to x

/// Where the line at height z crosses an outline, as the extent of the outline along it; empty
/// where it does not.
Piece crossed(const std::vector<dem::Point>& outline, double z)
{
    Piece piece{0.0, 0.0};
    bool any = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const dem::Point a = outline[i], b = outline[(i + 1) % outline.size()];
        if ((a.z > z) == (b.z > z)) continue;
        const double x = a.x + (b.x - a.x) * (z - a.z) / (b.z - a.z);
        piece = any ? Piece{std::min(piece.first, x), std::max(piece.second, x)} : Piece{x, x};
        any = true;
    }
    return piece;
}

/// Gaps above each other.
struct Shaft {
    std::vector<Gap> gaps;
    double bottom = 0.0, top = 0.0; ///< [m]

    [[nodiscard]] dem::Opening opening() const
    {
        double from = 0.0, to = 0.0;
        for (const Gap& g : gaps) {
            from += g.from / static_cast<double>(gaps.size());
            to += g.to / static_cast<double>(gaps.size());
        }
        return {from, bottom, to - from, top - bottom};
    }
};

bool lies_above(const Gap& upper, const Gap& lower)
{
    const double common = std::min(upper.to, lower.to) - std::max(upper.from, lower.from);
    return common > 0.5 * std::min(upper.width(), lower.width());
}

/// Whether one gap goes on as the other, and not as one that joins it with another.
bool is_alike(const Gap& a, const Gap& b)
{
    const double common = std::min(a.to, b.to) - std::max(a.from, b.from);
    return common > 0.5 * std::max(a.width(), b.width());
}

/// The height between `within` and `beyond` at which a gap, found at `within`, ends; `beyond`
/// where it goes on to there.
double end_of(const std::vector<dem::DrawnUnit>& units, const Gap& gap, double within,
              double beyond, double least)
{
    constexpr int kHalvings = 40; // of a two hundredth of the height of the wall
    for (int i = 0; i < kHalvings; ++i) {
        const double z = 0.5 * (within + beyond);
        const bool goes_on = std::ranges::any_of(
            gaps_at(units, z, least), [&](const Gap& g) { return is_alike(g, gap); });
        (goes_on ? within : beyond) = z;
    }
    return beyond;
}

std::vector<dem::Opening> openings_of_drawing(const Masonry& masonry)
{
    constexpr int kHeights = 200,
                  kFewest = 4; // levels looked at, and those that an opening has
    const std::vector<dem::DrawnUnit>& units = masonry.geometry.units;
    const double height = wall_height(masonry), rise = height / kHeights,
                 least = least_opening(masonry);
    std::vector<Shaft> open, closed;
    const auto close_all_open = [&](double within, double beyond) {
        for (Shaft& s : open) {
            s.top = end_of(units, s.gaps.back(), within, beyond, least);
            closed.push_back(std::move(s));
        }
    };
    double below = 0.0; // the level before, or the ground
    for (int i = 0; i < kHeights; ++i) {
        const double z = rise * (i + 0.5);
        std::vector<Shaft> next;
        for (const Gap& gap : gaps_at(units, z, least)) {
            const auto lower = std::ranges::find_if(
                open, [&](const Shaft& s) { return lies_above(gap, s.gaps.back()); });
            if (lower == open.end()) {
                next.push_back({{gap}, end_of(units, gap, z, below, least), 0.0});
                continue;
            }
            lower->gaps.push_back(gap);
            next.push_back(std::move(*lower));
            open.erase(lower);
        }
        close_all_open(below, z);
        open = std::move(next);
        below = z;
    }
    close_all_open(below, height);
    std::vector<dem::Opening> openings;
    for (const Shaft& s : closed)
        if (s.gaps.size() >= kFewest) openings.push_back(s.opening());
    return openings;
}

} // namespace

std::vector<Gap> gaps_at(const std::vector<dem::DrawnUnit>& units, double z, double least)
{
    std::vector<Piece> pieces;
    for (const dem::DrawnUnit& u : units)
        if (const Piece p = crossed(u.outline, z); p.second > p.first) pieces.push_back(p);
    std::ranges::sort(pieces);
    std::vector<Gap> gaps;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const Gap gap{pieces[i - 1].second, pieces[i].first};
        if (gap.width() > least) gaps.push_back(gap);
        pieces[i].second = std::max(pieces[i].second, pieces[i - 1].second);
    }
    return gaps;
}

double least_opening(const Masonry& masonry)
{
    constexpr double kOpening = 0.05, kWindow = 0.3; // of the length of the wall, [m]
    return std::min(kOpening * wall_length(masonry), kWindow);
}

std::vector<dem::Opening> wall_openings(const Masonry& masonry)
{
    if (!is_drawn(masonry.geometry)) return masonry.wall.openings;
    return masonry.geometry.rubble ? std::vector<dem::Opening>() : openings_of_drawing(masonry);
}

} // namespace app
