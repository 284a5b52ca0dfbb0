#include "app/commands.hpp"
#include "app/fragility/fragility_command.hpp"
#include "app/fragility/intensity/intensity_data.hpp"
#include "app/fragility/intensity/intensity_output.hpp"
#include "app/input/prepared_study.hpp"
#include "app/shake/shake_again.hpp"
#include "app/shake/shake_study.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/stored/shaken_intensities.hpp"
#include "app/study/stored/stored_histories.hpp"
#include "app/text/config_error.hpp"
#include "app/text/json_text.hpp"
#include "ground/intensity.hpp"
#include "scenes/terminal.hpp"
#include "tests/app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

constexpr const char* kShaking = R"([load]
vertical_stress = 0.05 MPa
mass = floor
[solver]
fidelity = rigid
[shaking]
records = half_sine(peak 0.3 g, duration 0.2 s), wave.txt, sine(peak 1 g, period 0.4 s)
intensities = 0.3, 0.6, 0.9 g
[uq]
samples = 3
)";

/// A study of walls that are shaken, in a folder of its own.
class ShakenStudy {
  public:
    ShakenStudy()
    {
        fs::create_directories(path);
        std::ofstream(path / "study.ini") << study_texts::kShakenWall << kShaking;
        put_wave(1.0);
    }
    ~ShakenStudy() { fs::remove_all(path); }
    ShakenStudy(const ShakenStudy&) = delete;
    ShakenStudy& operator=(const ShakenStudy&) = delete;
    fs::path path =
        fs::temp_directory_path() / ("drystone_shaken_" + std::to_string(::getpid()));

    /// Two columns, seconds and g.
    void put_wave(double peak) const
    {
        std::ofstream wave(path / "wave.txt");
        wave << "0.00 0\n0.05 " << peak << "\n0.10 0\n0.15 " << -peak << "\n0.20 0\n";
    }
    [[nodiscard]] int run(const std::string& out, int threads = 2,
                          const std::vector<std::string>& overrides = {},
                          app::Shard shard = {}) const
    {
        app::Command c;
        c.study = (path / "study.ini").string();
        c.words = {c.study};
        c.out = (path / out).string();
        c.quiet = true;
        c.threads = threads;
        c.overrides = overrides;
        c.shard = shard;
        const scenes::Terminal terminal;
        return app::shake_study_command(c);
    }
    [[nodiscard]] std::vector<app::WallRow> rows(const std::string& file) const
    {
        app::StoreReader reader(path / file);
        std::vector<app::WallRow> all;
        reader.for_each_row([&](const app::WallRow& row) { all.push_back(row); });
        return all;
    }
};

std::vector<std::uint64_t> bits_of(const std::vector<double>& x)
{
    std::vector<std::uint64_t> bits;
    for (const double v : x) bits.push_back(std::bit_cast<std::uint64_t>(v));
    return bits;
}

bool same_rows(const std::vector<app::WallRow>& a, const std::vector<app::WallRow>& b)
{
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].key != b[i].key || a[i].counts != b[i].counts ||
            bits_of(a[i].inputs) != bits_of(b[i].inputs) ||
            bits_of(a[i].responses) != bits_of(b[i].responses))
            return false;
    return true;
}

double cell(const app::Json& row, const char* head)
{
    const app::Json& value = row.at(head);
    return value.is_null() ? 0.0 : value.get<double>();
}

/// Histories of the modes are together all of them; each mode's curve is of its own histories.
void check_modes(const app::Json& all, const app::StoredHistories& read)
{
    const app::Json& table = all["tables"]["intensity_modes"];
    const app::Json& limits = all["tables"]["intensity_limits"];
    std::map<std::string, double> n, reached, share;
    std::set<std::string> modes;
    for (const app::Json& row : table["rows"]) {
        const std::string state = row.at("state");
        n[state] += cell(row, "n");
        reached[state] += cell(row, "reached");
        share[state] += cell(row, "share [%]");
        modes.insert(row.at("mode"));
        const auto of_mode = std::ranges::count_if(
            read.levels.front().histories, [&](const app::StoredHistory& h) {
                return row.at("mode") == std::string(dem::name(h.mode));
            });
        CHECK(cell(row, "n") == static_cast<double>(of_mode));
    }
    CHECK(modes.size() >= 2);
    for (const app::Json& row : limits["rows"]) {
        if (row.at("method") != "stripes") continue;
        const std::string state = row.at("state");
        CAPTURE(state);
        CHECK(n.at(state) == cell(row, "n"));
        CHECK(reached.at(state) == cell(row, "reached"));
        if (reached.at(state) > 0.0) CHECK(share.at(state) == Approx(100.0));
    }
}

/// Histories that all have one mode have its curve, which is that of all stripes.
void check_one_mode(app::StoredHistories read)
{
    for (app::StoredHistory& h : read.levels.front().histories)
        h.mode = dem::FailureMode::sliding;
    const app::IntensityData data = app::intensity_data(std::move(read), "");
    bool any = false;
    for (const app::IntensityState& s : data.states) {
        const auto stripes = app::intensity_fits(data, 0, s).by[0];
        const auto sliding = app::intensity_fits(data, 0, s, dem::FailureMode::sliding);
        CHECK_FALSE(sliding.by[1]); // IDA
        CHECK(sliding.by[0]->fit.curve.median == stripes->fit.curve.median);
        any = any || stripes->fit.curve.median > 0.0;
        const auto rocking = app::intensity_fits(data, 0, s, dem::FailureMode::rocking);
        CHECK(rocking.by[0]->fit.n == 0.0);
    }
    CHECK(any);
}

/// Pictures of a study whose histories are changed.
template <class Change>
std::vector<std::string> drift_pictures(app::StoredHistories read, Change change)
{
    for (app::StoredHistory& h : read.levels.front().histories) change(h);
    const app::IntensityData data = app::intensity_data(std::move(read), "");
    const app::AllIntensityFits none = {std::vector<app::IntensityFits>(data.states.size())};
    std::vector<std::string> pictures;
    for (const app::NamedPicture& p : app::intensity_pictures(data, none))
        if (p.name.starts_with("ida_") || p.name.starts_with("cloud_"))
            pictures.push_back(p.svg);
    return pictures;
}

/// Pictures of drifts show drifts, and not what the first state is read from.
void check_drift_pictures(const app::StoredHistories& read)
{
    const auto as_is = drift_pictures(read, [](app::StoredHistory&) {});
    CHECK(as_is.size() == 2);
    CHECK(drift_pictures(read, [](app::StoredHistory& h) { h.uplift = 0.5; }) == as_is);
    const auto moved = drift_pictures(read, [](app::StoredHistory& h) { h.max_drift *= 0.1; });
    for (std::size_t i = 0; i < as_is.size(); ++i) CHECK(moved[i] != as_is[i]);
    // the line of a steep cloud ends where its drifts do, and draws no axis beyond them
    const auto steep = drift_pictures(read, [](app::StoredHistory& h) {
        const double scatter = 1.0 + static_cast<double>(h.record);
        h.fell = false;
        h.max_drift = h.intensity < 2 ? 1e-9 : (h.intensity < 3 ? 0.002 : 0.02) * scatter;
    });
    CHECK_THAT(steep.back(), Contains("median, fallen walls") && Contains(">0.01<"));
    CHECK_THAT(steep.back(), !Contains(">0.001<")); // [%], below the least that is told apart
}

} // namespace

TEST_CASE(
    "shake study: every wall under every record and intensity, the same bits for any threads, "
    "shards or resumed runs",
    "[app][shake]")
{
    const ShakenStudy study;
    REQUIRE(study.run("one.h5", 1) == 0);
    const std::vector<app::WallRow> one = study.rows("one.h5");
    REQUIRE(one.size() == 27);
    REQUIRE(study.run("three.h5", 3) == 0);
    CHECK(same_rows(one, study.rows("three.h5")));
    REQUIRE(study.run("part.h5", 2, {"uq.samples=1"}) == 0); // and goes on below
    CHECK(study.rows("part.h5").size() == 9);
    REQUIRE(study.run("shard.h5", 2, {}, {0, 2}) == 0);
    REQUIRE(study.run("shard.h5", 1, {}, {1, 2}) == 0);
    app::Command merge;
    for (const char* const name : {"merged.h5", "shard_1_of_2.h5", "shard_2_of_2.h5"})
        merge.words.push_back((study.path / name).string());
    {
        const scenes::Terminal terminal;
        REQUIRE(app::merge_command(merge) == 0);
    }
    CHECK(same_rows(one, study.rows("merged.h5")));

    const app::StoredHistories all = app::read_histories(study.path / "one.h5");
    CHECK(all.records.size() == 3);
    std::set<std::vector<std::size_t>> seen;
    for (const app::StoredHistory& h : all.levels.front().histories) {
        CHECK_FALSE(h.failed);
        seen.insert({h.wall, h.record, h.intensity});
        const double pga = h.measures.front() / 9.80665;
        CHECK(pga == Approx(std::vector{0.3, 0.6, 0.9}.at(h.intensity)));
    }
    CHECK(seen.size() == 27);
    CHECK(all.levels.front().missing == 0);
    // the names of measures come back, and what they need of the wall is its own
    for (const std::string& name : all.measures)
        CHECK(ground::measure_text(ground::parse_measure(name)) == name);
    const auto measured = [&](const std::string& name) {
        const auto at = std::ranges::find(all.measures, name);
        REQUIRE(at != all.measures.end());
        return all.levels.front().histories.front().measures.at(
            static_cast<std::size_t>(at - all.measures.begin()));
    };
    const app::PreparedStudy ready = app::prepare(all.study);
    const ground::Measure rocking{
        .kind = ground::MeasureKind::rocking_pga,
        .block = {0.5 * ready.layout.length, 0.5 * ready.layout.height}};
    CHECK(measured(ground::measure_text(rocking)) ==
          Approx(0.3 / (ready.layout.length / ready.layout.height)));
    for (const char* const name : {"avg_sa(0.3 s)", "fiv3(1 s)"}) CHECK(measured(name) > 0.0);
}

TEST_CASE("shake study: a study that grows keeps its walls and goes on", "[app][shake]")
{
    const ShakenStudy study;
    const std::vector<std::string> sampled = {"uq.design=monte_carlo"};
    REQUIRE(study.run("grown.h5", 2, {"uq.design=monte_carlo", "uq.samples=1"}) == 0);
    REQUIRE(study.run("grown.h5", 2, sampled) == 0);
    REQUIRE(study.run("whole.h5", 2, sampled) == 0);
    CHECK(same_rows(study.rows("grown.h5"), study.rows("whole.h5")));
}

TEST_CASE("shake study: a job array also has time for the pushes of its walls", "[app][shake]")
{
    const ShakenStudy study;
    const auto said = [&](const char* push) {
        app::Command c;
        c.study = (study.path / "study.ini").string();
        c.words = {c.study};
        c.out = (study.path / "array.h5").string();
        c.script = (study.path / "array.sh").string();
        c.quiet = true;
        c.overrides = {std::string("shaking.push=") + push};
        const scenes::Terminal terminal;
        CHECK(app::shake_study_command(c) == 0);
        return terminal.text();
    };
    CHECK_THAT(said("yes"), StartsWith("27 histories of ") && Contains(" s, 3 pushes of "));
    CHECK_THAT(said("no"), StartsWith("27 histories of ") && !Contains("pushes"));
}

TEST_CASE("shake study: intensities have any unit of their measure, at each or at the last",
          "[app][shake_study]")
{
    const auto values = [](const std::string& measure, const std::string& text) {
        app::ShakingInput shaking;
        shaking.measure = measure;
        shaking.intensities = text;
        return app::shaken_intensities(shaking, {}).values;
    };
    CHECK(values("pga", "0.1, 0.2") == values("pga", "0.1, 0.2 g"));
    CHECK(values("sa(0.3 s)", "0.5, 30e-1 m/s2") == std::vector<double>{0.5, 3.0});
    CHECK(values("pgv", "10 cm/s, 0.2") == std::vector<double>{0.1, 0.2});
    CHECK_THROWS_WITH(values("pga", "0.3 m/s"), Contains("write g or m/s2 or cm/s2"));
    CHECK_THROWS_WITH(values("pgv", "0, 0.2 m/s"), Contains("must be above 0"));
}

TEST_CASE("shake study: paired walls have one record each", "[app][shake]")
{
    const ShakenStudy study;
    REQUIRE(study.run("paired.h5", 2, {"shaking.design=paired", "uq.samples=4"}) == 0);
    const app::StoredHistories all = app::read_histories(study.path / "paired.h5");
    REQUIRE(all.levels.front().histories.size() == 12);
    for (const app::StoredHistory& h : all.levels.front().histories)
        CHECK(h.record == h.wall % 3);
}

TEST_CASE("shake study: a record that has changed is refused in a sentence", "[app][shake]")
{
    const ShakenStudy study;
    REQUIRE(study.run("a.h5", 2, {"uq.samples=1"}) == 0);
    const std::vector<app::WallRow> before = study.rows("a.h5");
    study.put_wave(0.9);
    CHECK_THROWS_WITH(study.run("a.h5"), Contains("\"wave\" has changed since") ||
                                             Contains("wave.txt\" has changed since"));
    CHECK(same_rows(before, study.rows("a.h5")));
    study.put_wave(1.0);
    CHECK_THROWS_WITH(study.run("a.h5", 1,
                                {"shaking.records=" + (study.path / "wave.txt").string() +
                                 ", half_sine(peak 1 g, duration 0.2 s)"}),
                      Contains("shaking.records: record 1 is"));
    CHECK_THROWS_WITH(study.run("b.h5", 1, {"uq.audit=1"}), Contains("uq.audit: pushes walls"));
    CHECK_FALSE(fs::exists(study.path / "b.h5"));
}

TEST_CASE("shake study: walls in layouts of their own are those of each layout alone",
          "[app][shake]")
{
    const ShakenStudy study;
    const std::vector<std::string> random = {"wall.bond=running", "wall.unit_length_cov=0.1",
                                             "wall.length=0.9 m", "uq.samples=3"};
    const auto run = [&](const char* file, const std::vector<std::string>& more) {
        std::vector<std::string> all = random;
        all.insert(all.end(), more.begin(), more.end());
        REQUIRE(study.run(file, 2, all) == 0);
        return study.rows(file);
    };
    const auto both = run("both.h5", {"wall.layouts=2", "wall.seed=5"});
    const auto first = run("first.h5", {"wall.seed=5"}),
               second = run("second.h5", {"wall.seed=6"});
    REQUIRE(both.size() == 27);
    std::size_t different = 0;
    for (std::size_t i = 0; i < both.size(); ++i) {
        const bool odd = i / 9 % 2 == 1; // nine histories of each wall
        CHECK(bits_of(both[i].responses) == bits_of((odd ? second : first)[i].responses));
        different += bits_of(first[i].responses) == bits_of(second[i].responses) ? 0 : 1;
    }
    CHECK(different == both.size());
    // and a film shakes the wall in its own layout
    const app::StoredHistories stored = app::read_histories(study.path / "both.h5");
    const app::ShakenAgain again(stored, study.path / "both.h5");
    for (const std::size_t i : {0, 9}) {
        const app::StoredHistory& h = stored.levels.front().histories[i];
        const app::ShakenWall wall =
            again.history(0, h, [](const app::ShakingMotion&, double, double) {});
        CHECK(wall.result.most_displacement / wall.result.top_height == h.max_drift);
    }
}

TEST_CASE("shake study: fragility on the intensity, with rates and files for others",
          "[app][shake][fragility]")
{
    const ShakenStudy study;
    REQUIRE(study.run("s.h5", 2,
                      {"shaking.intensities=0.2, 0.4, 0.6, 0.9, 1.3 g",
                       "shaking.records=kanai_tajimi(peak 0.3 g, duration 3 s, records 5)",
                       "shaking.push=yes", "uq.samples=3"}) == 0);
    const app::StoredHistories read = app::read_histories(study.path / "s.h5");
    std::map<std::size_t, std::set<double>> limits; // of each wall
    for (const app::StoredHistory& h : read.levels.front().histories) {
        limits[h.wall].insert(h.pushed_limit);
        CHECK(h.uplift >= 0.0);
        CHECK(h.uplift <= 1.0);
    }
    REQUIRE(limits.size() == 3);
    std::set<double> different;
    for (const auto& [wall, of] : limits) {
        CHECK(of.size() == 1);
        CHECK(*of.begin() > 0.0);
        different.insert(*of.begin());
    }
    CHECK(different.size() == 3);
    std::ofstream(study.path / "hazard.csv")
        << "PGA [g],rate [1/a]\n0.05,0.1\n0.2,0.01\n0.5,0.001\n1,0.0001\n";
    app::Command c;
    c.study = (study.path / "s.h5").string();
    c.words = {c.study};
    c.out = (study.path / "s").string();
    c.hazard = (study.path / "hazard.csv").string();
    c.quiet = true;
    {
        const scenes::Terminal terminal;
        REQUIRE(app::fragility_command(c) == 0);
    }
    const auto text_of = [&](const char* name) {
        std::ifstream in(study.path / "s" / name);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    };
    const app::Json all = app::json_of(text_of("fragility.json"));
    const app::Json& rows = all["tables"]["intensity_limits"]["rows"];
    REQUIRE(rows.size() > 0);
    CHECK_THAT(text_of("intensity_limits.csv"), Contains("uplift of 50 %"));
    CHECK_THAT(text_of("intensity_limits.csv"), Contains("80 % of the limit of its own push"));
    for (const app::Json& row : rows) // of the hazard 0.0001 a year lies beyond the last point
        if (!row.at("annual rate [1/a]").is_null())
            CHECK(row.at("with all beyond the hazard [1/a]").get<double>() -
                      row.at("annual rate [1/a]").get<double>() ==
                  Approx(1e-4));
    CHECK_THAT(text_of("openquake_fragility.xml"), Contains("imt=\"PGA\""));
    CHECK_THAT(text_of("pelicun_fragility.csv"), Contains("Peak Ground Acceleration,g,"));
    // five records are too few for a test of sufficiency
    for (const app::Json& row : all["tables"]["intensity_measures"]["rows"])
        CHECK(row.at("sufficiency, D5-95: p").is_null());
    check_modes(all, read);
    check_one_mode(read);
    check_drift_pictures(read);
    for (const char* const name : {"fragility_0.05_MPa.svg", "ida_0.05_MPa.svg",
                                   "cloud_0.05_MPa.svg", "modes_0.05_MPa.svg"})
        CHECK(fs::exists(study.path / "s" / "pictures" / name));
    c.intensity = "sa(0.7 s)";
    CHECK_THROWS_WITH(app::fragility_command(c),
                      Contains("--intensity: \"sa(0.7 s)\" is not in"));
    c.intensity = "pgv";
    CHECK_THROWS_WITH(app::fragility_command(c), Contains("pgv is read in [m/s]"));
    c.intensity.clear();
    for (const char* const other : {"Sa(0.3 s) [g]", "sa(0.3 s)", "Sa [g]", "avg_sa(0.5 s)"}) {
        std::ofstream(study.path / "hazard.csv") << other << ",rate\n0.1,0.1\n0.2,0.01\n";
        CHECK_THROWS_WITH(app::fragility_command(c),
                          Contains("names another measure than pga"));
    }
    for (const auto& [rates, why] : {std::pair("PoE in 50 years", "rate = -ln(1 - p) / T"),
                                     {"annual probability", "no probabilities"},
                                     {"return period [a]", "rate = 1 / period"},
                                     {"rate [1/1000 a]", "the rates are read in [1/a]"}}) {
        std::ofstream(study.path / "hazard.csv") << "PGA [g]," << rates << "\n0.1,0.1\n";
        CHECK_THROWS_WITH(app::fragility_command(c), Contains(why));
    }
    for (const auto& [measure, head] : {std::pair("", "PGA [g]"),
                                        {"sa(0.3 s)", "Sa(0.3 s)"},
                                        {"sa(0.3 s)", " sa(0.3 s) [g]"}}) {
        std::ofstream(study.path / "hazard.csv") << head << ",rate\n0.1,0.1\n0.2,0.2\n";
        c.intensity = measure;
        CHECK_THROWS_WITH(app::fragility_command(c),
                          Contains("must be below that of the row before"));
    }
}

TEST_CASE("shake study: tables write each intensity as the measure, with its unit",
          "[app][shake][fragility]")
{
    const ShakenStudy study;
    const auto lines_of = [&](const char* name) {
        std::ifstream in(study.path / name);
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        return lines;
    };
    REQUIRE(study.run("s.h5", 2,
                      {"shaking.measure=sa(0.3 s)", "shaking.intensities=0.2, 0.4 g",
                       "shaking.scale=1.5", "uq.samples=1"}) == 0);
    const std::vector<std::string> summary = lines_of("s_summary.csv");
    CHECK_THAT(summary.at(0), StartsWith("stress [MPa],sa(0.3 s) [g],histories,"));
    CHECK_THAT(summary.at(1), StartsWith("0.05,0.3,3,"));
    CHECK_THAT(summary.at(2), StartsWith("0.05,0.6,3,"));
    app::Command c;
    c.study = (study.path / "s.h5").string();
    c.words = {c.study};
    c.out = (study.path / "s").string();
    c.quiet = true;
    {
        const scenes::Terminal terminal;
        REQUIRE(app::fragility_command(c) == 0);
    }
    CHECK_THAT(lines_of("s/tables/histories.csv").at(0),
               StartsWith("stress [MPa],wall,record,sa(0.3 s) [g],outcome,") &&
                   Contains(",pga [m/s2],"));
    CHECK_THAT(lines_of("s/tables/histories.csv").at(1), Contains(",0.3,stood,"));
    CHECK_THAT(lines_of("s/intensity_stripes.csv").at(0),
               StartsWith("stress [MPa],sa(0.3 s) [g],median sa(0.3 s) [g],"));

    REQUIRE(study.run("as_they_are.h5", 2, {"shaking.intensities=", "uq.samples=1"}) == 0);
    CHECK_THAT(lines_of("as_they_are_summary.csv").at(0),
               StartsWith("stress [MPa],factor [-],"));
}
