#include "app/text/check_sum.hpp"
#include "bench/accuracy/accuracy_answers.hpp"
#include "bench/accuracy/accuracy_tables.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace {

bench::ComparedScene compared(double peak, double reference)
{
    bench::ComparedScene c;
    c.scene.kind = "courses";
    c.facts = {1e10, 1e3};
    c.asked.outcome = c.reference.outcome = "reached target";
    c.asked.peak = peak;
    c.reference.peak = reference;
    return c;
}

double number_in(const app::Row& row, std::size_t column)
{
    return std::get<app::Number>(row.at(column)).value;
}

} // namespace

TEST_CASE(
    "accuracy campaign: scenes are the same on every machine, and studies that push takes",
    "[bench][accuracy]")
{
    std::string all;
    for (std::uint64_t k = 0; k < 6; ++k) {
        const bench::AccuracyScene scene = bench::accuracy_scene(1, k);
        all += scene.text;
        const app::Study study = bench::study_of(scene);
        CHECK(study.load.max_displacement / study.output.record_every ==
              Approx(300.0).epsilon(1e-3));
        CHECK(bench::accuracy_scene(1, k).text == scene.text);
        CHECK(bench::accuracy_scene(2, k).text != scene.text);
    }
    // The sum of g++ on x86-64, where the scenes were drawn first: references in files are
    // found by such sums.
    CHECK(app::check_sum(all) == "d7ceaa0d847dbd59");
}

TEST_CASE(
    "accuracy campaign: a reference is slower in what sets the speed, and in nothing else",
    "[bench][accuracy]")
{
    const app::Study study = bench::study_of(bench::accuracy_scene(1, 0));
    const dem::SolverOptions& asked = study.solver;
    dem::SolverOptions slow = bench::reference_options(study, study);
    CHECK(slow.steps_per_mm == 20.0 * asked.steps_per_mm);
    CHECK(slow.accuracy == asked.accuracy / 20.0);
    CHECK(slow.most_steps > 1000 * asked.most_steps);
    slow.steps_per_mm = asked.steps_per_mm;
    slow.accuracy = asked.accuracy;
    CHECK(slow.most_slowdowns == 0);
    slow.most_steps = asked.most_steps;
    slow.most_slowdowns = asked.most_slowdowns;
    CHECK(slow == asked);
}

TEST_CASE("accuracy campaign: --set of speed moves the push and leaves its reference",
          "[bench][accuracy]")
{
    const bench::AccuracyScene scene = bench::accuracy_scene(1, 0);
    const std::vector<std::string> fast = {"solver.steps_per_mm=100", "solver.accuracy=5 %",
                                           "solver.min_speed=0.5"};
    const app::Study asked = bench::study_of(scene, fast), own = bench::study_of(scene);
    CHECK(asked.solver.steps_per_mm == 100.0);
    CHECK(asked.solver.accuracy == 0.05);
    CHECK(bench::reference_options(asked, own) == bench::reference_options(own, own));
}

TEST_CASE(
    "accuracy campaign: errors, lost peaks, branches and missing references are counted apart",
    "[bench][accuracy]")
{
    std::vector<bench::ComparedScene> scenes = {compared(101.5, 100.0), compared(99.8, 100.0),
                                                compared(100.01, 100.0)};
    scenes[0].asked.solver_error = 0.02; // holds 1.5 %
    scenes[0].asked.drop = 0.0101;
    scenes[0].reference.drop = 0.0100;
    scenes[0].asked.earliest = 0.0099;
    scenes[0].asked.latest = 0.0102;
    scenes[1].asked.drop = 0.01; // the reference does not fall
    scenes[1].asked.latest = 0.02;
    scenes.push_back(compared(50.0, 100.0));
    scenes[3].asked.peak = {};
    scenes[3].asked.outcome = "came down at once";
    scenes.push_back(compared(50.0, 100.0));
    scenes[4].reference.outcome = bench::kTooDear;
    CHECK(bench::peak_error(scenes[0]).value() == Approx(0.015));
    CHECK(bench::drop_error(scenes[0]).value() == Approx(0.01));
    CHECK(bench::is_branch(scenes[1]));
    CHECK(bench::is_lost(scenes[3]));
    CHECK_FALSE(bench::has_reference(scenes[4]));
    CHECK(bench::is_held(scenes[0]));
    CHECK_FALSE(bench::is_held(scenes[1])); // 0.2 % and nothing reported
    CHECK(bench::is_held(scenes[2]));       // 0.01 %: the reference is not known better

    const app::Table t = bench::error_table(scenes);
    const app::Row& all = t.rows.front();
    CHECK(number_in(all, 2) == 4.0);                  // scenes
    CHECK(number_in(all, 3) == 1.0);                  // lost
    CHECK(number_in(all, 4) == Approx(0.2));          // median [%]
    CHECK(number_in(all, 8) == Approx(1.5));          // largest [%]
    CHECK(number_in(all, 9) == Approx(50.0));         // within 1 %: two of four
    CHECK(number_in(all, 10) == Approx(75.0));        // within 3 %
    CHECK(number_in(all, 11) == Approx(200.0 / 3.0)); // reported
    CHECK(number_in(all, 12) == 2.0);                 // falls
    CHECK(number_in(all, 13) == Approx(50.0));        // within 2 %
    CHECK(number_in(all, 14) == Approx(50.0));        // within the range reported
    CHECK(number_in(all, 15) == 1.0);                 // branches
    CHECK(bench::worst_table(scenes).rows.size() == 3);
    CHECK(bench::apart_table(scenes).rows.size() == 3);
}

TEST_CASE("accuracy campaign: a wall far from its accuracy goes on to slower pushes",
          "[bench][accuracy]")
{
    const std::vector<std::string> small = {"solver.fidelity=rigid",
                                            "load.max_displacement=0.05 mm",
                                            "output.record_every=0.0005 mm"};
    const app::Study study = bench::study_of(bench::accuracy_scene(1, 193), small);
    const bench::Answer answer = bench::push_answer(study, study.solver, 60.0);
    // 13.36 kN at a twentieth of the accuracy; the second push has 14.13, within 12 % it says
    REQUIRE(answer.peak);
    CHECK(*answer.peak == Approx(13.36e3).epsilon(0.01));
}

TEST_CASE("accuracy campaign: quantiles are values that occur", "[bench][accuracy]")
{
    CHECK(bench::quantile_of({4.0, 1.0, 3.0, 2.0}, 0.5) == 2.0);
    CHECK(bench::quantile_of({4.0, 1.0, 3.0, 2.0}, 0.95) == 4.0);
    CHECK(bench::quantile_of({7.0}, 0.0) == 7.0);
    CHECK(std::isnan(bench::quantile_of({}, 0.5)));
}

TEST_CASE("accuracy campaign: a file gives back its answers, and none of other settings",
          "[bench][accuracy]")
{
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "drystone_accuracy_answers.csv";
    std::filesystem::remove(file);
    bench::Answer answer = compared(1.0 / 3.0, 1.0).asked;
    answer.steps = 12345;
    bench::Answer dear;
    dear.outcome = bench::kTooDear;
    dear.seconds = 10.0;
    {
        bench::AnswerFile out(file, false);
        out.add(7, "a", "slow", answer);
        out.add(8, "b", "slow", dear);
    }
    const bench::AnswerFile back(file, false), any(file, true);
    REQUIRE(back.find("a", "slow", 60.0));
    CHECK(back.find("a", "slow", 60.0)->peak == answer.peak);
    CHECK(back.find("a", "slow", 60.0)->steps == 12345);
    CHECK_FALSE(back.find("a", "slow", 60.0)->drop);
    CHECK_FALSE(back.find("a", "slower", 60.0));
    CHECK_FALSE(back.find("c", "slow", 60.0));
    CHECK_FALSE(back.find("b", "slow", 60.0)); // it may not be too dear with more time
    CHECK(back.find("b", "slow", 10.0));
    CHECK(any.find("a", "slower", 60.0));
    std::filesystem::remove(file);
}
