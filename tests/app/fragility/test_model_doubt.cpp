#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/numbers/model_doubt.hpp"
#include "app/fragility/numbers/tested_walls.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study/model_factor_text.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_reading.hpp"
#include "app/study_scenes.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
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
    app::DriftData data = scenes::drifts({{1.0, 2.0, 4.0, 2.0}, {}, {1.0, -2.5, -2.5, -2.5}});
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
