#include "app/study/other_way_remark.hpp"

#include "app/input/units.hpp"
#include "app/input/wall_geometry.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/symmetry.hpp"

#include <cmath>

namespace app {
namespace {

/// "load.targets=-30 mm"
std::string targets_text(const Study& study)
{
    return "load.targets=\"" + format_quantities(study.load.targets, "mm") + "\"";
}

/// The toe is at the right whatever the push.
bool holds_right_toe(const Study& study)
{
    return in_courses(study) && study.wall.base == dem::Base::joint &&
           study.wall.toe == dem::Toe::held;
}

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

} // namespace

const char* way_name(int direction) { return direction > 0 ? "right" : "left"; }

bool has_other_way(const Study& study, const dem::Layout& layout)
{
    return push_way(study).direction != 0 && !dem::is_symmetric(layout);
}

Study turned_round(Study study)
{
    LoadInput& load = study.load;
    if (load.targets.empty()) load.targets = {load.max_displacement};
    for (double& target : load.targets) target = -target;
    return study;
}

std::string other_way_remark(const Study& study, const dem::Layout& layout,
                             const PushedWall& wall)
{
    if (!has_other_way(study, layout)) return "";
    const int direction = push_way(study).direction;
    const std::string first = way_name(direction), other = way_name(-direction);
    if (!wall.other_way)
        return "the wall is not symmetric and was pushed to the " + first + " alone; --set " +
               targets_text(turned_round(study)) + " pushes it to the " + other;
    if (!wall.other_way->no_reading.empty() || !wall.reading.no_reading.empty())
        return "the wall is not symmetric; pushed to the " + other + ": " +
               (wall.other_way->no_reading.empty() ? kilonewtons(*wall.other_way)
                                                   : wall.other_way->no_reading);
    return "the wall is not symmetric: pushed to the " + first + " it carries " +
           kilonewtons(wall.reading) + ", to the " + other + " " +
           compared(*wall.other_way, wall.reading) +
           (holds_right_toe(study) ? ", with the right end of the first course held both times"
                                   : "") +
           "; all else here is of the push to the " + first;
}

} // namespace app
