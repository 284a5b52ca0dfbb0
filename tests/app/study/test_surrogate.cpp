#include "app/input/keys/study_keys.hpp"
#include "app/input/study/units.hpp"
#include "app/output/atomic_output.hpp"
#include "app/study_scenes.hpp"
#include "app/surrogate/learned_surrogate.hpp"
#include "app/surrogate/surrogate_fit.hpp"
#include "app/surrogate/surrogate_output.hpp"
#include "app/text/config_error.hpp"
#include "app/text/text_file.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/uq/latin_scene.hpp"
#include "uq/designs/stream.hpp"
#include "uq/sensitivity/hsic.hpp"
#include "uq/surrogates/process_fit.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace app;

namespace {

SurrogatePoints points(int n, int d)
{
    SurrogatePoints p;
    p.coordinates = 2.0 * scenes::latin_hypercube(n, d, 5).array() - 1.0;
    p.x = p.coordinates;
    for (int i = 0; i < n; ++i) p.sample.push_back(static_cast<std::uint32_t>(i));
    p.y = 50.0 + 5.0 * p.x.col(0).array() + p.x.col(1).array().square();
    return p;
}

LevelSurrogate fitted(SurrogatePoints p, bool dependent = false)
{
    const std::vector<uq::PolynomialFamily> families(static_cast<std::size_t>(p.x.cols()),
                                                     uq::PolynomialFamily::legendre);
    return fit_surrogate(std::move(p), families, dependent, 1);
}

/// Walls of the small study under one stress, with a smooth peak force.
StudyWalls smooth_walls(int n, const std::string& text = study_scenes::kSmall)
{
    StudyWalls walls;
    walls.name = "smooth.h5";
    walls.study = study_scenes::study("samples = 8", text);
    walls.height = 1.1;
    for (const RandomInput& r : walls.study.random) {
        const Key& key = *find_key(r.key);
        walls.inputs.push_back({r.key, key.unit.empty() ? "-" : std::string(key.unit),
                                key.unit.empty() ? 1.0 : from_si(1.0, key.unit),
                                walls.inputs.size(), 1, r.marginal});
    }
    const auto d = static_cast<int>(walls.inputs.size());
    const Eigen::MatrixXd u = scenes::latin_hypercube(n, d, 7);
    StudyLevel level;
    level.stress = 0.5e6;
    for (int i = 0; i < n; ++i) {
        StudyWall w;
        w.key = {0, static_cast<std::uint32_t>(i)};
        for (int k = 0; k < d; ++k)
            w.inputs.push_back(
                walls.inputs[static_cast<std::size_t>(k)].scale *
                uq::quantile(*walls.inputs[static_cast<std::size_t>(k)].marginal, u(i, k)));
        w.reading.mode =
            u(i, 0) + 0.3 * u(i, 2) > 0.7 ? dem::FailureMode::mixed : dem::FailureMode::rocking;
        w.reading.peak =
            fragility::Peak{20e3 * (1.0 + u(i, 0) + std::sin(3.0 * u(i, 1))), 0.01, false};
        level.walls.push_back(w);
    }
    walls.levels.push_back(level);
    return walls;
}

} // namespace

TEST_CASE("surrogate: a smooth response is learned and trusted", "[app][surrogate]")
{
    const LevelSurrogate s = fitted(points(60, 3));
    CHECK(s.doubts.empty());
    CHECK(s.no_indices.empty());
    CHECK(s.chaos_error.q2 > 0.9999);
    CHECK(s.process_error.q2 > 0.999);
    CHECK((s.left_out - s.points.y).norm() < 0.01 * s.points.y.norm());
    REQUIRE(s.given.size() == 3);
    CHECK(s.given[0].p_value < kDependsLevel);
    CHECK(s.given[0].rank.has_value());
    CHECK(s.given[0].hsic.has_value());
    CHECK(s.given[2].p_value > kDependsLevel); // the third input does nothing
    CHECK_FALSE(s.given[2].rank.has_value());  // and has no index, whatever the estimate is
    CHECK_FALSE(s.given[2].hsic.has_value());
}

TEST_CASE("surrogate: a law that goes up and down is seen, though HSIC misses it",
          "[app][surrogate]")
{
    SurrogatePoints p = points(100, 2);
    p.y = (4.0 * M_PI * p.x.col(0).array()).sin();
    p.no_coordinates = "Not asked for.";
    const LevelSurrogate s = fitted(p);
    CHECK(uq::hsic(p.x.col(0), p.y).p_value > kDependsLevel);
    REQUIRE(s.given.size() == 2);
    CHECK(s.given[0].p_value < 1e-3);
    REQUIRE(s.given[0].rank);
    CHECK(s.given[0].rank->value > 0.6);
    CHECK_FALSE(s.given[1].rank);
}

TEST_CASE("surrogate: doubts are said in words, and no index is given", "[app][surrogate]")
{
    SurrogatePoints p = points(60, 3);
    std::string expected;
    SECTION("constant")
    {
        p.y.setConstant(7.0);
        expected = "same on all walls";
    }
    SECTION("three walls")
    {
        p = points(3, 2);
        expected = "Only 3 walls";
    }
    SECTION("ten inputs")
    {
        p = points(40, 10);
        expected = "fewer than 5 for each of 10";
    }
    SECTION("noise")
    {
        uq::Stream s(3, 0, uq::Purpose::monte_carlo);
        for (double& y : p.y) y = s.normal();
        expected = "less than half of the variance";
    }
    SECTION("two heaps that the inputs do not tell apart")
    {
        uq::Stream s(3, 0, uq::Purpose::monte_carlo);
        for (double& y : p.y) y = 20.0 * static_cast<double>(s.below(2)) + s.normal();
        expected = "two heaps";
    }
    const LevelSurrogate s = fitted(p);
    REQUIRE_FALSE(s.doubts.empty());
    CHECK(s.doubts.back().find(expected) != std::string::npos);
    CHECK_FALSE(s.no_indices.empty());
}

TEST_CASE("surrogate: dependent inputs have no shares of the variance", "[app][surrogate]")
{
    const LevelSurrogate s = fitted(points(60, 3), true);
    CHECK(s.doubts.empty());
    CHECK(s.no_indices.find("depend on each other") != std::string::npos);
}

TEST_CASE("surrogate: inputs without coordinates have indices from the walls alone",
          "[app][surrogate]")
{
    SurrogatePoints p = points(60, 3);
    p.no_coordinates = "Inputs vary from joint to joint.";
    const LevelSurrogate s = fitted(p);
    CHECK_FALSE(s.chaos);
    CHECK_FALSE(s.process);
    CHECK(s.doubts == std::vector<std::string>{p.no_coordinates});
    CHECK(s.no_indices == p.no_coordinates);
    REQUIRE(s.given.size() == 3);
    CHECK(s.given[0].rank.has_value());
    CHECK(s.given[0].hsic.has_value());
}

TEST_CASE("surrogate: an unknown response is named with those that there are",
          "[app][surrogate]")
{
    CHECK(surrogate_response("ultimate_drift").unit.name == "%");
    CHECK_THROWS_WITH(surrogate_response("peak_forse"),
                      Catch::Contains("--of") && Catch::Contains("peak_force"));
}

TEST_CASE("surrogate: the file predicts what the fit does, to the bit, and its own doubt",
          "[app][surrogate]")
{
    const scenes::TemporaryFolder folder;
    const StudyWalls walls = smooth_walls(60);
    const WallNumber& response = surrogate_response("peak_force");
    SurrogateStudy s = surrogate_study(walls, response);
    LevelSurrogate& level = s.levels.front();
    REQUIRE(level.process);
    REQUIRE(level.chaos);
    const std::string path = (folder.path / "surrogate.json").string();
    Eigen::MatrixXd x = level.points.x; // in SI
    for (std::size_t k = 0; k < s.inputs.size(); ++k)
        x.col(static_cast<Eigen::Index>(k)) /= walls.inputs[s.inputs[k]].scale;
    for (const bool chaos : {false, true}) {
        level.chaos_is_better = chaos;
        write_file(path, surrogate_json(s));
        const LearnedSurrogate learned = read_surrogate(path);
        REQUIRE(learned.levels.size() == 1);
        const SurrogateAnswers a = predict(learned, learned.levels.front(), x);
        const Eigen::VectorXd direct =
            chaos ? uq::predict(level.chaos->chaos, surrogate_coordinates(learned, x))
                  : uq::predict_mean(*level.process, surrogate_coordinates(learned, x));
        CHECK(a.mean == direct / learned.scale);
        CHECK(a.outside.sum() == 0);
        // 95 % of walls left out lie within two of their standard deviations
        CHECK(a.sd.minCoeff() * learned.scale >=
              (chaos ? level.chaos_error.rmse * (1.0 - 1e-12)
                     : std::sqrt(level.process->parameters.noise)));
        Eigen::MatrixXd far = x.topRows(1);
        far(0, 0) = learned.levels.front().most(0) * 1.01;
        CHECK(predict(learned, learned.levels.front(), far).outside(0) == 1);
        CHECK_THROWS_WITH(predict(learned, learned.levels.front(), x.leftCols(1)),
                          Catch::Contains("inputs, and 1 are given"));
    }
}

TEST_CASE("surrogate: Jacobi's coordinate and noise that grows come back from the file",
          "[app][surrogate]")
{
    std::string text = study_scenes::kSmall;
    const std::string normal = "normal(mean 31.8 deg, cov 0.20)";
    text.replace(text.find(normal), normal.size(),
                 "beta(mean 31.8 deg, cov 0.20, lower 15 deg, upper 50 deg)");
    const scenes::TemporaryFolder folder;
    StudyWalls walls = smooth_walls(150, text);
    uq::Stream scatter(4, 0, uq::Purpose::monte_carlo);
    for (StudyWall& w : walls.levels.front().walls) // by the angle, whose mean is 0.555
        w.reading.peak->force +=
            400.0 * std::exp2(8.0 * (w.inputs[0] / walls.inputs[0].scale - 0.555)) *
            scatter.normal();
    SurrogateStudy s = surrogate_study(walls, surrogate_response("peak_force"));
    LevelSurrogate& level = s.levels.front();
    REQUIRE(level.process);
    REQUIRE(level.process->parameters.noise_slopes.size() == 5);
    CHECK(level.process->parameters.noise_slopes(0) > 0.5);
    level.chaos_is_better = false;
    const std::string path = (folder.path / "surrogate.json").string();
    write_file(path, surrogate_json(s));
    const LearnedSurrogate learned = read_surrogate(path);
    CHECK(learned.inputs[0].family.kind == uq::PolynomialFamily::jacobi);
    Eigen::MatrixXd x = level.points.x;
    for (std::size_t k = 0; k < s.inputs.size(); ++k)
        x.col(static_cast<Eigen::Index>(k)) /= walls.inputs[s.inputs[k]].scale;
    const Eigen::MatrixXd c = surrogate_coordinates(learned, x);
    const SurrogateAnswers a = predict(learned, learned.levels.front(), x);
    const Eigen::VectorXd noise = uq::noise_at(level.process->parameters, c);
    const uq::ProcessPrediction p = uq::predict(*level.process, c);
    const double inflation = uq::inflation_of(uq::held_out(*level.process));
    CHECK(level.inflation == inflation);
    CHECK(learned.levels.front().inflation == inflation);
    CHECK(noise.maxCoeff() > 4.0 * noise.minCoeff());
    for (Eigen::Index i = 0; i < x.rows(); ++i)
        CHECK(a.sd(i) * learned.scale ==
              Approx(std::sqrt(inflation * (p.variance(i) + noise(i)))).epsilon(1e-12));
    // a version that knows neither refuses the file; a family of another law is damage
    std::string bytes = read_small_file(path);
    CHECK(bytes.find("drystone surrogate 2") != std::string::npos);
    const std::size_t at = bytes.find("jacobi ");
    REQUIRE(at != std::string::npos);
    bytes.insert(at + 7, "1");
    write_file(path, bytes);
    CHECK_THROWS_WITH(read_surrogate(path), Catch::Contains("is not of its distribution"));
}

TEST_CASE("surrogate: modes that follow from the inputs are told, with their doubt",
          "[app][surrogate]")
{
    const scenes::TemporaryFolder folder;
    const StudyWalls walls = smooth_walls(100);
    const SurrogateStudy s = surrogate_study(walls, surrogate_response("peak_force"));
    const ModeSurrogate& m = s.modes.front();
    REQUIRE(m.none.empty());
    CHECK(m.modes == std::vector{kRocking, kMixed});
    CHECK(m.walls == 100);
    CHECK(m.right > 0.9);
    CHECK(m.right < 1.0); // errors are those on walls left out
    CHECK(m.skill > 0.6);
    CHECK(m.doubts.empty());
    // the file says what the model does
    const std::string path = (folder.path / "surrogate.json").string();
    write_file(path, surrogate_json(s));
    const LearnedSurrogate learned = read_surrogate(path);
    Eigen::MatrixXd x = s.levels.front().points.x.topRows(5);
    for (std::size_t k = 0; k < s.inputs.size(); ++k)
        x.col(static_cast<Eigen::Index>(k)) /= walls.inputs[s.inputs[k]].scale;
    const ModeAnswers a = predict_modes(learned, learned.levels.front(), x);
    const Eigen::MatrixXd c = surrogate_coordinates(learned, x);
    for (int i = 0; i < 5; ++i) {
        const auto p = fragility::mode_probability(m.model, 1, c.row(i).transpose());
        CHECK(a.probability(i, 1) == p.value);
        CHECK(a.sd(i, 1) == p.std_error);
        CHECK(a.probability.row(i).sum() == Approx(1.0).epsilon(1e-12));
    }
}

TEST_CASE(
    "surrogate: modes that no input tells apart, one mode and few walls are said in words",
    "[app][surrogate]")
{
    StudyWalls walls = smooth_walls(60);
    uq::Stream random(3, 0, uq::Purpose::monte_carlo);
    for (StudyWall& w : walls.levels.front().walls)
        w.reading.mode = static_cast<dem::FailureMode>(random.below(3));
    const std::vector<std::size_t> inputs = surrogate_inputs(walls);
    const ModeSurrogate chance = fit_mode_surrogate(mode_points(walls, 0, inputs));
    CHECK(chance.none.empty());
    CHECK(chance.modes.size() == 3);
    REQUIRE(chance.doubts.size() == 1);
    CHECK(chance.doubts.front().starts_with("The inputs do not tell the modes of walls left"));
    for (StudyWall& w : walls.levels.front().walls) w.reading.mode = dem::FailureMode::sliding;
    CHECK(fit_mode_surrogate(mode_points(walls, 0, inputs)).none ==
          "The mode is the same on all 60 walls: sliding.");
    CHECK(fit_mode_surrogate(mode_points(walls, 0, inputs, 9)).none ==
          "Only 9 walls have a mode; a model of them needs at least 10.");
    walls.study.uq.spatial = Spatial::independent;
    walls.levels.front().walls.front().reading.mode = dem::FailureMode::mixed;
    CHECK(fit_mode_surrogate(mode_points(walls, 0, inputs))
              .none.starts_with("Inputs vary from joint to joint"));
}

TEST_CASE("surrogate: a spatial study in which no wall has the response says so",
          "[app][surrogate]")
{
    StudyWalls walls = smooth_walls(30);
    walls.study.uq.spatial = Spatial::independent;
    const SurrogateStudy s = surrogate_study(walls, surrogate_response("ultimate_drift"));
    CHECK(s.levels.front().doubts ==
          std::vector<std::string>{
              "Only 0 walls have the response; a surrogate needs at least 10."});
}

TEST_CASE("surrogate: nothing is said to be learned where no wall can be predicted",
          "[app][surrogate]")
{
    using Catch::Matchers::Contains;
    StudyWalls walls = smooth_walls(9);
    for (StudyWall& w : walls.levels.front().walls) {
        w.reading.mode = dem::FailureMode::sliding;
        w.reading.peak->at_end = w.key.sample > 0;
    }
    const SurrogateStudy s = surrogate_study(walls, surrogate_response("peak_force"));
    CHECK(!predicts(s));
    CHECK(s.levels.front().doubts ==
          std::vector<std::string>{
              "Only 1 wall has the response; a surrogate needs at least 10."});
    CHECK_THAT(surrogate_remarks(s),
               Contains(" sample 5 and 3 more. Push further to keep them.") &&
                   !Contains("What is learned"));
    walls = smooth_walls(60);
    walls.levels.front().walls.front().reading.peak->at_end = true;
    const SurrogateStudy learned = surrogate_study(walls, surrogate_response("peak_force"));
    CHECK(predicts(learned));
    CHECK_THAT(surrogate_remarks(learned),
               Contains(" sample 0. What is learned holds for the others; push further"));
}

TEST_CASE(
    "surrogate: walls that stand there twice are learned from, walls without a number are "
    "named and left out",
    "[app][surrogate]")
{
    StudyWalls walls = smooth_walls(60);
    std::vector<StudyWall>& all = walls.levels.front().walls;
    for (std::size_t i = 0; i < 20; ++i) {
        all.push_back(all[i]);
        all.back().key.sample += 1000;
    }
    all[3].reading.peak.reset();
    all[4].reading.peak->force = std::nan("");
    const SurrogateStudy s = surrogate_study(walls, surrogate_response("peak_force"));
    const LevelSurrogate& level = s.levels.front();
    CHECK(level.doubts.empty());
    CHECK(level.points.y.size() == 78);
    CHECK(level.left_out.allFinite());
    CHECK(std::max(level.chaos_error.q2, level.process_error.q2) > 0.99);
    CHECK(left_out_text(s, level).find("2 walls have no peak force and are left out: 0.50 MPa "
                                       "sample 3, 0.50 MPa sample 4") != std::string::npos);
}

TEST_CASE("surrogate: a study of more walls than asked for is learned from the first",
          "[app][surrogate]")
{
    const StudyWalls walls = smooth_walls(60);
    const SurrogateStudy s = surrogate_study(walls, surrogate_response("peak_force"), 40);
    CHECK(s.levels.front().points.y.size() == 40);
    CHECK(s.modes.front().walls == 40);
    CHECK(left_out_text(s, s.levels.front())
              .find("learned from the first 40 walls; 20 more are in the file") !=
          std::string::npos);
}

TEST_CASE("surrogate: files that are none are refused in plain words", "[app][surrogate]")
{
    const scenes::TemporaryFolder folder;
    const std::string path = (folder.path / "s.json").string();
    const auto refused = [&](const std::string& text, const std::string& message) {
        write_file(path, text);
        CHECK_THROWS_WITH(read_surrogate(path),
                          Catch::StartsWith(path + ": ") && Catch::Contains(message));
    };
    refused("{}", "is not a surrogate; give the surrogate.json");
    refused("{\"format\": \"drystone surrogate 1\"}", "is damaged: ");
    refused("][", "is damaged: ");
    refused("{\"format\": \"drystone surrogate 1\", \"study\": \"s.h5\", \"response\": "
            "\"peak_force\", \"unit\": \"kN\", \"inputs\": [{\"key\": \"joint.fiction\", "
            "\"unit\": \"deg\", \"distribution\": \"\"}], \"surrogates\": []}",
            "joint.fiction: is not a key of this version");
    CHECK_THROWS_WITH(read_surrogate(path + "x"), Catch::Contains("surrogate.json that"));
}
