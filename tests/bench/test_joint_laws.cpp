#include "bench/joint_laws/findings.hpp"
#include "bench/joint_laws/law_tables.hpp"
#include "bench/joint_laws/laws.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

namespace {

/// Walls under 0.5 and 1.0 MPa that come down to 80 % at these displacements [mm]; negative:
/// that stood there.
bench::LawStudy study_of(const std::vector<double>& drops_mm, double peak_kN)
{
    bench::LawStudy s{scenes::study_walls(drops_mm.size()),
                      {{8000.0, 4.0, 0.0}, {8000.0, 4.0, 0.0}}};
    for (app::StudyLevel& level : s.walls.levels)
        for (std::size_t i = 0; i < drops_mm.size(); ++i) {
            app::WallReading& r = level.walls[i].reading;
            r.peak->force = peak_kN * 1e3;
            r.ultimate.displacement = std::abs(drops_mm[i]) * 1e-3;
            r.ultimate.reading =
                drops_mm[i] < 0.0 ? fragility::Reading::censored : fragility::Reading::observed;
        }
    return s;
}

bool says(const std::vector<std::string>& sentences, const std::string& words)
{
    for (const std::string& s : sentences)
        if (s.find(words) != std::string::npos) return true;
    return false;
}

} // namespace

TEST_CASE("joint laws: every law of the table is one that the script knows",
          "[bench][joint_laws]")
{
    std::ifstream in(std::string(DRYSTONE_SOURCE_DIR) + "/bench/joint_laws.sh");
    const std::string script{std::istreambuf_iterator<char>(in), {}};
    REQUIRE(!script.empty());
    for (const bench::JointLaw& law : bench::kJointLaws) {
        INFO(law.file);
        CHECK(script.find("\n    " + std::string(law.file) + ") ") != std::string::npos);
    }
}

TEST_CASE("joint laws: a wall that stood counts as standing in the quantiles of drifts",
          "[bench][joint_laws]")
{
    const auto all = study_of({11.0, 22.0, 33.0, 44.0}, 40.0); // height 1.1 m
    CHECK(bench::quantile(bench::limit_drifts(all, 0), 0.5).value() == Approx(2.0));
    CHECK(bench::quantile(bench::limit_drifts(all, 0), 0.76).value() == Approx(4.0));
    CHECK(bench::walls_within(all, 0, 2.5).down == 2);
    CHECK(bench::walls_within(all, 0, 2.5).known == 4);
    const auto some = study_of({-5.0, 11.0, -12.0, -12.0}, 40.0);
    CHECK(bench::quantile(bench::limit_drifts(some, 0), 0.16).value() == Approx(1.0));
    CHECK(!bench::quantile(bench::limit_drifts(some, 0), 0.5));
    CHECK(bench::walls_within(some, 0, 1.05).down == 1);
    CHECK(bench::walls_within(some, 0, 1.05).known == 3); // the first stood, but not so far
}

TEST_CASE("joint laws: walls are compared with themselves under other laws",
          "[bench][joint_laws]")
{
    const bench::NamedStudies two = {{"paper", study_of({10.0, 20.0, -30.0}, 40.0)},
                                     {"other", study_of({20.0, 10.0, 30.0}, 44.0)}};
    const app::Table t = bench::wall_by_wall(two);
    REQUIRE(t.rows.size() == 2);
    CHECK(scenes::number_in(t, 0, "peak / paper").value == Approx(1.1));
    CHECK(scenes::number_in(t, 0, "80 % drop / paper").value == Approx(1.0)); // 2 and 1/2
    CHECK(scenes::cell(t, 0, "drop nearer") == "1");
    CHECK(scenes::cell(t, 0, "drop farther") == "1");
    CHECK(scenes::cell(t, 0, "of walls") == "2"); // the third stood under the paper's laws
    const app::Table costs = bench::random_walls(two);
    REQUIRE(costs.rows.size() == 4);
    CHECK(scenes::number_in(costs, 0, "core seconds a wall").value == Approx(4.0 / 3.0));
}

TEST_CASE("joint laws: sentences follow the numbers, and wait for their runs",
          "[bench][joint_laws]")
{
    const auto tests = bench::tested_walls({});
    bench::LawRuns runs;
    CHECK(bench::findings(runs, tests).empty());
    runs.random = {
        {std::string(bench::name_of(bench::kPaperLaw)), study_of({10.0, 10.0}, 40.0)},
        {std::string(bench::name_of(bench::kAllLaws)), study_of({22.0, 22.0}, 42.0)}};
    const auto some = bench::findings(runs, tests);
    CHECK(some.size() == 2);
    CHECK(says(some, "+5.0 to +5.0 %"));
    CHECK(says(some, "0 % (all, hyperbolic) to 100 % (paper) under 0.50 MPa"));
    runs.mean_checks = {{{"usual", study_of({11.0}, 40.0)}, {"slow", study_of({22.0}, 40.4)}}};
    const auto more = bench::findings(runs, tests);
    CHECK(more.size() == 3);
    CHECK(says(more, "by up to 1.0 % and its 80 % drop by up to a factor of 2.00."));
    runs.random_checks = {{{"usual", study_of({5.0, 22.0, 22.0, 22.0}, 40.0)},
                           {"slow", study_of({22.0, 22.0, 22.0, 22.0}, 39.0)}}};
    CHECK(says(bench::findings(runs, tests),
               "of the same 4 walls under one stress by up to 2.6 %, and their share down "
               "within a drift of 1 % by up to 25 points."));
    const auto at = [](const std::string& setting, double peak_kN) {
        return bench::NamedStudies{{"default, " + setting, study_of({11.0}, 40.0)},
                                   {"other, " + setting, study_of({22.0}, peak_kN)}};
    };
    runs.limits = {at("1 %", 44.0), at("3 %, fine", 42.0)};
    CHECK(says(bench::findings(runs, tests),
               "by up to 10.0 % (1 %) and 5.0 % (3 %, fine) and its 80 % drop by up to a "
               "factor of 2.0."));
}

TEST_CASE("joint laws: the numbers of the tests that are kept are those of the other pages",
          "[bench][joint_laws]")
{
    std::ifstream in(std::string(DRYSTONE_SOURCE_DIR) + "/docs/tests/comparison.csv");
    const std::string table{std::istreambuf_iterator<char>(in), {}};
    REQUIRE(!table.empty());
    for (const bench::TestedWall& w : bench::tested_walls({})) {
        INFO(w.name);
        const std::size_t row = table.find("," + w.name + ",");
        REQUIRE(row != std::string::npos);
        double peak = 0.0, drop = 0.0;
        const std::string rest = table.substr(row + w.name.size() + 2);
        REQUIRE(std::sscanf(rest.c_str(), "%lf,%*f,%lf", &peak, &drop) == 2);
        CHECK(w.peak_kN == Approx(peak).margin(0.051));
        CHECK(w.drop_mm == Approx(drop).margin(0.0051));
        CHECK(w.secant_60 < w.secant_30);
    }
}
