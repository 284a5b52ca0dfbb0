#include "app/study/pushed/push_walls.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/study/study.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/pier_watch.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/ensemble.hpp"

#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace app {

void push_walls(const Study& study, const dem::Model& model, const dem::PushPlan& plan,
                const PushList& list, int threads)
{
    std::mutex mutex; // of `started` and of list.done
    std::map<std::size_t, WantedWall> started;
    dem::PushPlan watched = plan;
    const ReadingRules rules = reading_rules(study);
    PierWatch piers(study, study.load, pier_rules(study.fragility, rules), model.layout,
                    watched);
    dem::Ensemble ensemble;
    ensemble.size = list.size;
    ensemble.open = list.open;
    ensemble.wall = [&](std::size_t i) -> std::optional<dem::WallMaterials> {
        if (list.keeps_begun && interrupted()) return {};
        end_if_interrupted();
        std::optional<WantedWall> wanted = list.wall(i);
        if (!wanted) return {};
        const int level = wanted->level;
        try {
            dem::WallMaterials materials =
                wall_materials(study, study.random, stress_level(study.load, level),
                               model.layout, wanted->draw);
            dem::check(model, materials);
            const std::lock_guard lock(mutex);
            started.emplace(i, std::move(*wanted));
            return materials;
        } catch (const std::invalid_argument& bad) {
            const std::lock_guard lock(mutex);
            list.done(i, wanted->draw, no_wall(rules, study.load, level, bad.what()));
            return {};
        }
    };
    ensemble.done = [&](std::size_t i, dem::PushResult&& result) {
        const std::lock_guard lock(mutex);
        const WantedWall wanted = std::move(started.extract(i).mapped());
        PushedWall wall =
            read_wall(rules, study.load, study.output, wanted.level, std::move(result));
        piers.add_to(i, wall);
        list.done(i, wanted.draw, std::move(wall));
        if (!list.keeps_begun) end_if_interrupted();
    };
    dem::Workers workers;
    workers.threads = threads;
    workers.scalar = list.size <= static_cast<std::size_t>(threads); // no register to fill
    dem::push_ensemble(model, ensemble, watched, study.solver, workers);
}

} // namespace app
