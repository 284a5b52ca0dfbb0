#include "app/push/push_until_told.hpp"

#include "app/output/progress.hpp"
#include "app/study/other_way.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/text/number_text.hpp"
#include "dem/block/model.hpp"

#include <algorithm>
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
        plan.progress = [this, told = std::move(plan.progress)](
                            double done, double displacement, double force) {
            if (!any_curve_) end_if_interrupted();
            told(done, displacement, force);
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
    Progress line(std::cerr, stderr_progress(quiet), steady_seconds);
    std::mutex mutex;
    std::size_t finished = 0;
    plan.progress = [&](double done, double displacement, double force) {
        const std::lock_guard lock(mutex);
        line.update(std::min(1.0, (static_cast<double>(finished) + done) /
                                      static_cast<double>(wanted.size())),
                    fixed(force * 1e-3, 1) + " kN at " + fixed(displacement * 1e3, 1) + " mm");
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
    };
    push_walls(study, model, plan, list, other.threads_left());
    if (finished != wanted.size() || end.cut()) return {std::move(walls), false};
    try {
        other.add_to(walls);
    } catch (const Interrupted&) {
        return {std::move(walls), true, true};
    }
    line.finish("");
    return {std::move(walls), true};
}

} // namespace app
