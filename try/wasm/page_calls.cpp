/// The functions that the page calls. Texts go in as UTF-8 in the module's memory, answers come
/// out as JSON: {"error": "..."} with the program's own message where an input is wrong.

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/study_reading.hpp"
#include "try/wasm/page_json.hpp"

#include "app/input/study/study_file.hpp"
#include "app/push/capacity_svg.hpp"
#include "app/push/capacity_text.hpp"
#include "app/push/pushed_picture.hpp"
#include "app/push/summary_json.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "app/text/config_error.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/ensemble.hpp"

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#define DRYSTONE_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#define DRYSTONE_IMPORT(name)                                                                  \
    extern "C" __attribute__((import_module("page"), import_name(#name)))

DRYSTONE_IMPORT(progress) void told(double done, double displacement, double force);
DRYSTONE_IMPORT(frame)
void frame(const float* numbers, std::size_t size, double displacement, double force);
DRYSTONE_IMPORT(again) void again();
DRYSTONE_IMPORT(begin) void begin(const char* json, std::size_t size);
DRYSTONE_IMPORT(wall) void wall_done(const char* json, std::size_t size);

namespace {

using app::Json;
using app::PreparedStudy;
using app::Study;

std::string answer;

constexpr const char* kName = "study.ini"; // of what the page writes

/// Gives the answer of `work`, or the message of what it throws.
template <class Work> const char* answered(Work work)
{
    Json j;
    try {
        j = work();
    } catch (const std::exception& bad) {
        j = {{"error", bad.what()}};
    }
    answer = app::text_of(j);
    return answer.c_str();
}

void say(void (*to)(const char*, std::size_t), const Json& json)
{
    const std::string text = app::text_of(json);
    to(text.data(), text.size());
}

PreparedStudy study_of(const char* text, std::size_t size)
{
    const app::StudyFile file = app::parse_study_text(kName, {text, size});
    Study study = app::read_study(file);
    if (study.load.vertical_stress.size() != 1)
        throw app::error_at(file, "load.vertical_stress",
                            "this page takes one stress at a time");
    return app::prepare(std::move(study));
}

/// A push takes numbers.
void refuse_random(const Study& study)
{
    if (!study.random.empty())
        throw app::error_at(study.source, study.random.front().key,
                            "is a distribution; \"Many walls\" below takes it");
}

dem::PushPlan shown_plan(const Study& study, int frames)
{
    dem::PushPlan plan = app::push_plan(study);
    plan.snapshot_every = app::push_way(study.load).length / frames;
    plan.sink.take = [first = true](std::size_t, dem::Snapshot&& shot) mutable {
        if (std::exchange(first, false)) say(begin, page::moving_scene_json(shot));
        const std::vector<float> numbers = page::movement_of(shot);
        frame(numbers.data(), numbers.size(), shot.displacement, shot.force);
    };
    plan.sink.forget = [](std::size_t) { again(); };
    plan.progress = [](const dem::PushProgress& p) { told(p.done, p.displacement, p.force); };
    return plan;
}

Json result_of(const PreparedStudy& ready, const app::PushedWall& w)
{
    const Study& study = ready.study;
    Json j = {{"summary", app::json_of(app::summary_json(study, ready.layout, w))},
              {"curve", page::curve_json(w)},
              {"limits", page::limits_json(study, w.reading, w.loads.height)}};
    if (dem::failed(w.result.outcome)) return j;
    j["capacity.csv"] = app::capacity_text(w);
    j["capacity.svg"] = app::capacity_svg(app::reading_rules(study), w, {});
    j["wall.svg"] = app::pushed_picture(study.beam, study.load, ready.layout, w);
    return j;
}

} // namespace

DRYSTONE_EXPORT(take) void* take(std::size_t bytes) { return std::malloc(bytes); }
DRYSTONE_EXPORT(give_back) void give_back(void* at) { std::free(at); }

/// All keys of a study of one wall.
DRYSTONE_EXPORT(keys) const char* keys()
{
    return answered([] { return page::keys_json(); });
}

/// Checks a study: its stones as they stand, or the program's message.
DRYSTONE_EXPORT(look) const char* look(const char* text, std::size_t size)
{
    return answered([&] { return page::scene_json(study_of(text, size)); });
}

/// Pushes the wall of a study; tells of it as it goes.
DRYSTONE_EXPORT(push) const char* push(const char* text, std::size_t size, int frames)
{
    return answered([&] {
        const PreparedStudy ready = study_of(text, size);
        const Study& study = ready.study;
        refuse_random(study);
        const dem::Model model = app::model_of(ready);
        dem::PushResult result =
            dem::push(model,
                      app::wall_materials(study, study.random, app::stress_level(study.load, 0),
                                          model.layout, {}),
                      shown_plan(study, frames), study.solver);
        return result_of(ready, app::read_wall(app::reading_rules(study), study.load,
                                               study.output, 0, std::move(result)));
    });
}

/// Pushes walls first, first + step, ... of a study with distributions; tells of each.
DRYSTONE_EXPORT(walls)
const char* walls(const char* text, std::size_t size, int first, int step)
{
    return answered([&]() -> Json {
        const PreparedStudy ready = study_of(text, size);
        const Study& study = ready.study;
        const dem::Model model = app::model_of(ready);
        const std::uint32_t samples = study.uq.samples;
        const app::SamplePlan plan =
            app::sample_plan(study, study.load, study.source, model.layout, {&samples, 1});
        std::vector<int> mine;
        for (int i = first; i < static_cast<int>(samples); i += step) mine.push_back(i);
        dem::Ensemble ensemble;
        ensemble.size = mine.size();
        const auto tell = [&](int sample, const app::PushedWall& w) {
            say(wall_done, page::wall_json(study, sample, w));
        };
        ensemble.wall = [&](std::size_t i) -> std::optional<dem::WallMaterials> {
            try {
                dem::WallMaterials materials =
                    app::wall_materials(study, study.random, app::stress_level(study.load, 0),
                                        model.layout, app::draw(plan, 0, mine[i]));
                dem::check(model, materials);
                return materials;
            } catch (const std::invalid_argument& bad) {
                tell(mine[i],
                     app::no_wall(app::reading_rules(study), study.load, 0, bad.what()));
                return {};
            }
        };
        ensemble.done = [&](std::size_t i, dem::PushResult&& result) {
            tell(mine[i], app::read_wall(app::reading_rules(study), study.load, study.output, 0,
                                         std::move(result)));
        };
        dem::PushPlan push_plan = app::push_plan(study);
        push_plan.snapshot_every = 0.0;
        push_plan.snapshot_at_peak = false;
        dem::push_ensemble(model, ensemble, push_plan, study.solver, {1, mine.size() < 2});
        return {{"walls", mine.size()}};
    });
}

/// Fragility curve of the drifts of walls, as page::fit_json takes them.
DRYSTONE_EXPORT(fit) const char* fit(const char* text, std::size_t size)
{
    return answered([&] { return page::fit_json(app::json_of({text, size})); });
}
