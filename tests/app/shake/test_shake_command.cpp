#include "app/commands.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/shake/shaking_motions.hpp"
#include "app/text/config_error.hpp"
#include "app/text/json_text.hpp"
#include "scenes/terminal.hpp"
#include "tests/app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

/// The wall that is shaken in no time, with a number in place of its distribution.
std::string one_wall()
{
    std::string text = study_texts::kShakenWall;
    const std::string drawn =
        "normal_stiffness = 1 GPa/m\nfriction_angle = normal(mean 25 deg, cov 0.2)\n";
    return text.replace(text.find(drawn), drawn.size(),
                        "normal_stiffness = 8 GPa/m\nfriction_angle = 31.8 deg\n") +
           "[solver]\nfidelity = rigid\n";
}

const std::string kWall = one_wall();

class ShakeFolder {
  public:
    ShakeFolder() { fs::create_directories(path); }
    ~ShakeFolder() { fs::remove_all(path); }
    ShakeFolder(const ShakeFolder&) = delete;
    ShakeFolder& operator=(const ShakeFolder&) = delete;
    fs::path path =
        fs::temp_directory_path() / ("drystone_shake_" + std::to_string(::getpid()));

    [[nodiscard]] int shake(const std::string& rest, bool film = false,
                            const std::string& video = {},
                            const std::string& wall = kWall) const
    {
        std::ofstream(path / "study.ini") << wall << rest;
        app::Command c;
        c.study = (path / "study.ini").string();
        c.words = {c.study};
        c.out = (path / "out").string();
        c.quiet = true;
        c.film = film;
        c.video = video;
        const scenes::Terminal terminal;
        return app::shake_command(c);
    }
    [[nodiscard]] std::string text(const std::string& name) const
    {
        std::ifstream in(path / "out" / name);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
};

} // namespace

TEST_CASE("shake command: a pulse gives a history whose largest drift the summary tells",
          "[app][shake]")
{
    const ShakeFolder folder;
    REQUIRE(folder.shake("[load]\nvertical_stress = 0.10 MPa\nmass = none\n[shaking]\n"
                         "records = half_sine(peak 0.3 g, duration 0.1 s)\n") == 0);
    const std::string csv = folder.text("history.csv");
    CHECK(csv.starts_with(
        "time_s,ground_acceleration_g,displacement_mm,drift_percent,base_shear_kN\n"));
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    double most = 0.0;
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string cell;
        for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
        most = std::max(most, std::abs(std::stod(cell)));
    }
    const app::Json j = app::json_of(folder.text("summary.json"));
    CHECK(j["peak_ground_acceleration_g"].get<double>() == Approx(0.3).epsilon(1e-4));
    CHECK(j["max_drift_percent"].get<double>() > 0.0);
    CHECK(most == Approx(j["max_drift_percent"].get<double>()).epsilon(0.1));
    CHECK(j["collapse_time_s"].is_null());
    CHECK_FALSE(j["overturned"].get<bool>());
    CHECK(j["load_mass"] == "none");
    CHECK_THAT(folder.text("study.ini"), Contains("records                 = half_sine("));
    for (const char* const name : {"history.svg", "wall.svg"})
        CHECK(fs::exists(folder.path / "out" / name));
}

TEST_CASE("shake command: the study that is written finds the records again", "[app][shake]")
{
    const ShakeFolder folder;
    std::ofstream(folder.path / "wave.txt") << "0.00 0\n0.05 0.3\n0.10 0\n0.15 -0.3\n0.20 0\n";
    REQUIRE(folder.shake("[load]\nvertical_stress = 0.10 MPa\nmass = none\n[shaking]\n"
                         "records = wave.txt\n") == 0);
    const std::string first = folder.text("history.csv");
    app::Command c;
    c.study = (folder.path / "out" / "study.ini").string();
    c.words = {c.study};
    c.out = (folder.path / "out" / "again").string();
    c.quiet = true;
    const scenes::Terminal terminal;
    REQUIRE(app::shake_command(c) == 0);
    CHECK(folder.text("again/history.csv") == first);
}

TEST_CASE("shake command: intensities scale each record by the measure", "[app][shake]")
{
    const app::Study study =
        app::prepare(app::read_study(app::parse_study_text(
                         "study.ini",
                         kWall + "[load]\nvertical_stress = 0 MPa\n[shaking]\n"
                                 "records = half_sine(peak 0.5 g, duration 0.3 s), "
                                 "sine(peak 1 g, period 0.3 s)\nintensities = 0.1, 0.2 g\n")))
            .study;
    const std::vector<app::ShakingMotion> motions =
        app::shaking_motions(study.shaking, study.source);
    REQUIRE(motions.size() == 4);
    double peak = 0.0;
    for (const double a : motions[3].horizontal.acceleration)
        peak = std::max(peak, std::abs(a));
    CHECK(peak == Approx(0.2 * 9.80665));
}

TEST_CASE("shake command: bad input is refused with its place and a remedy", "[app][shake]")
{
    struct Case {
        std::string rest, says;
    };
    const auto c = GENERATE(values<Case>(
        {{"[load]\nvertical_stress = 0.1 MPa\nmass = none\n",
          "shaking.records: missing; write"},
         {"[load]\nvertical_stress = 0.1 MPa\n[shaking]\nrecords = half_sine(peak 0.3 g, "
          "duration 0.1 s)\n",
          "load.mass: missing"},
         {"[load]\nvertical_stress = 0.1 MPa\nmass = heavy\n[shaking]\nrecords = "
          "half_sine(peak 0.3 g, duration 0.1 s)\n",
          "load.mass: \"heavy\""},
         {"[load]\nvertical_stress = 0 MPa\n[shaking]\nrecords = half_sine(peak 0.3 g)\n",
          "study.ini:26: shaking.records: "},
         {"kinematics = small\n[load]\nvertical_stress = 0 MPa\n[shaking]\nrecords = "
          "half_sine(peak 0.3 g, duration 0.1 s)\n",
          "solver.kinematics: a wall that is shaken turns"},
         {"[load]\nvertical_stress = 0 MPa\n[shaking]\nrecods = half_sine(peak 0.3 g)\n",
          "shaking.recods: unknown key"},
         {"[load]\nvertical_stress = 0 MPa\n[shaking]\nscale = 0\nrecords = half_sine(peak 0.3 "
          "g, duration 0.1 s)\n",
          "shaking.scale: "},
         {"[load]\nvertical_stress = 0 MPa\n[shaking]\nrecords = step(peak 0.3 g)\n",
          "\"step(peak 0.3 g)\" is neither a file nor a motion by formula"},
         {"[load]\nvertical_stress = 0 MPa\n[shaking]\nrecords = not_there.at2\n",
          "not_there.at2"}}));
    const ShakeFolder folder;
    CHECK_THROWS_WITH(static_cast<void>(folder.shake(c.rest)), Contains(c.says));
    CHECK_FALSE(fs::exists(folder.path / "out"));
}

TEST_CASE("shake command: a toe that is held sideways is refused by its key", "[app][shake]")
{
    app::Study study = app::read_study(app::parse_study_text(
        "study.ini", kWall + "[load]\nvertical_stress = 0 MPa\n[shaking]\nrecords = "
                             "half_sine(peak 0.5 g, duration 0.3 s)\n"));
    CHECK_NOTHROW(app::check_shaken_study(study, study.solver, study.shaking, study.source));
    study.wall.toe = dem::Toe::held;
    study.wall.base = dem::Base::joint;
    CHECK_THROWS_WITH(app::check_shaken_study(study, study.solver, study.shaking, study.source),
                      Contains("wall.toe: is held sideways"));
}

TEST_CASE("shake command: a series for ParaView is written where the study asks for it",
          "[app][shake]")
{
    const ShakeFolder folder;
    const std::string loads = "[load]\nvertical_stress = 0.10 MPa\nmass = none\n[shaking]\n"
                              "records = half_sine(peak 0.3 g, duration 0.3 s)\n";
    REQUIRE(folder.shake(loads) == 0);
    CHECK_FALSE(fs::exists(folder.path / "out" / "series"));
    REQUIRE(folder.shake(loads + "[output]\nparaview = yes\n") == 0);
    CHECK_FALSE(fs::exists(folder.path / "out" / "film.svg"));
    const std::string pvd = folder.text("series/wall.pvd");
    for (const char* time : {"timestep=\"0\"", "timestep=\"0.6", "timestep=\"1.0"})
        CHECK_THAT(pvd, Contains(time));
    CHECK_THAT(folder.text("series/wall_0002.vtu"), Contains("displacement"));
    CHECK(fs::exists(folder.path / "out" / "series" / "joints.pvd"));
    REQUIRE(folder.shake(loads) == 0); // takes away what is its own
    CHECK_FALSE(fs::exists(folder.path / "out" / "series" / "wall.pvd"));
}

TEST_CASE("shake command: joints that close and crush are shaken", "[app][shake]")
{
    const ShakeFolder folder;
    std::string wall = kWall;
    wall.replace(wall.find("normal_stiffness = 8 GPa/m\n"), 27,
                 "closure = exponential\ninitial_stiffness = 4.87 GPa/m\n"
                 "maximum_closure = 0.154 mm\nclosure_loss = 0.1\n"
                 "compressive_strength = 0.4 MPa\n");
    REQUIRE(folder.shake("[load]\nvertical_stress = 0.10 MPa\nmass = floor\n[shaking]\n"
                         "records = half_sine(peak 0.5 g, duration 0.2 s)\n",
                         false, {}, wall) == 0);
    CHECK_THROWS_WITH(
        static_cast<void>(folder.shake("[load]\nvertical_stress = 0.1 MPa\nmass = none\n"
                                       "[shaking]\ncontact_damping = 0.02\n"
                                       "records = half_sine(peak 0.3 g, duration 0.1 s)\n",
                                       false, {}, wall)),
        Contains("study.ini:31: shaking.contact_damping: joints that close have no dashpots"));
    const app::Json j = app::json_of(folder.text("summary.json"));
    CHECK(j["outcome"] == "stood");
    CHECK(j["energy"]["crushing_J"].get<double>() > 0.0);
}

TEST_CASE("shake command: the film shows the history where the wall is farthest out",
          "[app][shake]")
{
    constexpr const char* kPulse = R"([load]
vertical_stress = 0.05 MPa
mass = floor
[shaking]
records = half_sine(peak 0.5 g, duration 0.3 s)
)";
    const ShakeFolder folder;
    REQUIRE(folder.shake(kPulse) == 0);
    const std::string still = folder.text("history.csv");
    CHECK_FALSE(fs::exists(folder.path / "out/film.svg"));
    REQUIRE(folder.shake(kPulse, true) == 0);
    CHECK(folder.text("history.csv") == still); // looking changes nothing
    const std::string film = folder.text("film.svg");
    const auto most =
        app::json_of(folder.text("summary.json"))["max_drift_percent"].get<double>();
    double seen = 0.0;
    for (std::size_t at = film.find("drift "); at != film.npos;
         at = film.find("drift ", at + 1))
        seen = std::max(seen, std::abs(std::strtod(film.c_str() + at + 6, nullptr)));
    CHECK(seen == Approx(most).epsilon(0.05));
    CHECK_THROWS_WITH(folder.shake(kPulse, true, "wall.gif"),
                      Contains("--film: shake writes film.svg; leave out \"wall.gif\""));
}
