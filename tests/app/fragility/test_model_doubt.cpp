#include "app/fragility/numbers/answer_table.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/numbers/model_doubt.hpp"
#include "app/fragility/numbers/sampling_errors.hpp"
#include "app/fragility/numbers/tested_walls.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study/model_factor_text.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_reading.hpp"
#include "app/study_scenes.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using app::Answer;
using scenes::cell;
using scenes::number_in;

namespace {

/// The walls of the tests, as a study has them.
app::Study tested(const std::string& more = "")
{
    std::string text = study_scenes::kSmall;
    text.replace(text.find("length = 0.60 m"), 15, "length = 1.00 m");
    text.replace(text.find("courses = 4"), 11, "courses = 10");
    return app::prepare(app::read_study(app::parse_study_text("study.ini", text + more))).study;
}

/// Whether the value of each wall lies in the 90 % interval that the other walls give.
std::vector<bool> others_hold(Answer answer, dem::Damping damping)
{
    const auto walls = app::tested_walls(answer, damping);
    const auto all = app::log_ratios(walls);
    std::vector<bool> held;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        auto others = walls;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        const auto posterior =
            fragility::hierarchical_posterior(app::log_ratios(others), app::kFactorPrior);
        const auto interval = fragility::predictive_interval(posterior, 0.90);
        const bool below = all[i].value < interval.lower && !all[i].at_least;
        held.push_back(!below && all[i].value < interval.upper);
    }
    return held;
}

} // namespace

TEST_CASE("model doubt: each test lies in the interval of 90 % that the others give",
          "[app][model_doubt][repeats]")
{
    for (const dem::Damping damping : {dem::Damping::combined, dem::Damping::local})
        CHECK(others_hold(Answer::drift, damping) == std::vector(5, true));
    CHECK(others_hold(Answer::force, dem::Damping::combined) == std::vector(7, true));
}

TEST_CASE("model doubt: the sentence on the tests has the ratios of its table",
          "[app][model_doubt]")
{
    // 68.6 / 83.1 and 22.7 / 15.4 kN; 9.28 / 16.8 and more than 22.65 / 22.3 mm
    const std::string text = app::tests_sentence(dem::Damping::combined);
    CHECK_THAT(text, Catch::Contains("7 walls of dry sandstone") &&
                         Catch::Contains("peak forces were 0.83 to 1.47 times") &&
                         Catch::Contains("of 5 of them 0.55 to more than 1.02 times"));
}

TEST_CASE("model doubt: the factor of the tests is theirs", "[app][model_doubt]")
{
    const auto drop =
        app::estimated_factor(app::tested_walls(Answer::drift, dem::Damping::combined));
    CHECK(drop.factor.median > 0.6);
    CHECK(drop.factor.median < 0.9); // the tests fell before the model's walls
    CHECK(drop.factor.dispersion > 0.3);
    CHECK(drop.factor.dispersion < 0.5);
    CHECK(drop.median.lower < drop.factor.median);
    CHECK(drop.median.upper > drop.factor.median);
    CHECK(drop.dispersion.lower < drop.factor.dispersion);
    CHECK(drop.dispersion.upper > drop.factor.dispersion);
    // doubled predictions halve the factor, and nothing else
    auto walls = app::tested_walls(Answer::drift, dem::Damping::combined);
    for (app::TestedWall& w : walls) w.predicted *= 2.0;
    const auto half = app::estimated_factor(walls);
    CHECK(half.factor.median == Approx(0.5 * drop.factor.median).epsilon(1e-9));
    CHECK(half.factor.dispersion == Approx(drop.factor.dispersion).epsilon(1e-9));
    // the drop that was not seen is a bound: without it the walls of the model stand too long
    walls = app::tested_walls(Answer::drift, dem::Damping::combined);
    std::erase_if(walls, [](const app::TestedWall& w) { return w.at_least; });
    CHECK(walls.size() == 4);
    CHECK(app::estimated_factor(walls).factor.median < drop.factor.median);
}

TEST_CASE("model doubt: the median corrects walls like those tested, and no others",
          "[app][model_doubt]")
{
    const auto like = app::applied_factor(tested(), 0.5e6, Answer::drift);
    CHECK(like.source == "tests");
    CHECK(like.factor.median < 0.9);
    const auto unlike = [&](const app::Study& study, double stress, const std::string& why) {
        const auto a = app::applied_factor(study, stress, Answer::drift);
        CHECK(a.source == "tests, median not applied");
        CHECK(a.factor.median == 1.0);
        CHECK(a.factor.dispersion == like.factor.dispersion);
        CHECK(a.factor.median_error ==
              Approx(std::hypot(like.factor.median_error, std::log(like.factor.median))));
        CHECK_THAT(a.unlike, Catch::Contains(why));
    };
    unlike(tested(), 0.2e6, "stress is 0.2 MPa, outside 0.4 to 1.5 MPa");
    unlike(study_scenes::study(""), 0.5e6, "length is 0.6 m, outside 0.75 to 1.25 m");
    app::Study study = tested();
    study.load.height = 2.0;
    unlike(study, 0.5e6, "load stands at 2 m, outside 0.8 to 1.4 m");
    study = tested();
    study.cracks.in_units = false;
    unlike(study, 0.5e6, "units cannot crack");
    study = tested();
    study.parameters.joint.tensile_strength = 1e5;
    unlike(study, 0.5e6, "joints are bonded");
    study = tested();
    study.geometry.rubble = true;
    unlike(study, 0.5e6, "not in courses");
    study = tested();
    study.load.amplitudes = {0.001};
    unlike(study, 0.5e6, "to and fro");
    CHECK(app::applied_factor(tested(), 0.15e6, Answer::force).source == "tests");
}

TEST_CASE("model doubt: a study gives its own factor, or none", "[app][model_doubt]")
{
    const auto of = [](const std::string& value) {
        return app::applied_factor(tested("[fragility]\nmodel_factor = " + value + "\n"), 0.5e6,
                                   Answer::drift);
    };
    CHECK(of("none").source == "none");
    CHECK(of("none").factor.dispersion == 0.0);
    CHECK(of("lognormal(median 0.8, sigma_log 0.4)").source == "given");
    CHECK(of("lognormal(median 0.8, sigma_log 0.4)").factor.median == Approx(0.8));
    CHECK(of("lognormal(median 0.8, sigma_log 0.4)").factor.dispersion == Approx(0.4));
    const auto refused = [&](const std::string& value, const std::string& why) {
        CHECK_THROWS_WITH(of(value),
                          Catch::StartsWith("study.ini:30: fragility.model_factor: ") &&
                              Catch::Contains(why));
    };
    refused("0.8", "is no factor of the model; write none, tests");
    refused("some", "is no factor of the model; write none, tests");
    refused("normal(mean 1, cov 0.1)", "is not a lognormal distribution");
    refused("lognormal(median 0.8, sigma_log 0.4, to 1)", "is not a lognormal distribution");
    refused("lognormal(median 80, sigma_log 0.4)", "test over prediction, in [0.05, 20]");
    refused("lognormal(median 0.8, sigma_log 40)", "in (0, 3]");
    refused("lognormal(median -1, sigma_log 0.4)", "median");
    CHECK(app::model_factor_text({0.8, 0.3, 0.4}) == "lognormal(median 0.8, sigma_log 0.5)");
}

TEST_CASE("model doubt: the table has the limit times the factor, and its doubt in parts",
          "[app][model_doubt]")
{
    app::DriftData data =
        scenes::drifts({{1.0, 2.0, 4.0, 2.0}, {}, {1.0, 1.2, -2.5, -2.5, -2.5}});
    data.groups[0].model = {{0.5, 0.4, 0.3}, "given", {}};
    data.groups[2].model = {{1.0, 0.4, 0.3}, "tests, median not applied", "they have openings"};
    const app::Table t = app::drift_doubt_table(data);
    REQUIRE(t.rows.size() == 3);
    CHECK(scenes::sound(t));
    const double beta = std::log(2.0) * std::sqrt(0.5);
    CHECK(number_in(t, 0, "median drift [%]").value == Approx(1.0).epsilon(2e-3));
    CHECK(number_in(t, 0, "material").value == Approx(beta).epsilon(3e-3));
    CHECK(number_in(t, 0, "sampling").value == Approx(beta / 2.0).epsilon(1e-6));
    CHECK(number_in(t, 0, "model").value == Approx(0.5).epsilon(1e-12));
    CHECK(number_in(t, 0, "total").value ==
          Approx(std::sqrt(1.25 * beta * beta + 0.25)).epsilon(2e-3));
    CHECK(cell(t, 0, "factor from") == "given");
    CHECK(cell(t, 1, "note") == "No wall gave a result.");
    CHECK_THAT(cell(t, 2, "note"), Catch::Contains("they have openings"));
    CHECK(cell(t, 2, "84 % drift [%]").starts_with(">="));
    const app::Table limits = app::performance_table(data);
    CHECK(number_in(limits, 0, "median drift [%]").value == Approx(2.0)); // of the walls alone
    CHECK(number_in(limits, 0, "total dispersion").value ==
          Approx(std::sqrt(1.25 * beta * beta + 0.25)).epsilon(1e-6));
}

TEST_CASE("model doubt: pelicun gets the factor's median and the total dispersion",
          "[app][model_doubt]")
{
    app::DriftData data = scenes::drifts({{1.0, 2.0, 4.0, 2.0}});
    data.groups[0].model = {{0.5, 0.4, 0.3}, "given", {}};
    const double beta = std::log(2.0) * std::sqrt(0.5);
    const std::string text = app::pelicun_csv(data);
    CHECK_THAT(text, Catch::Contains("lognormal,0.01,"));
    const auto at = text.find("lognormal,0.01,") + 15;
    CHECK(std::stod(text.substr(at)) ==
          Approx(std::sqrt(1.25 * beta * beta + 0.25)).epsilon(1e-5));
    CHECK_THAT(text, Catch::Contains("model 0.5, median times 0.5"));
}

TEST_CASE("model doubt: forces have a factor of their own", "[app][model_doubt]")
{
    app::StudyWalls walls = scenes::study_walls(20);
    walls.study.fragility.model_factor_force = "lognormal(median 2, sigma_log 0.1)";
    const app::Table with = app::force_doubt_table(walls);
    walls.study.fragility.model_factor_force = "none";
    const app::Table without = app::force_doubt_table(walls);
    REQUIRE(with.rows.size() == 2);
    CHECK(scenes::sound(with));
    CHECK(number_in(with, 0, "median peak [kN]").value ==
          Approx(2.0 * number_in(without, 0, "median peak [kN]").value).epsilon(1e-3));
    CHECK(number_in(with, 0, "model").value == Approx(0.1));
    CHECK(number_in(without, 0, "model").value == 0.0);
}

TEST_CASE("model doubt: of walls that all stood the bound is times the factor's median",
          "[app][model_doubt]")
{
    app::StudyWalls walls = scenes::study_walls(8);
    walls.study.fragility.model_factor = "lognormal(median 0.8, sigma_log 0.4)";
    walls.height = 1.0;
    for (app::StudyLevel& level : walls.levels)
        for (app::StudyWall& w : level.walls)
            w.reading.limits.assign(w.reading.limits.size(),
                                    {0.0035, fragility::Reading::censored, {}});
    const app::DriftData data = app::drift_data(walls);
    const app::Table answer = app::answer_table(walls, data);
    CHECK(cell(answer, 0, "paper ultimate drift [%]") == "> 0.28");
    const app::Table doubt = app::drift_doubt_table(data);
    CHECK(scenes::sound(doubt));
    CHECK(cell(doubt, 0, "median drift [%]") == ">= 0.280");
    CHECK(cell(doubt, 0, "84 % drift [%]").empty());
    CHECK(cell(doubt, 0, "note") == cell(app::performance_table(data), 0, "note"));
    for (app::StudyLevel& level : walls.levels) level.walls.resize(4); // 95 % needs five
    const app::DriftData few = app::drift_data(walls);
    CHECK(cell(app::answer_table(walls, few), 0, "paper ultimate drift [%]") ==
          "too few walls: 0.28 and more");
    CHECK(cell(app::drift_doubt_table(few), 0, "median drift [%]").empty());
}

TEST_CASE("model doubt: the answer of few walls that all fell is what they did, times the "
          "factor's median",
          "[app][model_doubt]")
{
    app::StudyWalls walls = scenes::study_walls(2);
    walls.study.fragility.model_factor = "lognormal(median 0.8, sigma_log 0.4)";
    walls.height = 1.0;
    for (app::StudyLevel& level : walls.levels)
        for (std::size_t i = 0; i < level.walls.size(); ++i)
            level.walls[i].reading.limits.assign(
                level.walls[i].reading.limits.size(),
                {i == 0 ? 0.005 : 0.003, fragility::Reading::observed, {}});
    const auto answer = [&] {
        return cell(app::answer_table(walls, app::drift_data(walls)), 0,
                    "paper ultimate drift [%]");
    };
    CHECK(answer() == "too few walls: 0.24 to 0.40");
    for (app::StudyLevel& level : walls.levels) level.walls.resize(1);
    CHECK(answer() == "too few walls: 0.40");
}

TEST_CASE("model doubt: two walls have no scatter that is known, and no 16 and 84 %",
          "[app][model_doubt]")
{
    app::DriftData data = scenes::drifts({{1.0, 2.0}, {1.5}});
    for (app::DriftGroup& g : data.groups) g.model = {{0.5, 0.4, 0.3}, "given", {}};
    const app::Table doubt = app::drift_doubt_table(data);
    const app::Table limits = app::performance_table(data);
    REQUIRE(doubt.rows.size() == 2);
    for (const std::size_t r : {0U, 1U}) {
        CHECK_THAT(cell(doubt, r, "note"), Catch::Contains("a curve needs 3 walls"));
        CHECK(cell(doubt, r, "note") == cell(limits, r, "note"));
        for (const char* const head :
             {"median drift [%]", "16 % drift [%]", "84 % drift [%]", "material", "total"})
            CHECK(cell(doubt, r, head).empty());
    }
}

TEST_CASE("model doubt: pelicun reads the row of the table, of a mixture too",
          "[app][model_doubt]")
{
    app::DriftData data = scenes::drifts({{}});
    data.groups[0].model = {{0.5, 0.4, 0.3}, "given", {}};
    data.modes = {"rocking", "mixed"};
    for (int i = -8; i <= 8; ++i) {
        const double x = std::exp(0.05 * i);
        data.groups[0].walls.push_back({1, {fragility::observed(1.5 * x * x)}});
        if (i % 2 == 0) data.groups[0].walls.push_back({0, {fragility::observed(9.0 * x)}});
    }
    const app::Table t = app::drift_doubt_table(data);
    const std::string text = app::pelicun_csv(data);
    const auto at = text.find(",lognormal,");
    REQUIRE(at != std::string::npos);
    std::size_t read = 0;
    const double median = std::stod(text.substr(at + 11), &read);
    CHECK(median == Approx(0.01 * number_in(t, 0, "median drift [%]").value).epsilon(1e-5));
    CHECK(std::stod(text.substr(at + 12 + read)) ==
          Approx(number_in(t, 0, "total").value).epsilon(1e-5));
    CHECK_THAT(text, Catch::Contains("rad,0,1,lognormal") && Catch::Contains(",0,Peak"));
}

TEST_CASE("model doubt: intervals of few peaks hold as often as they say",
          "[app][model_doubt][repeats]")
{
    app::StudyWalls walls = scenes::study_walls(3);
    walls.study.fragility.model_factor_force = "none";
    walls.levels.resize(1);
    constexpr int kStudies = 1000;
    constexpr double kMedian = 50.0, kScatter = 0.2;
    std::mt19937_64 random(20);
    const auto normal = [&] { // Box and Muller: the same with every library
        const auto uniform = [&] {
            return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
        };
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    };
    int medians = 0, further = 0;
    for (int i = 0; i < kStudies; ++i) {
        for (app::StudyWall& w : walls.levels[0].walls)
            w.reading.peak =
                fragility::Peak{1e3 * kMedian * std::exp(kScatter * normal()), 0.01, false};
        const app::Table t = app::force_doubt_table(walls);
        const app::Number median = number_in(t, 0, "median peak [kN]");
        medians += median.lower <= kMedian && kMedian <= median.upper ? 1 : 0;
        const double next = kMedian * std::exp(kScatter * normal());
        further += number_in(t, 0, "16 % peak [kN]").value <= next &&
                           next <= number_in(t, 0, "84 % peak [kN]").value
                       ? 1
                       : 0;
    }
    // 95 and 68 %, within three standard errors; the normal quantile held 78 and 57 %
    CHECK(medians / double{kStudies} == Approx(0.95).margin(0.021));
    CHECK(further / double{kStudies} == Approx(0.68).margin(0.044));
}

TEST_CASE("model doubt: too few walls do not tell the error under a hypercube",
          "[app][model_doubt]")
{
    // two inputs: 4 (2 + 1) walls are needed
    const app::Table few = app::sampling_error_table(scenes::study_walls(11));
    const app::Table enough = app::sampling_error_table(scenes::study_walls(12));
    CHECK(cell(few, 0, "error, hypercube").empty());
    CHECK_FALSE(cell(few, 0, "error, independent walls").empty());
    CHECK_THAT(cell(few, 0, "note"), Catch::Contains("Fewer than 4 (inputs + 1) = 12 walls"));
    CHECK_FALSE(cell(enough, 0, "error, hypercube").empty());
}
