#include "app/study/push_walls.hpp"

#include "app/study/interrupt.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/ensemble.hpp"

#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace app {
namespace {

/// What one call of push_walls shares between its threads.
class Running {
  public:
    Running(const Study& study, const dem::Model& model, const PushList& list)
        : study_(study), model_(model), list_(list)
    {
    }

    /// Nothing where the draw makes no wall: it has been delivered then.
    std::optional<dem::WallMaterials> start(std::size_t i)
    {
        if (interrupted()) throw Interrupted();
        std::optional<WantedWall> wanted = list_.wall(i);
        if (!wanted) return {};
        const int level = wanted->level;
        try {
            dem::WallMaterials materials =
                wall_materials(study_, model_.layout, level, wanted->draw);
            dem::check(model_, materials);
            const std::lock_guard lock(mutex_);
            started_.emplace(i, std::move(*wanted));
            return materials;
        } catch (const std::invalid_argument& bad) {
            const std::lock_guard lock(mutex_);
            list_.done(i, wanted->draw, no_wall(study_, level, bad.what()));
            return {};
        }
    }

    void finish(std::size_t i, dem::PushResult&& result)
    {
        const std::lock_guard lock(mutex_);
        const WantedWall wanted = std::move(started_.extract(i).mapped());
        list_.done(i, wanted.draw, read_wall(study_, wanted.level, std::move(result)));
        if (interrupted()) throw Interrupted();
    }

  private:
    const Study& study_;
    const dem::Model& model_;
    const PushList& list_;
    std::mutex mutex_;
    std::map<std::size_t, WantedWall> started_;
};

} // namespace

void push_walls(const Study& study, const dem::Model& model, const dem::PushPlan& plan,
                const PushList& list, int threads)
{
    Running running(study, model, list);
    dem::Ensemble ensemble;
    ensemble.size = list.size;
    ensemble.wall = [&](std::size_t i) { return running.start(i); };
    ensemble.done = [&](std::size_t i, dem::PushResult&& result) {
        running.finish(i, std::move(result));
    };
    ensemble.open = list.open;
    dem::Workers workers;
    workers.threads = threads;
    workers.scalar = list.size <= static_cast<std::size_t>(threads); // no register to fill
    dem::push_ensemble(model, ensemble, plan, study.solver, workers);
}

} // namespace app
