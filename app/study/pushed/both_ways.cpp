#include "app/study/pushed/both_ways.hpp"

#include "app/input/study/load_input.hpp"
#include "app/input/study/study_file.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/scene/symmetry.hpp"

#include <cmath>

namespace app {
namespace {

std::string kilonewtons(const WallReading& wall)
{
    return fixed(peak_force(wall) * 1e-3, 1) + " kN";
}

/// "71.6 kN (39 % less)"
std::string compared(const WallReading& other, const WallReading& first)
{
    if (!(peak_force(first) > 0.0)) return kilonewtons(other);
    const double change = 100.0 * (peak_force(other) / peak_force(first) - 1.0);
    return kilonewtons(other) + " (" + fixed(std::abs(change), 0) + " % " +
           (change < 0.0 ? "less" : "more") + ")";
}

bool both_are_read(const PushedWall& wall)
{
    const PushedWall* const other = other_way_of(wall);
    return other != nullptr && other->reading.peak && wall.reading.peak;
}

} // namespace

std::string turned_word(const LoadInput& load)
{
    return load.direction == Direction::left ? "right" : "left";
}

bool has_cracks_of_one_way(const StudyFile& source)
{
    const Entry* const where = find_entry(source, "unit.cracks_where");
    return where != nullptr &&
           (trimmed(where->value) == "toe" || trimmed(where->value) == "needed");
}

bool has_other_way(const LoadInput& load, const dem::Layout& layout)
{
    return push_way(load).direction != 0 && !dem::is_symmetric(layout);
}

const char* way_name(int direction) { return direction > 0 ? "right" : "left"; }

const PushedWall* other_way_of(const PushedWall& wall)
{
    return wall.other_way.empty() ? nullptr : &wall.other_way.front();
}

bool pushes_both_ways(const GeometryInput& geometry, const LoadInput& load,
                      const StudyFile& source, const dem::Layout& layout)
{
    if (load.direction != Direction::both || !is_given(source, "load.direction") ||
        push_way(load).direction == 0)
        return false;
    if (!has_layouts(geometry) && dem::is_symmetric(layout)) return false;
    refuse_cracks_of_one_way(source);
    return true;
}

void refuse_cracks_of_one_way(const StudyFile& source)
{
    if (has_cracks_of_one_way(source))
        throw error_at(source, "load.direction",
                       "unit.cracks_where = toe and needed place cracks for one direction; "
                       "write right or left, or boxes in place of toe and needed");
}

WallReading worse_way(const WallReading& own, const WallReading& other)
{
    if (!own.peak || !other.peak) return own;
    WallReading worse = worse_of(own, other);
    const bool by_other = peak_force(other) < peak_force(own);
    worse.mode = by_other ? other.mode : own.mode;
    worse.mode_so_far = by_other ? other.mode_so_far : own.mode_so_far;
    worse.slid = by_other ? other.slid : own.slid;
    return worse;
}

WallReading worse_way(const PushedWall& wall)
{
    const PushedWall* const other = other_way_of(wall);
    return other == nullptr ? wall.reading : worse_way(wall.reading, other->reading);
}

const PushedWall& worse_push(const PushedWall& wall, std::size_t state)
{
    if (!both_are_read(wall)) return wall;
    const PushedWall& other = wall.other_way.front();
    const fragility::LimitDisplacement& own = wall.reading.limits.at(state);
    return same_limit(own, fragility::worse(own, other.reading.limits.at(state))) ? wall
                                                                                  : other;
}

std::string worse_way_name(int direction, const PushedWall& wall, std::size_t state)
{
    if (both_are_read(wall) && same_limit(wall.reading.limits.at(state),
                                          wall.other_way.front().reading.limits.at(state)))
        return "both";
    return way_name(&worse_push(wall, state) == &wall ? direction : -direction);
}

namespace {

/// The remark on a push to and fro.
std::string two_sides_remark(const PushedWall& wall)
{
    const auto& sides = wall.reading.backbones;
    if (sides.empty()) return "";
    const WallReading& right = sides.at(static_cast<std::size_t>(fragility::Side::right));
    const WallReading& left = sides.at(static_cast<std::size_t>(fragility::Side::left));
    if (!right.peak || !left.peak) return "";
    return "the wall is not symmetric: to the right it carries " + kilonewtons(right) +
           ", to the left " + compared(left, right) +
           "; fragility.backbone says which of both the other numbers are of";
}

} // namespace

std::string other_way_remark(const LoadInput& load, const StudyFile& source,
                             const dem::Layout& layout, const PushedWall& wall)
{
    if (push_way(load).direction == 0 && !dem::is_symmetric(layout))
        return two_sides_remark(wall);
    if (!has_other_way(load, layout)) return "";
    const int direction = push_way(load).direction;
    const std::string first = way_name(direction), other = way_name(-direction);
    const PushedWall* const turned = other_way_of(wall);
    if (turned == nullptr)
        return "the wall is not symmetric and was pushed to the " + first +
               " alone; --set load.direction=" +
               (has_cracks_of_one_way(source) ? turned_word(load) + " pushes it to the " + other
                                              : "both pushes it to the " + other + " too");
    if (!both_are_read(wall))
        return "the wall is not symmetric; pushed to the " + other + ": " +
               (turned->reading.no_reading.empty() ? kilonewtons(turned->reading)
                                                   : turned->reading.no_reading);
    return "the wall is not symmetric: pushed to the " + first + " it carries " +
           kilonewtons(wall.reading) + ", to the " + other + " " +
           compared(turned->reading, wall.reading) +
           "; limit states are those of the direction that reaches them first";
}

} // namespace app
