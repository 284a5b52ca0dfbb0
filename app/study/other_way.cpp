#include "app/study/other_way.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/push_cost.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/push_walls.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace app {
namespace {

bool goes_both_ways(const Study& study, const dem::Layout& layout)
{
    if (study.load.direction != Direction::both || !has_other_way(study.load, layout))
        return false;
    constexpr double kMost = 1e9; // contact updates: half a minute of one core
    if (!is_given(study.source, "load.direction"))
        return study.cracks.where.empty() &&
               expected_updates(study.load, study.discretisation, study.solver, layout) < kMost;
    refuse_cracks_of_one_way(study.source);
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
    plan.progress = [&](const dem::PushProgress&) {
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
