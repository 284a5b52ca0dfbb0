#include "app/calibration/calibration_output.hpp"
#include "app/calibration/calibration_pushes.hpp"
#include "app/calibration/test_notes.hpp"
#include "app/commands.hpp"
#include "app/input/command_line.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/study/stored/stress_text.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"
#include "app/text/csv.hpp"
#include "app/verbs.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/uq/latin_scene.hpp"
#include "uq/designs/stream.hpp"

#include "uq/surrogates/process_fit.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

app::Study study_of(const std::string& calibration, const std::string& uq = "samples = 25\n")
{
    return app::read_study(
        app::parse_study_text("study.ini", std::string(study_scenes::kSmall) + "[uq]\n" + uq +
                                               "[calibration]\n" + calibration));
}

app::CalibratedInputs inputs_of(const app::Study& study)
{
    return app::calibrated_inputs(study.calibration, study, study.source);
}

void refused(const std::string& calibration, const std::string& message,
             const std::string& uq = "samples = 25\n")
{
    CHECK_THROWS_WITH(inputs_of(study_of(calibration, uq)), Catch::Contains(message));
}

/// Points of a smooth answer of three inputs, the last of which does nothing.
app::AnswerPoints points(int n, double noise)
{
    app::AnswerPoints p;
    p.u = 4.0 * scenes::latin_hypercube(n, 3, 5).array() - 2.0;
    p.y = 3.0 + 0.2 * p.u.col(0).array() + 0.05 * p.u.col(1).array().square();
    uq::Stream random(3, 0, uq::Purpose::monte_carlo);
    for (double& y : p.y) y += noise * random.normal();
    return p;
}

/// Runs the verb in a folder, on the small wall.
class Calibrating {
  public:
    explicit Calibrating(const std::string& calibration)
    {
        std::ofstream(path("study.ini"))
            << study_scenes::kSmall << "[uq]\nsamples = 10\n[calibration]\n"
            << calibration;
    }
    [[nodiscard]] std::string path(const std::string& name) const
    {
        return (folder_.path / name).string();
    }
    int run(const std::string& tests, const std::string& from, const std::string& out,
            std::vector<std::string> more = {}) const
    {
        std::ofstream(path("tests.csv")) << tests;
        std::vector<std::string> words = {"calibrate", path(from), path("tests.csv"),
                                          "--out",     path(out),  "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        return app::calibrate_command(app::parse_command_line(app::verbs(), words));
    }
    [[nodiscard]] std::string text(const std::string& name) const
    {
        return scenes::read_text(folder_.path / name);
    }

  private:
    scenes::TemporaryFolder folder_;
};

const std::string kTwoInputs = "inputs = joint.friction_angle, unit.tensile_strength\n";
const std::string kPeaks = "wall,stress [MPa],peak [kN]\nA,0.5,17\nB,0.5,18\nC,1,29\n";

} // namespace

TEST_CASE(
    "calibration: coordinates of inputs have independent standard normal priors, and lead "
    "back",
    "[app][calibration]")
{
    const app::CalibratedInputs c = inputs_of(
        study_of("inputs = unit.tensile_strength, joint.friction_angle\n",
                 "samples = 25\npearson = joint.friction_angle unit.tensile_strength 0.6\n"));
    REQUIRE(c.inputs.size() == 2);
    CHECK(c.inputs[0].key == "joint.friction_angle"); // in the order of the keys
    CHECK_FALSE(c.all);
    const Eigen::Vector2d u(0.7, -1.1);
    const Eigen::VectorXd x = app::to_values(c, u);
    CHECK((app::to_coordinates(c, x) - u).norm() < 1e-9);
    // the first is its marginal's quantile, the second is drawn up with it
    CHECK(c.inputs[0].scale * x(0) == Approx(31.8 * (1.0 + 0.2 * 0.7)).epsilon(1e-3));
    CHECK(app::to_values(c, Eigen::Vector2d(2.0, 0.0))(1) >
          app::to_values(c, Eigen::Vector2d(0.0, 0.0))(1));
    CHECK(inputs_of(study_of("inputs = all\n")).all);
}

TEST_CASE("calibration: walls that are pushed again keep the correlation of the inputs that "
          "are not taught",
          "[app][calibration]")
{
    const app::PreparedStudy ready = app::prepare(
        study_of("inputs = joint.friction_angle\n",
                 "samples = 25\npearson = unit.tensile_strength unit.friction_angle 0.9\n"));
    const app::CalibratedInputs inputs = inputs_of(ready.study);
    const uq::SpatialPlan others =
        app::value_plan(ready.study, ready.study.source, ready.layout, false);
    const auto place = [&](const char* key) {
        return static_cast<std::size_t>(
            std::ranges::find(ready.study.random, key, &app::RandomInput::key) -
            ready.study.random.begin());
    };
    const std::size_t a = place("unit.tensile_strength"), b = place("unit.friction_angle");
    constexpr int kWalls = 2000;
    const Eigen::VectorXd u = Eigen::VectorXd::Constant(1, 0.5);
    Eigen::MatrixX2d drawn(kWalls, 2);
    for (int row = 0; row < kWalls; ++row) {
        const app::WallDraw wall = app::wall_at(others, inputs, u, 7, row);
        CHECK(wall.values[inputs.inputs[0].place] ==
              std::vector<double>{app::to_values(inputs, u)(0)});
        drawn.row(row) << wall.values[a].at(0), wall.values[b].at(0);
    }
    drawn.rowwise() -= drawn.colwise().mean();
    const double r =
        drawn.col(0).dot(drawn.col(1)) / (drawn.col(0).norm() * drawn.col(1).norm());
    CHECK(r == Approx(0.9).margin(0.017)); // 4 standard errors
}

TEST_CASE("calibration: walls that are pushed again keep the rows of uq.together",
          "[app][calibration]")
{
    std::string text = study_scenes::kSmall;
    const std::string old = "friction_angle = normal(mean 31.8 deg, cov 0.20)\n"
                            "stiffness_factor = normal(mean 1, cov 0.25)";
    text.replace(text.find(old), old.size(),
                 "friction_angle = empirical(33, 29, 31 deg)\n"
                 "stiffness_factor = empirical(0.8, 1.3, 1)");
    const app::PreparedStudy ready = app::prepare(app::read_study(app::parse_study_text(
        "study.ini", text + "[uq]\nsamples = 25\n"
                            "together = joint.friction_angle, joint.stiffness_factor\n"
                            "[calibration]\ninputs = unit.tensile_strength\n")));
    const app::CalibratedInputs inputs = inputs_of(ready.study);
    const uq::SpatialPlan others =
        app::value_plan(ready.study, ready.study.source, ready.layout, false);
    const Eigen::VectorXd u = Eigen::VectorXd::Constant(1, 0.5);
    std::set<double> seen;
    for (int row = 0; row < 50; ++row) {
        const app::WallDraw wall = app::wall_at(others, inputs, u, 7, row);
        const double angle = std::round(wall.values[0].at(0) * 180.0 / std::numbers::pi);
        CHECK(wall.values[1].at(0) == (angle == 33.0 ? 0.8 : angle == 29.0 ? 1.3 : 1.0));
        seen.insert(angle);
    }
    CHECK(seen == std::set{29.0, 31.0, 33.0});
}

TEST_CASE("calibration: all chains whose numbers are printed say whether they agree",
          "[app][calibration]")
{
    const app::Study study = study_of("inputs = joint.friction_angle\n");
    const app::CalibrationData data{};
    app::CalibrationRun run;
    for (uq::CalibrationPosterior* p : {&run.with.posterior, &run.without.posterior}) {
        p->r_hat = 1.002;
        p->effective = 900.0;
    }
    run.left_out.resize(study.load.vertical_stress.size());
    app::CalibrationReport report{};
    report.study = &study;
    report.data = &data;
    report.run = &run;
    CHECK_THAT(app::doubt_text(report), !Catch::Contains("Not converged"));
    run.left_out[0].converged = false;
    CHECK_THAT(
        app::doubt_text(report),
        Catch::Contains("Not converged: what the tests under the other stresses say of " +
                        app::stress_text(study.load.vertical_stress[0]) + ". Do not"));
    run.without.posterior.r_hat = 1.02;
    CHECK_THAT(app::doubt_text(report),
               Catch::Contains("Not converged: the chains without discrepancy"));
}

TEST_CASE("calibration: inputs that tests cannot teach are refused in plain words",
          "[app][calibration]")
{
    refused(
        "inputs = joint.fiction_angle\n",
        "study.ini:32: calibration.inputs: \"joint.fiction_angle\" is not a random input of "
        "this study; did you mean \"joint.friction_angle\"?");
    refused("inputs = all, joint.friction_angle\n", "names an input twice");
    refused("inputs = all\n", "varies from joint to joint",
            "samples = 25\nspatial = independent\n");
    refused("inputs = joint.friction_angle\n", "is correlated with unit.tensile_strength",
            "samples = 25\npearson = joint.friction_angle unit.tensile_strength 0.6\n");
    refused("inputs = all\n",
            "3 walls under each stress are too few to learn 5 inputs; write 25",
            "samples = 3\n");
    CHECK_THROWS_WITH(study_of("discrepancy = no\n"),
                      Catch::Contains("there is no calibration.inputs"));
}

TEST_CASE("calibration: a surrogate says how far it is off on walls left out",
          "[app][calibration]")
{
    const app::AnswerSurrogate smooth = app::fit_answer(points(40, 0.0));
    CHECK(smooth.q2 > 0.999);
    CHECK(smooth.left_out < 0.01);
    const app::AnswerSurrogate jerky = app::fit_answer(points(40, 0.1));
    CHECK(jerky.left_out > 0.07);
    CHECK(std::sqrt(app::noise_of(jerky)) == Approx(0.1).epsilon(0.4));
    // parameters that have seen the wall left out would promise too much
    const app::AnswerSurrogate few = app::fit_answer(points(20, 0.1));
    CHECK(few.inflation > 1.05 * uq::inflation_of(uq::leave_one_out(*few.process)));
    app::AnswerPoints same = points(40, 0.0);
    same.y.setConstant(2.5);
    const app::AnswerSurrogate constant = app::fit_answer(same);
    CHECK_FALSE(constant.process);
    const Eigen::Vector3d at(0.5, 0.5, 0.5);
    // what the process does not know is shared by all tests, or scatter of walls
    const auto shared = app::answer_model({smooth, jerky, constant}, true)(at),
               scatter = app::answer_model({smooth, jerky, constant}, false)(at);
    CHECK(shared.mean(0) == Approx(3.0 + 0.1 + 0.0125).epsilon(1e-3));
    CHECK(shared.mean(2) == 2.5);
    CHECK(shared.variance(1) - scatter.variance(1) ==
          Approx(app::noise_of(jerky)).epsilon(1e-9));
    CHECK(shared.variance(2) == 0.0);
}

TEST_CASE("calibration: what a surrogate misses is counted on walls that have the answer",
          "[app][calibration]")
{
    const uq::AnswerModel model = [](const Eigen::VectorXd&) {
        return uq::ModelAnswers{Eigen::VectorXd::Zero(2), Eigen::VectorXd::Zero(2)};
    };
    Eigen::MatrixXd pushed(3, 2);
    pushed << 0.3, std::nan(""), 0.4, -0.2, 0.0, std::nan("");
    const auto miss = app::missed(model, Eigen::MatrixXd::Zero(3, 1), pushed);
    CHECK(miss[0].walls == 3);
    CHECK(miss[0].root_mean_square == Approx(0.5 / std::sqrt(3.0)));
    CHECK(miss[1].walls == 1);
    CHECK(miss[1].root_mean_square == Approx(0.2));
}

TEST_CASE(
    "calibration: the verb teaches inputs, and its posterior is a study whose draws stand "
    "row by row",
    "[app][calibration]")
{
    const Calibrating c(kTwoInputs);
    CHECK_THROWS_WITH(c.run("stress [MPa],peak [kN]\n0.7,20\n", "study.ini", "out"),
                      Catch::Contains("tests.csv:2: stress: 0.7 MPa is none of the study's"));
    CHECK_FALSE(fs::exists(c.path("out"))); // before any wall is pushed
    REQUIRE(c.run(kPeaks, "study.ini", "out", {"--threads", "1"}) == 0);
    const std::string posterior = c.text("out/posterior.ini"),
                      draws = c.text("out/posterior.csv");
    CHECK(draws.starts_with("draw,joint.friction_angle [deg],unit.tensile_strength [MPa],"));
    for (const char* const name : {"calibration.csv", "inputs.md", "further_wall.tex",
                                   "scatter.csv", "evidence.csv", "inputs.svg", "peak.svg"})
        CHECK(fs::exists(c.path("out/" + std::string(name))));
    CHECK_THAT(posterior, Catch::Contains("model_factor_force      = lognormal(median 1, "));
    const app::Study study = app::read_study(app::parse_study_text("posterior.ini", posterior));
    CHECK(study.calibration.inputs.empty());
    const std::vector<std::uint32_t> sizes = {10};
    const app::SamplePlan plan = app::sample_plan(study, study.load, study.source,
                                                  app::layout_of(study, study.source), sizes);
    const auto& rows = plan.values.together.rows;
    REQUIRE(rows.size() == 200);
    for (int k = 0; k < 10; ++k) {
        const auto values = app::draw(plan, 0, k).values;
        const auto found = std::ranges::count_if(rows, [&](const std::vector<double>& row) {
            return row[0] == values[0].front() && row[1] == values[2].front();
        });
        CHECK(found >= 1);
    }
}

TEST_CASE("calibration: walls that are there give the same draws, on any threads",
          "[app][calibration][repeats]")
{
    const Calibrating c(kTwoInputs);
    REQUIRE(c.run(kPeaks, "study.ini", "out", {"--threads", "1"}) == 0);
    REQUIRE(c.run(kPeaks, "out/walls.h5", "again",
                  {"--threads", "3", "--set",
                   "calibration.inputs=joint.friction_angle, unit.tensile_strength"}) == 0);
    CHECK(c.text("again/posterior.csv") == c.text("out/posterior.csv"));
    const std::string posterior = c.text("out/posterior.ini");
    const std::size_t list = posterior.find("= empirical(");
    const std::string values = posterior.substr(list, posterior.find(')', list) - list);
    CHECK_THAT(c.text("again/posterior.ini"), Catch::Contains(values));
}

TEST_CASE("calibration: forces at displacements and energies of cycles are read off the path",
          "[app][calibration]")
{
    const app::Csv csv = app::parse_csv(
        "t.csv", "stress [MPa],force at 2 mm [kN],energy of cycle 2 [kJ],force at 0.5 % [kN]\n"
                 "0.5,7.5,0.02,NA\n0.5,,0.03,8\n");
    const std::vector<app::TestReading> readings = app::test_readings(csv, 1.0);
    REQUIRE(readings.size() == 3);
    CHECK(readings[0].displacement == Approx(0.002));
    CHECK(readings[1].cycle == 2);
    CHECK(readings[2].displacement == Approx(0.005));
    const std::vector<app::MeasuredTest> tests = app::measured_tests(csv, 1.0);
    const std::vector<app::TestedQuantity> all = app::tested_quantities(readings);
    REQUIRE(all.size() == 6);
    CHECK(*app::measured(all[3], tests[0]) == 7.5);
    CHECK(*app::measured(all[4], tests[1]) == Approx(30.0)); // J
    CHECK_FALSE(app::measured(all[5], tests[0]));
    CHECK(all[4].unit == "J");

    const app::WallReading wall;
    app::ReadingRules one_way, to_and_fro;
    to_and_fro.direction = 0;
    // a line of 4 kN/mm to 3 mm, to the right and to the left
    const std::vector<double> x = {0, 0.003}, left = {0, -0.003}, f = {0, 12e3},
                              back = {0, -12e3};
    CHECK(app::shown(all[3], {wall, x, f}, one_way) == Approx(8.0));
    one_way.direction = -1;
    CHECK(app::shown(all[3], {wall, left, back}, one_way) == Approx(8.0));
    CHECK(std::isnan(app::shown(all[5], {wall, left, back}, one_way))); // it ends before
    CHECK(std::isnan(app::shown(all[4], {wall, left, back}, one_way))); // it does not turn back
    // two loops of stiff and perfectly plastic walls: 4 x 10 kN x 1 mm, 4 x 10 kN x 2 mm
    std::vector<double> d = {0.0}, force = {10e3};
    for (const double a : {0.001, 0.002})
        for (const double to : {a, -a, 0.0}) {
            const double sign = to > d.back() ? 1.0 : -1.0;
            d.insert(d.end(), {d.back(), to});
            force.insert(force.end(), {sign * 10e3, sign * 10e3});
        }
    CHECK(app::shown(all[4], {wall, d, force}, to_and_fro) == Approx(80.0));
}

TEST_CASE("calibration: columns of the path that cannot be read are refused",
          "[app][calibration]")
{
    const auto refused = [](const std::string& head, const std::string& message) {
        CHECK_THROWS_WITH(
            app::measured_tests(app::parse_csv("t.csv", "stress [MPa]," + head + "\n0.5,1\n"),
                                1.0),
            Catch::Contains("t.csv:1: ") && Catch::Contains(message));
    };
    refused("force at 5 cans [kN]", "force at 5 cans [kN]: ");
    refused("force at 0 mm [kN]", "must be at a displacement above 0");
    refused("energy of cycle 0 [J]", "cycles count from 1; write e.g.");
    refused("energy of cycle 1 [Wh]", "is not in J or kJ");
    refused("force at 5 mm [N]", "is not in kN");
    CHECK_THROWS_WITH(
        app::measured_tests(
            app::parse_csv("t.csv", "stress [MPa],force at 5 mm,force at 5 mm [kN]\n0.5,1,1\n"),
            1.0),
        Catch::Contains("there are two such columns"));
    CHECK_THROWS_WITH(
        app::measured_tests(app::parse_csv("t.csv", "stress [MPa],force at 5 mm [kN]\n0.5,\n"),
                            1.0),
        Catch::Contains("t.csv:2: ") && Catch::Contains("nothing was measured in this row"));
}

TEST_CASE("calibration: heads of tests are known in any case", "[app][calibration]")
{
    const app::Csv csv = app::parse_csv(
        "t.csv", "Stress [MPa],PEAK [kN],Force at 5 mm [kN],Remark\n0.5,20,10,a\n");
    const auto tests = app::measured_tests(csv, 1.1);
    REQUIRE(tests.size() == 1);
    CHECK(tests[0].stress == 0.5e6);
    CHECK(tests[0].peak == 20.0);
    CHECK(tests[0].readings.at(0) == 10.0);
    CHECK(app::test_notes(csv, 1.1, true) == "note: t.csv:1: \"Remark\" is not read\n");
}

TEST_CASE("calibration: a loop or a force that the push cannot show is told before it",
          "[app][calibration]")
{
    const auto notes = [](const std::string& head, const std::vector<double>& targets) {
        const app::Csv csv = app::parse_csv("t.csv", "stress [MPa]," + head + "\n0.5,1,1\n");
        return app::protocol_notes(csv, app::test_readings(csv, 1.1),
                                   app::measured_tests(csv, 1.1), targets);
    };
    const std::vector<double> cycles = {0.002, -0.002, 0.005, -0.005, 0.0};
    CHECK(notes("energy of cycle 2 [J],force at 5 mm [kN]", cycles).empty());
    CHECK(
        notes("energy of cycle 3 [J],peak [kN]", cycles) ==
        "note: t.csv:1: energy of cycle 3: the study's push makes 2 closed loops; give it the "
        "amplitudes of the test, as load.targets; left out\n");
    CHECK_THAT(notes("energy of cycle 2 [J],peak [kN]", {0.002, -0.002, 0.005}),
               Catch::Contains("makes 1 closed loop;"));
    CHECK_THROWS_WITH(notes("energy of cycle 1 [J],force at 40 mm [kN]", {0.03}),
                      Catch::Contains("force at 40 mm: the study's push goes to 30 mm"));
}

TEST_CASE("calibration: the verb learns from a force at a displacement",
          "[app][calibration][repeats]") // chains are long; one under sanitizers is enough
{
    const Calibrating c(kTwoInputs);
    REQUIRE(c.run("stress [MPa],force at 2 mm [kN],force at 90 mm [kN]\n0.5,15,1\n1,22,NA\n",
                  "study.ini", "out", {"--threads", "1"}) == 0);
    CHECK_THAT(c.text("out/further_wall.csv"), Catch::Contains("force at 2 mm [kN],0.5,1,") &&
                                                   !Catch::Contains("force at 90 mm"));
    CHECK(fs::exists(c.path("out/force_at_2_mm.svg")));
}

TEST_CASE("calibration: the verb learns from the energy of a cycle, in J or kJ",
          "[app][calibration][slow]")
{
    const Calibrating c(kTwoInputs);
    std::string text = c.text("study.ini");
    text.replace(text.find("max_displacement = 4 mm"), 23, "targets = 1, -1, 2, -2, 0 mm");
    std::ofstream(c.path("study.ini")) << text;
    const std::string head = "stress [MPa],energy of cycle 2 [";
    // ten walls leave the scatter of loops as large as what friction does to them
    const std::vector<std::string> more = {"--threads", "1", "--set", "uq.samples=50"};
    REQUIRE(c.run(head + "J]\n0.5,40\n1,50\n", "study.ini", "little", more) == 0);
    // the prior of a further wall is the loop that the walls of the study made
    CHECK_THAT(c.text("little/further_wall.csv"),
               Catch::Contains("energy of cycle 2 [J],0.5,1,"));
    const std::string walls = "little/walls.h5";
    REQUIRE(c.run(head + "kJ]\n0.5,0.04\n1,0.05\n", walls, "kilo") == 0);
    CHECK(c.text("kilo/posterior.csv") == c.text("little/posterior.csv"));
    REQUIRE(c.run(head + "J]\n0.5,230\n1,250\n", walls, "much") == 0);
    // walls of strong joints hardly slip and lose less: the loop moves the friction both ways
    const auto friction = [&](const char* out, const char* column) {
        const app::Csv inputs =
            app::parse_csv("inputs.csv", c.text(out + std::string("/inputs.csv")));
        REQUIRE(inputs.rows.front().cells.front() == "joint.friction_angle [deg]");
        return app::number_at(inputs, inputs.rows.front(), app::find_column(inputs, column));
    };
    CHECK(friction("little", "without") > friction("little", "prior") + 3.0);
    CHECK(friction("much", "without") < friction("much", "prior") - 3.0);
}

TEST_CASE("calibration: the verb predicts under a further stress, and says what it cannot use",
          "[app][calibration][repeats]")
{
    // a law of closure has no value for each stress
    Calibrating c(kTwoInputs + "discrepancy = no\n");
    std::string text = c.text("study.ini");
    text.replace(text.find("wall_modulus = 768, 1057 MPa"), 28, "normal_stiffness = 8 GPa/m");
    std::ofstream(c.path("study.ini")) << text;
    REQUIRE(c.run("stress [MPa],peak [kN],drop [mm]\n0.5,17,3\n1,29,NA\n", "study.ini", "out",
                  {"--predict", "0.75 MPa", "--predict", "0.5 MPa"}) == 0);
    const std::string walls = c.text("out/further_wall.csv");
    CHECK_THAT(walls, Catch::Contains("\npeak force [kN],0.75,0,"));
    CHECK_THAT(walls, !Catch::Contains("displacement at the drop")); // all walls stood
    CHECK_THROWS_WITH(c.run(kPeaks, "out/walls.h5", "other", {"--predict", "0.75 MPa"}),
                      Catch::StartsWith("drystone: --predict: the walls of " + c.path("out") +
                                        "/walls.h5 have been pushed already; give the study "
                                        "file, or leave it out"));
    // by the order of the stresses, those of --set in the place of the study's, none twice
    const std::string stresses = walls.substr(walls.find('\n'));
    const auto place = [&](const char* stress) {
        return stresses.find("\npeak force [kN]," + std::string(stress) + ",");
    };
    CHECK(place("0.5") < place("0.75"));
    CHECK(place("0.75") < place("1"));
    CHECK(place("1") != std::string::npos);
    CHECK(std::ranges::count(stresses, '\n') == 4);
    CHECK_THROWS_WITH(c.run(kPeaks, "study.ini", "other", {"--predict", "0.75"}),
                      Catch::StartsWith("drystone: --predict: missing unit"));
    CHECK_THROWS_WITH(c.run(kPeaks, "study.ini", "other", {"--predict", "-1 MPa"}),
                      Catch::StartsWith("drystone: --predict: \"-1 MPa\" is out of range"));
    CHECK_THROWS_WITH(c.run("stress [MPa],drop [mm]\n0.5,3\n", "out/walls.h5", "other"),
                      Catch::Contains("no test is left to learn from. Not used, displacement "
                                      "at the drop under 0.50 MPa: 10 of 10 walls outlast"));
}
