#include "app/fragility/study_output.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/prepared_study.hpp"
#include "app/push/summary_json.hpp"
#include "app/report/report_choice.hpp"
#include "app/report/report_data.hpp"
#include "app/study/study_stopping.hpp"
#include "app/study/study_summary.hpp"
#include "app/text/number_text.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"
#include "tests/app/report/fragility_keys.hpp"
#include "tests/app/report/report_scene.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

/// Everything that is made of one stored study under some rules.
struct Outputs {
    app::StudyWalls walls;
    app::FragilityOutput fragility;
    app::StudySummary summary;
    Json page;
};

Outputs outputs_of(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    Outputs o;
    o.walls = app::read_study_walls(file, overrides, app::Keep::everything);
    o.fragility = app::study_output(o.walls);
    o.summary = app::summarise(o.walls);
    o.page = app::report_data(o.walls, app::walls_to_list(o.walls, 100));
    return o;
}

const app::Table& table(const Outputs& o, const std::string& name)
{
    for (const app::NamedTable& t : o.fragility.tables)
        if (t.name == name) return t.table;
    throw std::out_of_range("no table " + name);
}

/// All that people and programs get, as one text.
std::string text_of(const Outputs& o)
{
    return app::fragility_json(o.fragility) + app::as_csv(o.summary.table) + o.page.dump();
}

/// The page shows the tables of `drystone fragility` and of `drystone study`, to the digit.
void check_tables(const Outputs& o)
{
    for (const auto& [name, shown] : o.page["tables"].items()) {
        CAPTURE(name);
        if (name == "choices" || name == "materials" || name == "wall_and_loads")
            continue; // what was put in
        const app::Table& t = name == "results" ? o.summary.table : table(o, name);
        CHECK(shown["csv"] == app::as_csv(t));
    }
}

/// The share of rocking walls stands in five places.
void check_shares(const Outputs& o)
{
    const app::Table& modes = table(o, "modes"); // of each level first rocking
    const std::size_t rows = modes.rows.size() / o.walls.levels.size();
    for (std::size_t l = 0; l < o.walls.levels.size(); ++l) {
        CHECK(scenes::cell(modes, rows * l, "mode") == "rocking");
        const double share = scenes::number_in(modes, rows * l, "share [%]").value;
        CHECK(scenes::number_in(o.summary.table, l, "rocking [%]").value == share);
        CHECK(100.0 * o.page["modes"]["levels"][l]["value"].get<double>() ==
              Approx(share).epsilon(1e-12));
        const app::StudyLevel& level = o.walls.levels[l];
        std::size_t rocking = 0;
        for (const Json& w : o.page["walls"])
            rocking += w["level"] == l && w["mode"] == "rocking" ? 1 : 0;
        CHECK(100.0 * static_cast<double>(rocking) / static_cast<double>(level.walls.size()) ==
              Approx(share).epsilon(1e-12));
    }
}

/// A wall is the same in the page, in the table of walls and in the summary of a push of it.
void check_push(const Outputs& o)
{
    const app::Study& study = o.walls.study;
    const dem::Model model = app::model_of(app::prepare(study));
    const app::SamplePlan plan =
        sample_plan(study, study.load, study.source, model.layout, o.walls.head.design_sizes);
    const app::PushedWall w = scenes::push_one(study, app::draw(plan, 1, 0), 1);
    const Json push = Json::parse(app::summary_json(study, model.layout, w));
    const std::size_t row = o.walls.levels[0].walls.size();
    const app::Table& walls = table(o, "walls");
    const auto written = [&](const std::string& head) { // as programs get it
        return app::rounded(scenes::number_in(walls, row, head).value, app::kAfterUnits);
    };
    CHECK(push["mode"] == scenes::cell(walls, row, "mode"));
    CHECK(push["mode"] == o.page["walls"][row]["mode"]);
    CHECK(push["peak_force_kN"] == written("peak [kN]"));
    CHECK(push["ultimate_displacement_mm"] == written("ultimate [mm]"));
    CHECK(push["ultimate_censored"] == (o.page["walls"][row]["reading"] == "censored"));
    REQUIRE(push["limit_states"].size() == o.walls.states.size());
    for (const Json& state : push["limit_states"]) {
        const std::string head =
            state["set"].get<std::string>() + " " + state["name"].get<std::string>() + " [mm]";
        const double mm = written(head);
        if (state["displacement_mm"].is_null())
            CHECK(std::isnan(mm));
        else
            CHECK(state["displacement_mm"] == mm);
    }
}

} // namespace

TEST_CASE("one reading: with any key of [fragility] every output has the same numbers",
          "[app][one_reading][slow]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    scenes::run_study(file, "samples = 8", "the numbers broke");
    std::vector<std::vector<std::string>> all = scenes::changed_fragility_keys();
    all.insert(all.begin(), std::vector<std::string>{});
    std::string standard;
    for (const std::vector<std::string>& overrides : all) {
        CAPTURE(overrides);
        const Outputs o = outputs_of(file, overrides);
        check_tables(o);
        check_shares(o);
        check_push(o);
        CHECK(o.summary.failed == 1); // kept and counted, whatever the rules
        CHECK(o.page["walls"].back()["mode"] == "failed");
        if (overrides.empty()) {
            standard = text_of(o);
            continue;
        }
        const std::string& key = overrides.front();
        const bool matters =
            why_no_effect(*app::find_key(key.substr(0, key.find('='))), o.walls.study).empty();
        CHECK((text_of(o) != standard) == matters); // the key is followed
    }
}

TEST_CASE("one reading: of a push to and fro every output is read on the backbone asked for",
          "[app][one_reading]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    scenes::run_study(file, "samples = 2\n[load]\namplitudes = 1, 2 mm");
    const Outputs mean = outputs_of(file, {}),
                  right = outputs_of(file, {"fragility.backbone=right"});
    for (const Outputs* o : {&mean, &right}) {
        check_tables(*o);
        check_shares(*o);
        check_push(*o);
    }
    CHECK(text_of(mean) != text_of(right));
}

TEST_CASE("one reading: the stopping rule looks at the same walls", "[app][one_reading]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    scenes::run_study(file, "samples = 8\nstop = mixed_share\nmost_samples = 20");
    const auto remark = [&](const std::vector<std::string>& overrides) {
        return app::stopping_state(app::read_study_walls(file, overrides)).remark;
    };
    // all mixed, or all rocking: the interval is that of 8 of 8; else it is wider
    const std::string mixed =
        remark({"fragility.cracked_units=0", "fragility.rotation_share=0.999999"});
    const std::string rocking =
        remark({"fragility.cracked_units=1000", "fragility.ultimate_share=0.000001"});
    CHECK(mixed == rocking);
    CHECK(mixed.find("8 walls") != std::string::npos);
}
