#include "python/src/loaded_study.hpp"

#include "app/input/option.hpp"
#include "app/input/wall_geometry.hpp"
#include "app/study/push_walls.hpp"
#include "python/src/beside_python.hpp"

#include <utility>

namespace bindings {

std::shared_ptr<LoadedStudy> load_study(const std::string& path,
                                        const std::vector<std::string>& overrides)
{
    std::optional<Hdf5Turn> turn;
    if (path.ends_with(".h5")) turn.emplace();
    app::Command command;
    command.study = path;
    command.overrides = overrides;
    app::StudySource source = app::study_source(command);
    dem::Layout layout = layout_of(source.study);
    return std::make_shared<LoadedStudy>(
        LoadedStudy{std::move(source), std::move(layout), {}, {}});
}

const app::SamplePlan& plan_of(LoadedStudy& study)
{
    if (!study.plan)
        study.plan = app::sample_plan(study.source.study, study.layout, study.source.sizes);
    return *study.plan;
}

const dem::Model& model_of(LoadedStudy& study)
{
    if (!study.model) study.model = app::model_of(study.source.study);
    return *study.model;
}

std::vector<app::PushedWall>
push_beside_python(LoadedStudy& study, const std::vector<app::WantedWall>& wanted, int threads)
{
    const dem::Model& model = model_of(study);
    std::vector<app::PushedWall> walls(wanted.size());
    beside_python([&](Caller& python) {
        dem::PushPlan plan = app::push_plan(study.source.study);
        plan.snapshot_every = 0.0;
        plan.snapshot_at_peak = false;
        plan.progress = [&](double, double, double) { python.end_if_asked(); };
        app::PushList list;
        list.size = wanted.size();
        list.wall = [&](std::size_t i) { return wanted[i]; };
        list.done = [&](std::size_t i, const app::WallDraw&, app::PushedWall&& wall) {
            walls[i] = std::move(wall);
        };
        app::push_walls(study.source.study, model, plan, list,
                        threads > 0 ? threads : app::default_threads());
    });
    return walls;
}

} // namespace bindings
