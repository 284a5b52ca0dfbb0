#include "app/study/other_way.hpp"

#include "app/input/random_layouts.hpp"
#include "app/input/wall_geometry.hpp"
#include "app/study/interrupt.hpp"
#include "app/study/push_walls.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/block/contact_count.hpp"
#include "dem/scene/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// The value of load.direction that turns the push round.
std::string turned_word(const Study& study)
{
    return turned_round(study).load.direction == Direction::left ? "left" : "right";
}

/// Whether cracks were placed for one direction.
bool has_cracks_of_one_way(const Study& study)
{
    const Entry* const where = find_entry(study.source, "unit.cracks_where");
    return where != nullptr &&
           (trimmed(where->value) == "toe" || trimmed(where->value) == "needed");
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
    if (has_cracks_of_one_way(study))
        throw error_at(study.source, "load.direction",
                       "unit.cracks_where = toe and needed place cracks for one direction; "
                       "write right or left, or boxes in place of toe and needed");
    return true;
}

std::vector<PushedWall> push_other_way(const Study& study, const dem::Model& model,
                                       const std::vector<WantedWall>& wanted, int threads,
                                       const OtherWayWatch& watch)
{
    const Study other = turned_round(study);
    dem::PushPlan plan = push_plan(other);
    plan.snapshot_every = 0.0;
    if (watch.prepare) watch.prepare(other, plan);
    plan.progress = [&](double, double, double) {
        if (interrupted()) throw Interrupted();
        if (watch.look) watch.look();
    };
    std::vector<PushedWall> walls(wanted.size());
    PushList list;
    list.size = wanted.size();
    list.wall = [&](std::size_t i) { return wanted[i]; };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        walls[i] = std::move(wall);
    };
    std::optional<dem::Model> own; // a toe that is held changes sides
    if (other.wall != study.wall) own = model_of(other);
    push_walls(other, own ? *own : model, plan, list, threads);
    return walls;
}

} // namespace

bool has_other_way(const Study& study, const dem::Layout& layout)
{
    return push_way(study).direction != 0 && !dem::is_symmetric(layout);
}

const char* way_name(int direction) { return direction > 0 ? "right" : "left"; }

const PushedWall* other_way_of(const PushedWall& wall)
{
    return wall.other_way.empty() ? nullptr : &wall.other_way.front();
}

namespace {

bool both_are_read(const PushedWall& wall)
{
    const PushedWall* const other = other_way_of(wall);
    return other != nullptr && other->reading.peak && wall.reading.peak;
}

} // namespace

WallReading worse_way(const PushedWall& wall)
{
    if (!both_are_read(wall)) return wall.reading;
    const WallReading& other = wall.other_way.front().reading;
    WallReading worse = worse_of(wall.reading, other);
    const bool by_other = peak_force(other) < peak_force(wall.reading);
    worse.mode = by_other ? other.mode : wall.reading.mode;
    worse.slid = by_other ? other.slid : wall.reading.slid;
    return worse;
}

std::string worse_way_name(const Study& study, const PushedWall& wall, std::size_t state)
{
    const int direction = push_way(study).direction;
    if (!both_are_read(wall)) return way_name(direction);
    const fragility::LimitDisplacement &own = wall.reading.limits.at(state),
                                       &other = wall.other_way.front().reading.limits.at(state),
                                       worse = fragility::worse(own, other);
    const auto is_worse = [&](const fragility::LimitDisplacement& d) {
        return d.displacement == worse.displacement && d.reading == worse.reading;
    };
    if (is_worse(own) && is_worse(other)) return "both";
    return way_name(is_worse(own) ? direction : -direction);
}

OtherWay::OtherWay(const Study& study, const dem::Model& model,
                   const std::vector<WantedWall>& wanted, int threads, OtherWayWatch watch)
    : threads_left_(threads)
{
    if (!goes_both_ways(study, model.layout)) return;
    const int half = std::max(1, threads / 2);
    threads_left_ = std::max(1, threads - half);
    walls_ = std::async(threads > 1 ? std::launch::async : std::launch::deferred,
                        [&study, &model, &wanted, half, watch = std::move(watch)] {
                            return push_other_way(study, model, wanted, half, watch);
                        });
}

void OtherWay::add_to(std::vector<PushedWall>& walls)
{
    if (!walls_.valid()) return;
    std::vector<PushedWall> others = walls_.get();
    for (std::size_t i = 0; i < walls.size(); ++i)
        walls[i].other_way.push_back(std::move(others[i]));
}

std::string other_way_remark(const Study& study, const dem::Layout& layout,
                             const PushedWall& wall)
{
    if (!has_other_way(study, layout)) return "";
    const int direction = push_way(study).direction;
    const std::string first = way_name(direction), other = way_name(-direction);
    const PushedWall* const turned = other_way_of(wall);
    if (turned == nullptr)
        return "the wall is not symmetric and was pushed to the " + first +
               " alone; --set load.direction=" +
               (has_cracks_of_one_way(study) ? turned_word(study) + " pushes it to the " + other
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

std::string other_way_remark(const StudyWalls& walls)
{
    const Study& study = walls.study;
    if (has_layouts(study) || !has_other_way(study, layout_of(study))) return "";
    const int direction = push_way(study).direction;
    return std::string("The wall is not symmetric, and all walls were pushed to the ") +
           way_name(direction) + "; to the " + way_name(-direction) +
           " they may carry less: drystone push " + (walls.shard ? "FILE.h5" : walls.name) +
           " --sample mean" + (study.load.vertical_stress.size() > 1 ? " --level STRESS" : "") +
           (study.load.direction == Direction::both ? "" : " --set load.direction=both") +
           " gives the peaks of both, load.direction = " + turned_word(study) +
           " a study of the other.";
}

} // namespace app
