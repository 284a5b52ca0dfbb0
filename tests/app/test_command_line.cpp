#include "app/input/command_line.hpp"

#include "app/input/number_text.hpp"
#include "app/input/study_keys.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using app::parse_command_line;
using app::Verb;
using Words = std::vector<std::string>;

TEST_CASE("command line: a push takes its study, output directory and options in any order",
          "[app][command_line]")
{
    const Words words =
        GENERATE(Words{"push", "a/wall.ini", "--out", "runs/x", "--set", "wall.courses=9",
                       "--set=load.height=1 m", "--threads", "3", "--quiet"},
                 Words{"--quiet", "--threads=3", "push", "--set", "wall.courses=9",
                       "a/wall.ini", "--set", "load.height=1 m", "--out=runs/x"});
    const app::Command command = parse_command_line(words);
    CHECK(command.verb == Verb::push);
    CHECK(command.study == "a/wall.ini");
    CHECK(command.out == "runs/x");
    CHECK(command.overrides == Words{"wall.courses=9", "load.height=1 m"});
    CHECK(command.threads == 3);
    CHECK(command.quiet);
}

TEST_CASE("command line: what is not said has a default", "[app][command_line]")
{
    const app::Command command = parse_command_line({"push", "configs/wall.ini"});
    CHECK(command.out == "runs/wall");
    CHECK(command.overrides.empty());
    CHECK(command.threads >= 1);
    CHECK_FALSE(command.quiet);
}

TEST_CASE("command line: help and version are verbs and options", "[app][command_line]")
{
    CHECK(parse_command_line({"help"}).verb == Verb::help);
    CHECK(parse_command_line({"--help"}).verb == Verb::help);
    CHECK(parse_command_line({"-h"}).topic.empty());
    CHECK(parse_command_line({"version"}).verb == Verb::version);
    CHECK(parse_command_line({"--version"}).verb == Verb::version);
    const Words words = GENERATE(Words{"push", "--help"}, Words{"--help", "push"},
                                 Words{"help", "push"}, Words{"push", "wall.ini", "-h"});
    CHECK(parse_command_line(words).verb == Verb::help);
    CHECK(parse_command_line(words).topic == "push");
}

TEST_CASE("command line: the help of push lists every key of a study with its true default",
          "[app][command_line]")
{
    const std::string help = app::help_text("push");
    for (const app::Key& key : app::study_keys()) {
        INFO(key.name);
        CHECK(help.find("\n  " + std::string(app::name_in_section(key.name)) + " ") !=
              std::string::npos);
        CHECK(help.find("\n      " + std::string(key.meaning) + "\n") != std::string::npos);
    }
    const std::string steps = app::number(dem::SolverOptions{}.steps_per_mm, 12);
    CHECK(help.find("steps_per_mm              " + steps + " ") != std::string::npos);
    CHECK(help.find("max_displacement          30 mm ") != std::string::npos);
    CHECK(app::help_text("").find("[solver]") == std::string::npos);
}
