#include "app/study/pier_remark.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/input/wall_geometry.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace app {
namespace {

/// Share of the length of the wall. A gap that is narrower is a joint, not an opening.
constexpr double kOpening = 0.05;

/// The side of a pier leans by less than this [m/m], over more than a third of the height of
/// the opening. The inside of a half circle does so up to a tenth of its height, or to a fifth
/// where it is made of straight stones.
constexpr double kBatter = 0.1;

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

/// The widest opening that the stones leave at height z; nothing where none is wider than
/// `least`.
std::optional<Piece> opening_at(const std::vector<dem::DrawnUnit>& units, double z,
                                double least)
{
    std::vector<Piece> pieces;
    for (const dem::DrawnUnit& u : units)
        if (const Piece p = crossed(u.outline, z); p.second > p.first) pieces.push_back(p);
    std::ranges::sort(pieces);
    std::optional<Piece> widest;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const Piece gap{pieces[i - 1].second, pieces[i].first};
        if (gap.second - gap.first > least) {
            least = gap.second - gap.first;
            widest = gap;
        }
        pieces[i].second = std::max(pieces[i].second, pieces[i - 1].second);
    }
    return widest;
}

/// "ntc and ec8"
std::string codes_of(const Study& study)
{
    std::string codes;
    for (const std::string_view set : reading_rules(study).sets)
        if (set == "ntc" || set == "ec8")
            codes += (codes.empty() ? "" : " and ") + std::string(set);
    return codes;
}

} // namespace

bool has_piers(const Study& study)
{
    if (!study.geometry.openings.empty()) return true;
    if (!is_drawn(study) || study.geometry.rubble) return false;
    constexpr int kHeights = 40;
    const double rise = wall_height(study) / kHeights, least = kOpening * wall_length(study);
    std::optional<Piece> below;
    int open = 0, upright = 0;
    for (int i = 0; i < kHeights; ++i) {
        const auto here = opening_at(study.geometry.units, rise * (i + 0.5), least);
        open += here.has_value();
        upright += here && below &&
                   std::min(std::abs(here->first - below->first),
                            std::abs(here->second - below->second)) < kBatter * rise;
        below = here;
    }
    return 3 * upright > open;
}

std::string pier_remark(const Study& study)
{
    const std::string codes = codes_of(study);
    if (codes.empty() || !has_piers(study)) return {};
    return "the drift limits of " + codes +
           " are those of one pier; this wall has several, and one drift, over " +
           fixed(study.load.height, 2) +
           " m, and one mode stand for all of them: check each pier by its own height and mode";
}

std::string pier_sentence(const Study& study)
{
    const std::string remark = pier_remark(study);
    return remark.empty() ? remark : "T" + remark.substr(1) + ".";
}

} // namespace app
