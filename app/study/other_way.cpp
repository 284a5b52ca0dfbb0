#include "app/study/other_way.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/random_layouts.hpp"
#include "app/study/interrupt.hpp"
#include "app/study/push_walls.hpp"
#include "dem/block/contact_count.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace app {
namespace {

/// Steps that a push is likely to take: those of its fastest drive, and more the less error it
/// bears. The walls of the paper take 1.5 to 3 times those of the fastest at 1 %, 7 to 26 times
/// at 0.1 %.
double expected_steps(const Study& study)
{
    constexpr double kTwice = 0.015; // accuracy that takes twice the steps of the fastest drive
    const dem::SolverOptions& o = study.solver;
    const double slower = o.unbalance_limit > 0.0 ? kTwice / o.accuracy : 0.0;
    return 1e3 * push_way(study).length * o.steps_per_mm * (1.0 + slower);
}

/// Whether a push takes no longer than half a minute of one core.
bool is_cheap(const Study& study, const dem::Layout& layout)
{
    constexpr double kMost = 1e9; // contact updates
    if (!study.cracks.where.empty()) return false;
    const std::size_t contacts = dem::contact_count(layout, study.discretisation);
    return expected_steps(study) * static_cast<double>(contacts) < kMost;
}

bool goes_both_ways(const Study& study, const dem::Layout& layout)
{
    if (study.load.direction != Direction::both || !has_other_way(study, layout)) return false;
    if (!is_given(study.source, "load.direction")) return is_cheap(study, layout);
    refuse_cracks_of_one_way(study);
    return true;
}

std::vector<PushedWall> push_other_way(const Study& study, const dem::Model& model,
                                       const std::vector<WantedWall>& wanted, int threads,
                                       const std::function<void()>& look)
{
    const Study other = turned_round(study);
    dem::PushPlan plan = push_plan(other);
    plan.snapshot_every = 0.0;
    std::optional<dem::Model> own; // a toe that is held changes sides
    if (other.wall != study.wall) own = model_of(lay_again(other));
    plan.progress = [&](double, double, double) {
        if (interrupted()) throw Interrupted();
        if (look) look();
    };
    std::vector<PushedWall> walls(wanted.size());
    PushList list;
    list.size = wanted.size();
    list.wall = [&](std::size_t i) { return wanted[i]; };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        walls[i] = std::move(wall);
    };
    push_walls(other, own ? *own : model, plan, list, threads);
    return walls;
}

} // namespace

OtherWay::OtherWay(const Study& study, const dem::Model& model,
                   const std::vector<WantedWall>& wanted, int threads,
                   std::function<void()> look)
    : threads_left_(threads)
{
    if (!goes_both_ways(study, model.layout)) return;
    const int half = std::max(1, threads / 2);
    threads_left_ = std::max(1, threads - half);
    walls_ = std::async(threads > 1 ? std::launch::async : std::launch::deferred,
                        [&study, &model, &wanted, half, look = std::move(look)] {
                            return push_other_way(study, model, wanted, half, look);
                        });
}

void OtherWay::add_to(std::vector<PushedWall>& walls)
{
    if (!walls_.valid()) return;
    std::vector<PushedWall> others = walls_.get();
    for (std::size_t i = 0; i < walls.size(); ++i)
        walls[i].other_way.push_back(std::move(others[i]));
}

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
    wall.solver_error = std::max(wall.solver_error, other.solver_error);
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
    if (has_layouts(study) || !has_other_way(study, lay_again(study).layout)) return "";
    const int direction = push_way(study).direction;
    return std::string("The wall is not symmetric, and all walls were pushed to the ") +
           way_name(direction) + "; to the " + way_name(-direction) +
           " they may carry less: drystone push " + (walls.shard ? "FILE.h5" : walls.name) +
           " --sample mean" + (study.load.vertical_stress.size() > 1 ? " --level STRESS" : "") +
           (study.load.direction == Direction::both ? "" : " --set load.direction=both") +
           " gives the peaks of both, load.direction = both a study of both.";
}

} // namespace app
