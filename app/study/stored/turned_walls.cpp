#include "app/study/stored/turned_walls.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/study/pushed/both_ways.hpp"

#include <algorithm>
#include <utility>

namespace app {

StudyWall with_other_way(StudyWall wall, StudyWall other, const ReadingRules& rules)
{
    if (wall.failed || other.failed) {
        const bool by_other = !wall.failed;
        wall.reason = std::string("pushed to the ") +
                      way_name(by_other ? -rules.direction : rules.direction) + ": " +
                      (by_other ? other.reason : wall.reason);
        wall.failed = true;
        wall.reading = not_read(rules, "the wall failed");
        return wall;
    }
    const bool by_other = peak_force(other.reading) < peak_force(wall.reading);
    wall.ways = {std::move(wall.reading), std::move(other.reading)};
    wall.reading = worse_way(wall.ways[0], wall.ways[1]);
    wall.turned_piers = std::move(other.piers);
    wall.turned_spandrels = std::move(other.spandrels);
    wall.solver_error = std::max(wall.solver_error, other.solver_error);
    wall.points_error = std::max(wall.points_error, other.points_error);
    if (by_other) {
        wall.mechanism = other.mechanism;
        wall.forces = std::move(other.forces);
    }
    return wall;
}

namespace {

/// How many walls of a study have the smaller number to the first direction, to the
/// other, and the same to both.
struct WayCount {
    std::size_t own = 0, other = 0, same = 0;
    void add(double a, double b) { ++(a < b ? own : b < a ? other : same); }
};

/// "peak force: left 18, right 2"; empty: it is defined for no wall.
std::string count_text(const std::string& what, const WayCount& n, int direction)
{
    if (n.own + n.other + n.same == 0) return {};
    return what + ": " + way_name(direction) + " " + std::to_string(n.own) + ", " +
           way_name(-direction) + " " + std::to_string(n.other) +
           (n.same > 0 ? ", both " + std::to_string(n.same) : "");
}

/// How often each direction governs.
std::string both_ways_remark(const StudyWalls& walls)
{
    WayCount peak;
    std::vector<WayCount> limits(walls.states.size());
    for (const StudyLevel& level : walls.levels)
        for (const StudyWall& w : level.walls) {
            if (w.ways.size() != 2 || !w.ways[0].peak || !w.ways[1].peak) continue;
            peak.add(peak_force(w.ways[0]), peak_force(w.ways[1]));
            for (std::size_t i = 0; i < limits.size(); ++i) {
                const auto &a = w.ways[0].limits.at(i), &b = w.ways[1].limits.at(i);
                if (is_observed(fragility::worse(a, b)))
                    limits[i].add(a.displacement, b.displacement);
            }
        }
    const int direction = walls.rules.direction;
    std::string text = count_text("peak force", peak, direction);
    for (std::size_t i = 0; i < limits.size(); ++i)
        if (const std::string n = count_text(state_name(walls.states[i]), limits[i], direction);
            !n.empty())
            text += "; " + n;
    return "Each wall was pushed both ways, and the worse one stands for it: the smaller "
           "force, "
           "the limit that is reached first. Walls by the direction that governs: " +
           text + ". Curves and films of single walls are of the push to the " +
           way_name(direction) + ".";
}

} // namespace

std::string other_way_remark(const StudyWalls& walls)
{
    const Study& study = walls.study;
    if (has_turned(walls.head)) return both_ways_remark(walls);
    if (has_layouts(study.geometry) || !has_other_way(study.load, lay_again(study).layout))
        return "";
    const int direction = push_way(study.load).direction;
    return std::string("The wall is not symmetric, and all walls were pushed to the ") +
           way_name(direction) + "; to the " + way_name(-direction) +
           " they may carry less: drystone push " + (walls.shard ? "FILE.h5" : walls.name) +
           " --sample mean" + (study.load.vertical_stress.size() > 1 ? " --level STRESS" : "") +
           (study.load.direction == Direction::both ? "" : " --set load.direction=both") +
           " gives the peaks of both, load.direction = both a study of both.";
}

} // namespace app
