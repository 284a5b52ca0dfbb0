#include "app/study/other_way.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/push_walls.hpp"
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

} // namespace app
