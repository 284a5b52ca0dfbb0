#include "app/commands.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/reliability/event.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"
#include "tests/scenes/temporary_folder.hpp"
#include "tests/scenes/terminal.hpp"
#include "uq/reliability/reliability.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numbers>
#include <span>
#include <sstream>
#include <string>
#include <vector>

using uq::ReliabilityAnswer;
using uq::ReliabilityProblem;

namespace {

ReliabilityAnswer answer(const ReliabilityProblem& p, std::vector<uq::Evaluated>& seen)
{
    return uq::reliability(p, [&](std::span<const uq::Evaluated> batch) {
        seen.insert(seen.end(), batch.begin(), batch.end());
    });
}

app::Study reliability(const std::string& text, const std::string& uq = "")
{
    std::string all = study_scenes::kSmall;
    return app::prepare(
               app::read_study(app::parse_study_text(
                   "study.ini", all + "[uq]\nseed = 2\n" + uq + "[reliability]\n" + text)))
        .study;
}

ReliabilityProblem problem_at(const app::Study& study, const std::string& level)
{
    return wall_problem(app::prepare(study), level, 2);
}

std::string complaint(const std::string& text, const std::string& uq = "")
{
    try {
        (void)problem_at(reliability(text, uq), "0.50 MPa");
    } catch (const app::ConfigError& e) {
        return e.what();
    }
    return "none";
}

/// A program that answers r - s, as a shell script.
struct Script {
    scenes::TemporaryFolder folder;
    std::filesystem::path path = folder.path / "model.sh";
    Script()
    {
        std::ofstream(path) << R"(#!/bin/sh
awk -F'[:,]' '/"r"/ {r = $2} /"s"/ {s = $2} END {printf "{\"responses\": {\"g\": %.17g}}\n", r - s}' "$1"
)";
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    }
};

app::StudyFile external(const Script& script, const std::string& more)
{
    return app::parse_study_text("external.ini", "[model]\ncommand = " + script.path.string() +
                                                     " {input}\nresponses = g\n[variables]\n"
                                                     "r = normal(mean 4, sd 1)\n"
                                                     "s = normal(mean 2, sd 1)\n" +
                                                     more);
}

uq::ReliabilityProblem event_of(const app::Study& study, int threads)
{
    return app::program_event(study, study.program, study.reliability, study.source, threads);
}

} // namespace

TEST_CASE("reliability: of another program, R - S has beta = sqrt 2 and equal shares",
          "[app][reliability]")
{
    const Script script;
    const app::StudyFile file = external(script, "[reliability]\nmethod = form\ndemand = 0\n");
    REQUIRE(app::is_program_study(file));
    std::vector<uq::Evaluated> seen;
    const ReliabilityAnswer a = answer(event_of(app::read_program_study(file), 2), seen);
    REQUIRE(a.methods.front().probability);
    CHECK(*a.methods.front().probability == Approx(7.864960352514e-2).epsilon(1e-7));
    REQUIRE(a.sensitivities.size() == 1);
    REQUIRE(a.sensitivities[0].shares.size() == 2);
    CHECK(a.sensitivities[0].shares[0].value == Approx(0.5).margin(1e-6));
    REQUIRE(a.points.size() == 1);
    CHECK(a.points[0].x(0) == Approx(3.0).margin(1e-5)); // halfway between both means
    CHECK(a.points[0].x(1) == Approx(3.0).margin(1e-5));
    CHECK(seen.size() == a.evaluations);
    CHECK(a.failed.empty());
}

TEST_CASE("reliability: single and double quotes hold the words of a command together",
          "[app][reliability]")
{
    const Script script;
    const std::string path = script.path.string();
    const auto form_of = [](const std::string& command) {
        const app::StudyFile file = app::parse_study_text(
            "external.ini",
            "[model]\ncommand = " + command +
                "\nresponses = g\n[variables]\nr = normal(mean 4, sd 1)\n"
                "s = normal(mean 2, sd 1)\n[reliability]\nmethod = form\ndemand = 0\n");
        std::vector<uq::Evaluated> seen;
        return answer(event_of(app::read_program_study(file), 2), seen);
    };
    for (const std::string& command :
         {"sh -c '" + path + " \"$0\"' {input}", "sh -c \"" + path + " '{input}'\""}) {
        INFO(command);
        const ReliabilityAnswer a = form_of(command);
        REQUIRE(a.methods.front().probability);
        CHECK(*a.methods.front().probability == Approx(7.864960352514e-2).epsilon(1e-7));
    }
    CHECK_THROWS_WITH(form_of("sh -c '" + path),
                      Catch::Matchers::Contains("a quote is not closed"));
}

TEST_CASE("reliability: correlated variables of another program, R - S with rho = 0.5",
          "[app][reliability]")
{
    const Script script;
    const app::StudyFile file = external(script, "[reliability]\nmethod = form\ndemand = 0\n"
                                                 "[uq]\npearson = r s 0.5\n");
    std::vector<uq::Evaluated> seen;
    const ReliabilityAnswer a = answer(event_of(app::read_program_study(file), 2), seen);
    REQUIRE(a.methods.front().probability);
    // beta = 2 / sqrt(1 + 1 - 2 rho) = 2
    CHECK(*a.methods.front().probability == Approx(2.275013194818e-2).epsilon(1e-6));
}

TEST_CASE("reliability: faults of a study of another program are named", "[app][reliability]")
{
    const Script script;
    const auto said = [&](const std::string& more) {
        try {
            (void)event_of(app::read_program_study(external(script, more)), 2);
        } catch (const app::ConfigError& e) {
            return std::string(e.what());
        }
        return std::string("none");
    };
    CHECK(said("").find("reliability.demand: missing") != std::string::npos);
    CHECK(said("[reliability]\ndemand = 0\nmethod = fom\n").find("is not one of monte_carlo") !=
          std::string::npos);
    CHECK(said("[reliability]\ndemand = 0\nresponse = h\n").find("none of model.responses") !=
          std::string::npos);
    CHECK(said("[wall]\ncourses = 10\n").find("[wall]: unknown section") != std::string::npos);
    CHECK(said("[uq]\nspatial = none\n").find("uq.spatial: unknown key") != std::string::npos);
    CHECK(said("[reliability]\ndemand = 0\nevent = beyond\n").find("below or above") !=
          std::string::npos);
    CHECK(said("[reliability]\ndemand = 0\nmethod = subset\nbudget = 49\n")
              .find("reliability.budget: must be at least 50") != std::string::npos);
    CHECK(said("[reliability]\ndemand = 0\nmethod = multi_fidelity\n").find("needs a wall") !=
          std::string::npos);
    CHECK(said("[reliability]\ndemand = 0\n[uq]\npearson = r t 0.5\n")
              .find("\"t\" is not a random input") != std::string::npos);
}

TEST_CASE("reliability: Sobol' indices of another program are those of the closed form",
          "[app][reliability][repeats]")
{
    // r - s of two independent inputs of one variance: half each, no interaction.
    const Script script;
    const app::StudyFile file =
        external(script, "[reliability]\nmethod = sobol\ndemand = 0\nbudget = 800\n");
    std::vector<uq::Evaluated> seen;
    const ReliabilityAnswer a = answer(event_of(app::read_program_study(file), 2), seen);
    CHECK(a.evaluations == 800);
    CHECK(a.methods.front().outcome.find("target") == std::string::npos); // none has an effect
    REQUIRE(a.sensitivities.size() == 2);
    for (const uq::Sensitivity& s : a.sensitivities)
        for (const uq::InputShare& share : s.shares) {
            REQUIRE(share.std_error);
            CHECK(std::abs(share.value - 0.5) < 4.0 * *share.std_error);
            CHECK(*share.std_error < 0.1);
        }
    CHECK(std::abs(*a.methods.front().probability - 7.864960352514e-2) <
          4.0 * *a.methods.front().std_error);
}

TEST_CASE("reliability: no method asks for more evaluations than its budget",
          "[app][reliability][slow]")
{
    const Script script;
    const std::string method =
        GENERATE("monte_carlo", "form", "importance", "subset", "sobol", "active");
    const std::string budget = GENERATE("50", "137");
    const app::StudyFile file =
        external(script, "[reliability]\nmethod = " + method +
                             "\ndemand = 0\nbudget = " + budget + "\ntarget_cov = 0.001\n");
    std::vector<uq::Evaluated> seen;
    const ReliabilityAnswer a = answer(event_of(app::read_program_study(file), 2), seen);
    INFO(method);
    CHECK(seen.size() <= std::stoul(budget));
    CHECK(seen.size() == a.evaluations);
    for (const uq::MethodAnswer& m : a.methods)
        CHECK(m.outcome != "target coefficient of variation reached");
}

TEST_CASE(
    "reliability: a program that cannot start is a failure with its reason, at any budget",
    "[app][reliability]")
{
    const std::string method =
        GENERATE("monte_carlo", "form", "importance", "subset", "sobol", "active");
    const app::StudyFile file = app::parse_study_text(
        "external.ini", "[model]\ncommand = /nosuch/program\nresponses = g\n[variables]\n"
                        "r = normal(mean 4, sd 1)\n[reliability]\ndemand = 0\nbudget = 60\n"
                        "method = " +
                            method + "\n");
    std::vector<uq::Evaluated> seen;
    const ReliabilityAnswer a = answer(event_of(app::read_program_study(file), 2), seen);
    INFO(method);
    REQUIRE(a.evaluations > 0);
    CHECK(a.failed.size() == a.evaluations);
    CHECK(seen.size() == a.evaluations);
    REQUIRE_FALSE(a.warnings.empty());
    const auto told = [](const std::string& w) {
        return w.find("cannot run /nosuch/program: No such file or directory") !=
               std::string::npos;
    };
    CHECK(std::any_of(a.warnings.begin(), a.warnings.end(), told));
}

TEST_CASE("reliability: Monte Carlo on the wall counts the walls at or below the demand",
          "[app][reliability]")
{
    const app::Study s =
        reliability("response = peak_force\ndemand = 34 kN\nbudget = 60\ntarget_cov = 0.001\n");
    const ReliabilityProblem p = problem_at(s, "0.5");
    std::vector<uq::Evaluated> seen;
    const ReliabilityAnswer a = answer(p, seen);
    REQUIRE(seen.size() == 60);
    int below = 0;
    for (const uq::Evaluated& e : seen) below += e.response <= 34e3 ? 1 : 0;
    CHECK(below > 5);
    CHECK(below < 55);
    CHECK(*a.methods.front().probability == Approx(below / 60.0).epsilon(1e-12));
    REQUIRE(a.sensitivities.size() == 1);
    REQUIRE(a.sensitivities[0].shares.size() == 5);
    CHECK(a.sensitivities[0].shares.front().value >
          0.5); // the joints' friction carries this wall
}

TEST_CASE("reliability: two fidelities of the wall agree with its expensive samples",
          "[app][reliability][slow]")
{
    const app::Study s =
        reliability("method = multi_fidelity\ndemand = 34 kN\nbudget = 200\ncheap = rigid\n");
    std::vector<uq::Evaluated> seen;
    const ReliabilityAnswer a = answer(problem_at(s, "0.5"), seen);
    REQUIRE(a.methods.front().probability);
    double below = 0.0;
    for (const uq::Evaluated& e : seen) below += e.response <= 34e3 ? 1.0 : 0.0;
    const double n = static_cast<double>(seen.size()), share = below / n;
    CHECK(std::abs(*a.methods.front().probability - share) <
          4.0 * std::sqrt(share * (1.0 - share) / n));
}

TEST_CASE("reliability: active learning on the wall has the same bits on any number of threads",
          "[app][reliability][slow]")
{
    const app::Study s = reliability("method = active\ndemand = 30 kN\nbudget = 56\n");
    const auto run = [&](int threads) {
        std::vector<uq::Evaluated> seen;
        const ReliabilityAnswer a = answer(wall_problem(app::prepare(s), "0.5", threads), seen);
        CHECK(seen.size() == a.evaluations);
        CHECK(seen.size() <= 56);
        return a.methods.at(0);
    };
    const uq::MethodAnswer one = run(1), two = run(2);
    REQUIRE(one.probability);
    CHECK(*one.probability > 0.0);
    CHECK(*one.probability == *two.probability);
    CHECK(*one.std_error == *two.std_error);
    CHECK(one.outcome == two.outcome);
}

TEST_CASE("reliability: what a wall cannot answer is refused", "[app][reliability]")
{
    CHECK(complaint("").find("reliability.demand: missing") != std::string::npos);
    CHECK(complaint("demand = 40 mm\n").find("not a force") != std::string::npos);
    CHECK(complaint("response = ultimate_displacement\ndemand = 5 mm\n")
              .find("end of the push") != std::string::npos);
    CHECK(complaint("method = multi_fidelity\ncheap = simple\ndemand = 30 kN\n")
              .find("fidelity of the study itself") != std::string::npos);
    CHECK(complaint("demand = 30 kN\n", "spatial = stratified\n").find("no coordinates") !=
          std::string::npos);
    CHECK(complaint("quantile = 0.05\n")
              .find("reliability.quantile: reliability.method is not active") !=
          std::string::npos);
    CHECK(
        complaint("method = active\nquantile = 0.05\ndemand = 30 kN\n")
            .find("reliability.demand: a demand and reliability.quantile are two questions") !=
        std::string::npos);
    CHECK(complaint("method = active\nquantile = 0.6\n").find("reliability.quantile: ") !=
          std::string::npos);
}

TEST_CASE(
    "reliability: a quantile has no demand, and answers at the end of the push are censored",
    "[app][reliability]")
{
    const uq::ReliabilityProblem drift =
        problem_at(reliability("method = active\nquantile = 0.05\nresponse = ultimate_drift\n"),
                   "0.50 MPa");
    CHECK(drift.quantile == 0.05);
    CHECK(drift.words == "ultimate drift under 0.50 MPa");
    CHECK(drift.known_below == Approx(0.004 / 0.5)); // 4 mm at the load line, 0.5 m high
    const uq::ReliabilityProblem force =
        problem_at(reliability("method = active\nquantile = 0.05\n"), "0.50 MPa");
    CHECK(std::isinf(force.known_below));
}

namespace {

struct Told {
    int code;
    std::string out;
};

/// The verb, with what it prints.
Told told(const app::Command& command)
{
    const scenes::Terminal terminal;
    const int code = app::reliability_command(command);
    return {code, terminal.text()};
}

app::Command command_of(const std::filesystem::path& folder, const std::string& text)
{
    app::Command c;
    c.study = (folder / "study.ini").string();
    std::ofstream(c.study) << text;
    c.out = (folder / "out").string();
    c.quiet = true;
    c.threads = 2;
    return c;
}

std::string first_line(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

std::string content(const std::filesystem::path& file)
{
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("reliability: the answer opens with the question, each table with its title",
          "[app][reliability]")
{
    const Script script;
    const Told t = told(command_of(
        script.folder.path, "[model]\ncommand = " + script.path.string() +
                                " {input}\nresponses = g\n[variables]\n"
                                "r = normal(mean 4, sd 1)\ns = normal(mean 2, sd 1)\n"
                                "[reliability]\nmethod = form\ndemand = 0\nbudget = 60\n"));
    CHECK(t.code == 0);
    CHECK(t.out.starts_with("P(g <= 0). Intervals are 95 %. "));
    CHECK(t.out.find(" evaluations, none failed.\n") != std::string::npos);
    CHECK(t.out.find("\nWhat the response depends on. Intervals are 95 %.\n") !=
          std::string::npos);
    CHECK(first_line(script.folder.path / "out" / "evaluations.csv") == "r,s,g,failure");
}

TEST_CASE("reliability: numbers of walls are written in the units of their keys",
          "[app][reliability]")
{
    const scenes::TemporaryFolder folder;
    app::Command c =
        command_of(folder.path, std::string(study_scenes::kSmall) +
                                    "[reliability]\nmethod = form\ndemand = 34 kN\n"
                                    "budget = 60\n");
    c.level = "0.5 MPa";
    (void)told(c);
    const auto out = folder.path / "out";
    CHECK(first_line(out / "evaluations.csv") ==
          "joint.friction_angle [deg],joint.stiffness_factor [-],unit.tensile_strength [MPa],"
          "unit.friction_angle [deg],unit.stiffness_factor [-],peak_force [kN],failure");
    // the first sample is the medians
    std::ifstream in(out / "evaluations.csv");
    std::string line;
    std::getline(in, line);
    std::getline(in, line);
    std::istringstream cells(line);
    std::vector<double> x;
    for (std::string cell; std::getline(cells, cell, ',');)
        x.push_back(cell.empty() ? 0.0 : std::stod(cell));
    CHECK(x.at(0) == Approx(31.8).epsilon(1e-3));
    CHECK(x.at(2) == Approx(3.7 / std::sqrt(1.09)).epsilon(1e-6));
    CHECK(x.at(5) > 20.0); // kN
    CHECK(x.at(5) < 60.0);
    const std::string points = content(out / "design_points.csv");
    CHECK(points.find("joint.friction_angle [deg]") != std::string::npos);
    CHECK(points.find("[rad]") == std::string::npos);
    CHECK(content(out / "reliability.json").find("\"joint.friction_angle [deg]\"") !=
          std::string::npos);
}

TEST_CASE(
    "reliability: where every evaluation fails the run ends after twenty, with the reason",
    "[app][reliability]")
{
    const scenes::TemporaryFolder folder;
    const std::string model = "[model]\ncommand = sh -c 'echo the mesh is broken >&2; exit 3' "
                              "{input}\nresponses = g\n[variables]\n"
                              "r = normal(mean 4, sd 1)\ns = normal(mean 2, sd 1)\n";
    const auto lines = [&] {
        const std::string text = content(folder.path / "out" / "evaluations.csv");
        return std::ranges::count(text, '\n');
    };
    for (const char* const method : {"monte_carlo", "subset", "sobol"}) {
        INFO(method);
        const app::Command c =
            command_of(folder.path, model + "[reliability]\nmethod = " + method +
                                        "\ndemand = 0\nbudget = 500\n");
        for (int run = 0; run < 2; ++run) // the second asks again
            CHECK_THROWS_WITH(told(c), Catch::Contains("of 500 evaluations all failed") &&
                                           Catch::Contains("the mesh is broken") &&
                                           Catch::Contains("evaluations.csv"));
        CHECK(lines() == 21);
        CHECK_FALSE(std::filesystem::exists(folder.path / "out" / "unfinished.jsonl"));
    }
    // a budget of as many is spent and answered
    const Told t = told(command_of(
        folder.path, model + "[reliability]\nmethod = monte_carlo\ndemand = 0\nbudget = 20\n"));
    CHECK(t.code == 1);
    CHECK(t.out.find("20 evaluations, 20 failed") != std::string::npos);
}
