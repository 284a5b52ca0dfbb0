#include "app/push/push_until_told.hpp"

#include "app/output/push_line.hpp"
#include "app/study/other_way.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/stored/stress_text.hpp"
#include "dem/block/model.hpp"

#include <atomic>
#include <cstddef>
#include <iostream>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace app {
namespace {

/// Once the program is told to end, walls that are begun end at their next curve point. While
/// none has a curve, the run ends by Interrupted.
class EarlyEnd {
  public:
    /// @param plan is not used after this
    explicit EarlyEnd(dem::PushPlan& plan)
    {
        plan.decided =
            [this, asked = std::move(plan.decided)](std::span<const dem::CurvePoint> curve) {
                if (curve.size() > 1) any_curve_ = true;
                if (asked && asked(curve)) return true;
                if (!any_curve_ || !interrupted()) return false;
                return cut_ = true;
            };
        plan.progress = [this, told = std::move(plan.progress)](const dem::PushProgress& p) {
            if (!any_curve_) end_if_interrupted();
            told(p);
        };
    }
    /// Whether a wall ended early.
    [[nodiscard]] bool cut() const { return cut_; }

  private:
    std::atomic<bool> any_curve_ = false, cut_ = false;
};

} // namespace

Pushed push_until_told(const PreparedStudy& ready, dem::PushPlan plan,
                       const std::vector<WantedWall>& wanted, int threads, bool quiet)
{
    const Study& study = ready.study;
    const dem::Model model = model_of(ready);
    OtherWay other(study, model, wanted, threads, end_if_interrupted);
    std::vector<PushedWall> walls(wanted.size());
    std::vector<std::string> names;
    for (const WantedWall& w : wanted)
        names.push_back(stress_text(study.load.vertical_stress[w.level]));
    PushLine line(std::move(names), study.solver.accuracy, std::cerr, stderr_progress(quiet),
                  steady_seconds);
    std::mutex mutex;
    std::size_t finished = 0;
    plan.progress = [&](const dem::PushProgress& p) {
        const std::lock_guard lock(mutex);
        line.update(p);
    };
    const EarlyEnd end(plan);
    PushList list;
    list.size = wanted.size();
    list.keeps_begun = true;
    list.wall = [&](std::size_t i) { return wanted[i]; };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        const std::lock_guard lock(mutex);
        walls[i] = std::move(wall);
        ++finished;
        line.end(i);
    };
    push_walls(study, model, plan, list, other.threads_left());
    if (finished != wanted.size() || end.cut()) return {std::move(walls), false};
    try {
        other.add_to(walls);
    } catch (const Interrupted&) {
        return {std::move(walls), true, true};
    }
    line.finish();
    return {std::move(walls), true};
}

} // namespace app
