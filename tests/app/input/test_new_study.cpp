#include "app/input/prepared_study.hpp"
#include "app/new/new_study.hpp"

#include "app/commands.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "scenes/temporary_folder.hpp"
#include "scenes/terminal.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>

namespace {

const app::Answers kHouse = {{"length", "3 m"},
                             {"height", "2.7 m"},
                             {"thickness", "0.5 m"},
                             {"material", "roughly_squared"},
                             {"unit", "0.6 x 0.3 m"},
                             {"stress", "0.20 MPa"},
                             {"openings", "0.3 m, 0 m, 0.9 m, 2.1 m"}};

app::Answers with(app::Answers all, const std::string& option, const std::string& text)
{
    all[option] = text;
    return all;
}

app::Study study_of(const app::Answers& given)
{
    std::ostringstream out;
    const std::string text =
        app::new_study_text(app::answers(given, nullptr, out), "house.ini");
    CHECK(out.str().empty());
    return app::prepare(app::read_study(app::parse_study_text("house.ini", text))).study;
}

} // namespace

TEST_CASE("new study: the wall is the one of the answers", "[app][new_study]")
{
    const app::Study s = study_of(kHouse);
    CHECK(app::wall_length(s) == 3.0);
    CHECK(app::wall_height(s) == Approx(2.7));
    CHECK(s.wall.thickness == 0.5);
    CHECK(s.wall.courses == 9);
    CHECK(s.wall.unit_length == Approx(0.6));
    CHECK(s.load.vertical_stress == std::vector{0.2e6});
    CHECK(s.solver.kinematics == dem::Kinematics::finite);
    CHECK_FALSE(s.geometry.openings.empty());
    CHECK(s.random.size() >= 4);
}

TEST_CASE("new study: courses fill the height, halves of stones the length", "[app][new_study]")
{
    const app::Study s = study_of(
        with(with(with(kHouse, "unit", "47 x 23 cm"), "height", "2.5 m"), "openings", "none"));
    CHECK(app::wall_height(s) == Approx(2.5).epsilon(1e-9));
    const double halves = 2.0 * 3.0 / s.wall.unit_length;
    CHECK(halves == Approx(std::round(halves)).epsilon(1e-9));
    CHECK(s.wall.unit_length == Approx(0.47).epsilon(0.05));
}

TEST_CASE("new study: every material and bond makes a study", "[app][new_study]")
{
    const app::Answers plain = with(kHouse, "openings", "none");
    for (const char* const m :
         {"rubble_lime", "roughly_squared", "ashlar_lime", "dry_sandstone", "dry_granite"})
        CHECK_NOTHROW(study_of(with(plain, "material", m)));
    for (const char* const b : {"running", "stack", "english", "flemish", "header", "rubble"})
        CHECK_NOTHROW(study_of(with(plain, "bond", b)));
}

TEST_CASE("new study: a person is asked what the options leave open, again until it can be",
          "[app][new_study]")
{
    app::Answers given = kHouse;
    given.erase("stress");
    given.erase("openings");
    given.erase("bond");
    std::istringstream person("\n\nmuch\n\n0.3 MPa\n"); // bond, openings; three of the stress
    std::ostringstream out;
    const app::Answers all = app::answers(given, &person, out);
    CHECK(all.at("bond") == "running");
    CHECK(all.at("openings") == "none");
    CHECK(all.at("stress") == "0.3 MPa");
    CHECK(out.str().find("\"much\"") != std::string::npos);
    CHECK(out.str().find("Length of the wall") == std::string::npos);
    std::istringstream gone("");
    CHECK_THROWS_WITH(app::answers(given, &gone, out),
                      "drystone: new: the questions were not answered to the end");
}

TEST_CASE("new study: a size of a stone has two lengths", "[app][new_study]")
{
    const app::StoneSize size = app::stone_size("60 x 30 cm");
    CHECK(size.length == "60 cm");
    CHECK(size.height == "30 cm");
    CHECK(app::stone_size("0.6 m x 30 cm").length == "0.6 m");
    CHECK_THROWS_AS(app::stone_size("0.6 m"), app::BadValue);
    CHECK_THROWS_AS(app::stone_size("0.6 x 0.3"), app::BadValue);
}

TEST_CASE("new study: the command writes study and scene, and replaces nothing",
          "[app][new_study]")
{
    namespace fs = std::filesystem;
    const scenes::TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path);
    app::Command c;
    c.words = {"own/house.ini"};
    c.answers = kHouse;
    c.answers["bond"] = "running";
    const scenes::Terminal terminal;
    const int code = app::new_command(c);
    const std::string text = scenes::read_text("own/house.ini");
    CHECK_THROWS_WITH(app::new_command(c),
                      "drystone: new: \"own/house.ini\" is there already; write another name");
    CHECK(code == 0);
    CHECK(fs::exists("runs/house_scene/scene.svg"));
    CHECK(scenes::read_text("own/house.ini") == text);
    CHECK(terminal.text().find("drystone push own/house.ini --sample mean") !=
          std::string::npos);
    fs::current_path(before);
}
