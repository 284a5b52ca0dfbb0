#include "python/src/loaded_study.hpp"

#include "app/input/option.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/study/other_way.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "python/src/beside_python.hpp"

#include <cstdint>
#include <optional>
#include <utility>

namespace bindings {

namespace {

/// The study file with another wall.
app::StudySource with_wall(const std::string& path, const std::vector<std::string>& overrides,
                           const std::vector<std::string>& wall)
{
    if (path.ends_with(".h5"))
        throw app::ConfigError(
            path, 0, "wall",
            "the walls of a file of results are what they are; give its study file");
    app::StudyFile file;
    if (path.empty())
        file.path = "study";
    else
        file = app::read_study_file(path);
    if (!wall.empty())
        std::erase_if(file.entries, [](const app::Entry& e) {
            return e.key.starts_with("wall.") || e.key.starts_with("lintel.");
        });
    std::vector<std::string> all = wall;
    all.insert(all.end(), overrides.begin(), overrides.end());
    app::Study study = app::read_study(app::with_overrides(std::move(file), all));
    const std::uint32_t samples = app::samples_of(study.geometry, study);
    return {app::prepare(std::move(study)), {samples}, {}};
}

app::StudySource source_of(const std::string& path, const std::vector<std::string>& overrides,
                           const std::vector<std::string>& wall)
{
    if (path.empty() || !wall.empty()) return with_wall(path, overrides, wall);
    std::optional<Hdf5Turn> turn;
    if (path.ends_with(".h5")) turn.emplace();
    return app::study_source(path, overrides);
}

} // namespace

std::shared_ptr<LoadedStudy> load_study(const std::string& path,
                                        const std::vector<std::string>& overrides,
                                        const std::vector<std::string>& wall)
{
    return std::make_shared<LoadedStudy>(
        LoadedStudy{source_of(path, overrides, wall), {}, {}, {}});
}

const app::SamplePlan& plan_of(LoadedStudy& study)
{
    if (!study.plan)
        study.plan = app::sample_plan(study.source.ready.study, study.source.ready.study.load,
                                      study.source.ready.study.source,
                                      study.source.ready.layout, study.source.sizes);
    return *study.plan;
}

const dem::Model& model_of(LoadedStudy& study)
{
    if (!study.model) study.model = app::model_of(study.source.ready);
    return *study.model;
}

std::shared_ptr<LoadedStudy> study_of(const std::shared_ptr<LoadedStudy>& study, int sample)
{
    const app::Study& all = study->source.ready.study;
    if (!app::has_layouts(all.geometry)) return study;
    const std::uint32_t seed = app::layout_seed(all, static_cast<std::uint32_t>(sample));
    std::shared_ptr<LoadedStudy>& own = study->layouts[seed];
    if (!own) {
        app::StudySource source{app::in_layout(all, seed), study->source.sizes,
                                study->source.other_revision};
        own = std::make_shared<LoadedStudy>(LoadedStudy{std::move(source), {}, {}, {}});
    }
    return own;
}

std::vector<app::PushedWall> push_beside_python(LoadedStudy& study,
                                                const std::vector<app::WantedWall>& wanted,
                                                int threads, Snapshots snapshots)
{
    const dem::Model& model = model_of(study);
    std::vector<app::PushedWall> walls(wanted.size());
    beside_python([&](Caller& python) {
        dem::PushPlan plan = app::push_plan(study.source.ready.study);
        plan.snapshot_every =
            snapshots == Snapshots::all ? study.source.ready.study.output.snapshot_every : 0.0;
        plan.snapshot_at_peak = snapshots != Snapshots::none;
        plan.progress = [&](const dem::PushProgress&) { python.end_if_asked(); };
        app::PushList list;
        list.size = wanted.size();
        list.wall = [&](std::size_t i) { return wanted[i]; };
        list.done = [&](std::size_t i, const app::WallDraw&, app::PushedWall&& wall) {
            walls[i] = std::move(wall);
        };
        const int all = threads > 0 ? threads : app::default_threads();
        std::optional<app::OtherWay> other; // of one wall, as `drystone push` does
        if (wanted.size() == 1)
            other.emplace(study.source.ready.study, model, wanted, all,
                          [&] { python.end_if_asked(); });
        app::push_walls(study.source.ready.study, model, plan, list,
                        other ? other->threads_left() : all);
        if (other) other->add_to(walls);
    });
    return walls;
}

} // namespace bindings
