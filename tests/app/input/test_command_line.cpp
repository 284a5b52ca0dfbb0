#include "app/input/command_line.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/option.hpp"
#include "app/input/sheet_offer.hpp"
#include "app/input/study_name.hpp"
#include "app/text/number_text.hpp"
#include "app/verbs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

using Words = std::vector<std::string>;

namespace {

app::Command parse(const Words& words) { return app::parse_command_line(app::verbs(), words); }

std::string help(const char* verb) { return app::help_text(app::verbs(), verb); }

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("command line: a push takes its study, output directory and options in any order",
          "[app][command_line]")
{
    const Words words =
        GENERATE(Words{"push", "a/wall.ini", "--out", "runs/x", "--set", "wall.courses=9",
                       "--set=load.height=1 m", "--threads", "3", "--quiet"},
                 Words{"--quiet", "--threads=3", "push", "--set", "wall.courses=9",
                       "a/wall.ini", "--set", "load.height=1 m", "--out=runs/x"});
    const app::Command command = parse(words);
    CHECK(command.verb->name == "push");
    CHECK(command.study == "a/wall.ini");
    CHECK(command.out == "runs/x");
    CHECK(command.overrides == Words{"wall.courses=9", "load.height=1 m"});
    CHECK(command.threads == 3);
    CHECK(command.quiet);
}

TEST_CASE("command line: help knows distributions by name", "[app][command_line]")
{
    for (const char* word : {"distributions", "lognormal", "empirical"})
        CHECK(has(help(word), "  lognormal(mean ..., cov ...)"));
    CHECK_FALSE(has(help("courses"), "lognormal"));
}

TEST_CASE("command line: what is not said has a default", "[app][command_line]")
{
    const app::Command command = parse({"push", "configs/wall.ini"});
    CHECK(command.out == "runs/wall");
    CHECK(command.overrides.empty());
    CHECK(command.threads >= 1);
    CHECK_FALSE(command.quiet);
}

TEST_CASE("command line: what is made of a file of results lies beside it",
          "[app][command_line]")
{
    CHECK(parse({"fragility", "far/house.h5"}).out == "far/house");
    CHECK(parse({"report", "far/house.h5"}).out == "far/house.html");
    CHECK(parse({"curves", "house.h5"}).out == "house.csv");
    CHECK(parse({"study", "house.ini", "--out", "new/"}).out == "new/house.h5");
    CHECK(parse({"sample", "house.ini"}).out == "runs/house_samples.csv");
    CHECK(parse({"push", "far/house.h5", "--sample", "17", "--level", "0.4 MPa"}).out ==
          "far/house_17_0.4");
    CHECK(parse({"push", "far/house.h5", "--sample", "mean"}).out == "far/house_mean");
    CHECK(parse({"push", "house.ini", "--sample", "mean"}).out == "runs/house_mean");
    CHECK(parse({"push", "house.ini"}).out == "runs/house");
    CHECK(parse({"report", "far/house.h5", "--title", "North wall"}).title == "North wall");
}

TEST_CASE("command line: help and version are verbs and options", "[app][command_line]")
{
    CHECK(parse({"help"}).verb->name == "help");
    CHECK(parse({"--help"}).verb->name == "help");
    CHECK(parse({"-h"}).words.empty());
    CHECK(parse({"version"}).verb->name == "version");
    CHECK(parse({"--version"}).verb->name == "version");
    const Words words =
        GENERATE(Words{"push", "--help"}, Words{"--help", "push"}, Words{"help", "push"},
                 Words{"push", "wall.ini", "-h"}, Words{"push", "--film", "--out", "x", "-h"});
    CHECK(parse(words).verb->name == "help");
    CHECK(parse(words).words == Words{"push"});
}

TEST_CASE("command line: help tells of a key, and finds what speaks of a word",
          "[app][command_line]")
{
    const std::string key = help("joint.cohesion");
    for (const char* const part :
         {"joint.cohesion\n", "default   0 MPa", "values    [0, 1000] MPa", "a distribution",
          "read by   push"})
        CHECK(has(key, part));
    CHECK(has(help("cohesion"), "joint.cohesion\n"));
    CHECK(has(help("cohesion"), "unit.cohesion\n")); // both of this name
    CHECK_FALSE(has(help("joint.cohesion"), "unit.cohesion\n"));
    const std::string found = help("Mortar");
    CHECK(has(found, "  joint.tensile_strength"));
    CHECK_FALSE(has(found, "wall.length"));
    CHECK_THROWS_WITH(help("cohesoin"), Catch::Contains("did you mean \"cohesion\"?"));
}

TEST_CASE("command line: help tells of an option, with its hyphens or without",
          "[app][command_line]")
{
    for (const app::Option& option : app::options()) {
        const app::Command command = parse({"help", "--" + option.name});
        REQUIRE(command.verb->name == "help");
        const std::string text = help(command.words.front().c_str());
        CHECK(has(text, "--" + option.name));
        CHECK(has(text, option.meaning));
    }
    CHECK(help("--film") == "--film\n      write a moving picture of the push or the shaking, "
                            "film.svg, for a page or a talk; of a push with a name, --film "
                            "wall.gif or wall.webm, that file too (needs ffmpeg)\n"
                            "  taken by  push, shake\n");
    const app::Command gif = parse({"push", "--film", "wall.gif", "wall.ini"});
    CHECK(gif.film);
    CHECK(gif.video == "wall.gif");
    CHECK(gif.words == std::vector<std::string>{"wall.ini"});
    CHECK(parse({"push", "wall.ini", "--film=a.webm"}).video == "a.webm");
    CHECK(parse({"push", "--film", "wall.ini"}).video.empty());
    CHECK_THROWS_WITH(parse({"push", "wall.ini", "--film", "wall.mp4"}),
                      Catch::Contains("write a name that ends in .gif or .webm"));
    CHECK(has(help("--shard"), "--shard I/N\n"));
    CHECK(has(help("film"), "  --film  "));
    CHECK_THROWS_WITH(help("--flim"), Catch::Contains("did you mean \"--film\"?"));
}

TEST_CASE("command line: a title is for the page that follows a study", "[app][command_line]")
{
    CHECK(parse({"study", "house.ini", "--report", "--title", "North wall"}).title ==
          "North wall");
    CHECK(parse({"-V"}).verb->name == "version");
}

TEST_CASE("command line: other verbs know the file of a study by its name",
          "[app][command_line]")
{
    CHECK(parse({"study", "house.ini", "--out", "a_0.60.h5"}).out == "a_0.60.h5");
    CHECK_THROWS_WITH(parse({"study", "house.ini", "--out", "a_0.60"}),
                      Catch::Contains("write \"a_0.60.h5\""));
    CHECK_THROWS_WITH(parse({"study", "house.ini", "--report", "--out", "a"}),
                      Catch::Contains("write \"a.h5\""));
    CHECK_THROWS_WITH(parse({"study", "house.ini", "--out", "a.csv"}),
                      Catch::Contains("write \"a.h5\""));
}

TEST_CASE("command line: the sheet that is offered names a stress where there are several",
          "[app][command_line]")
{
    CHECK(app::sheet_offer("runs/a.h5", "", std::vector{5e5}) ==
          "one page to print: drystone sheet runs/a.h5");
    CHECK(app::sheet_offer("runs/a b.h5", "", std::vector{5e5, 1.25e6}) ==
          "one page to print: drystone sheet 'runs/a b.h5' --level 0.5");
    CHECK(app::sheet_offer("o/study.ini", "it's", {}) ==
          "one page to print: drystone sheet o/study.ini --out o/sheet.html --title "
          "'it'\\''s'");
    CHECK(app::study_title("configs/wall.ini") == "wall");
    CHECK(app::study_title("runs/house/study.ini") == "house");
    CHECK(app::study_title("study.ini") == "study");
}

TEST_CASE("command line: the help of a verb lists the keys that it reads, with true defaults",
          "[app][command_line][repeats]")
{
    for (const app::Verb& verb : app::verbs())
        for (const app::Key& key : app::study_keys()) {
            INFO(verb.name << ": " << key.name);

            CHECK(has(help(verb.name.data()), "\n      " + std::string(key.meaning) + "\n") ==
                  app::reads(verb, key));
        }
    const std::string steps = app::number(dem::SolverOptions{}.steps_per_mm, 12);
    CHECK(has(help("push"), "steps_per_mm              " + steps + " "));
    CHECK(has(help("push"), "max_displacement          a fifth of height"));
    CHECK_FALSE(has(help(""), "[solver]"));
}

TEST_CASE("command line: the help of a verb lists its options and no others",
          "[app][command_line]")
{
    for (const app::Verb& verb : app::verbs())
        for (const app::Option& option : app::options()) {
            INFO(verb.name << " --" << option.name);
            CHECK(has(help(verb.name.data()), "--" + option.name + " ") ==
                  app::takes(verb, option));
        }
}

TEST_CASE(
    "command line: the verbs that lists may name are those of the program, the sections of a "
    "verb sections",
    "[app][command_line]")
{
    CHECK(std::ranges::equal(app::verbs(), app::kVerbNames, {}, &app::Verb::name));
    for (const app::Verb& verb : app::verbs()) {
        std::istringstream sections{std::string(verb.sections)};
        for (std::string name; sections >> name;) {
            INFO(verb.name << " reads " << name);
            const auto in_it = [&](const app::Key& key) {
                return app::section_of(key.name) == name;
            };
            CHECK((std::ranges::any_of(app::study_keys(), in_it) ||
                   std::ranges::any_of(app::program_keys(), in_it)));
        }
    }
}
