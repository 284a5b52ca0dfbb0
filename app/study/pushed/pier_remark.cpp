#include "app/study/pushed/pier_remark.hpp"

#include "app/input/study/masonry.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/reading/wall_reading.hpp"
#include "app/study/pushed/wall_openings.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace app {
namespace {

/// The side of a pier leans by less than this [m/m], over more than a third of the height of
/// the opening. The inside of a half circle does so up to a tenth of its height, or to a fifth
/// where it is made of straight stones.
constexpr double kBatter = 0.1;

/// The widest opening that the stones leave at height z; nothing where none is wider than
/// `least`.
std::optional<Gap> opening_at(const std::vector<dem::DrawnUnit>& units, double z, double least)
{
    const std::vector<Gap> gaps = gaps_at(units, z, least);
    const auto widest = std::ranges::max_element(gaps, {}, &Gap::width);
    return widest == gaps.end() ? std::nullopt : std::optional(*widest);
}

/// "ntc and ec8"
std::string codes_of(const ReadingRules& rules)
{
    std::string codes;
    for (const fragility::Code& set : rules.sets)
        if (limits_drift(set)) codes += (codes.empty() ? "" : " and ") + set.name;
    return codes;
}

} // namespace

bool has_piers(const Masonry& masonry)
{
    if (!masonry.geometry.openings.empty()) return true;
    if (!is_drawn(masonry.geometry) || masonry.geometry.rubble) return false;
    constexpr int kHeights = 40;
    const double rise = wall_height(masonry) / kHeights, least = least_opening(masonry);
    std::optional<Gap> below;
    int open = 0, upright = 0;
    for (int i = 0; i < kHeights; ++i) {
        const auto here = opening_at(masonry.geometry.units, rise * (i + 0.5), least);
        open += here.has_value();
        upright += here && below &&
                   std::min(std::abs(here->from - below->from),
                            std::abs(here->to - below->to)) < kBatter * rise;
        below = here;
    }
    return 3 * upright > open;
}

std::string pier_remark(const ReadingRules& rules, const Masonry& masonry)
{
    const std::string codes = codes_of(rules);
    if (codes.empty() || !has_piers(masonry)) return {};
    return "the drift limits of " + codes +
           " are those of one pier; this wall has several, and one drift, over " +
           fixed(rules.height, 2) +
           " m, and one mode stand for all of them: check each pier by its own height and mode";
}

std::string pier_sentence(const ReadingRules& rules, const Masonry& masonry)
{
    const std::string remark = pier_remark(rules, masonry);
    return remark.empty() ? remark : "T" + remark.substr(1) + ".";
}

} // namespace app
