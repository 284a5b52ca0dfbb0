#include "app/output/picture/film_svg.hpp"

#include "app/output/picture/film_video.hpp"
#include "app/output/picture/wall_marks.hpp"
#include "app/output/run_program.hpp"
#include "tests/scenes/snapshot_scenes.hpp"
#include "tests/scenes/temporary_folder.hpp"
#include "tests/scenes/xml_tree.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

using scenes::elements;

namespace {

/// A push of the paper's wall that rocks or cracks, in so many frames.
struct Scene {
    std::vector<dem::Snapshot> frames;
    std::vector<double> displacement, force;
};

Scene scene(int frames, bool cracks, const scenes::SnapshotWall& wall = {})
{
    Scene s;
    for (int i = 0; i < frames; ++i) {
        const double t = static_cast<double>(i) / (frames - 1), d = 0.03 * t;
        s.frames.push_back(i == 0   ? scenes::wall_at_rest(wall)
                           : cracks ? scenes::diagonal_crack(d, t, wall)
                                    : scenes::stair_step_rocking(d, wall));
        s.frames.back().displacement = d;
        s.frames.back().force = 50e3 * t;
        s.displacement.push_back(d);
        s.force.push_back(50e3 * t);
    }
    return s;
}

std::string film(const Scene& s)
{
    return app::film_svg(s.frames, s.displacement, s.force, {});
}

std::size_t values_of(const scenes::Xml& motion)
{
    const std::string text = scenes::attribute(motion, "values");
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), ';')) + 1;
}

} // namespace

TEST_CASE("film: it moves without script, on a page of its own colour", "[app][film_svg]")
{
    const std::string text = film(scene(61, true));
    CHECK(text.find("<script") == std::string::npos);
    CHECK(text.find("href") == std::string::npos);
    const auto page = scenes::parse_xml(text);
    const auto ground = elements(page, "rect").at(0);
    CHECK(scenes::attribute(ground, "fill") == "white");
    CHECK(scenes::number_of(ground, "width") == 960);
    CHECK(elements(page, "animate").size() > 60);
    CHECK(text.size() < 400'000);
}

TEST_CASE("film: all shapes have the same clock, and rest at the end", "[app][film_svg]")
{
    const auto page = scenes::parse_xml(film(scene(21, false)));
    for (const auto& shape : elements(page, "polygon"))
        for (const auto& motion : elements(shape, "animate")) {
            CHECK(scenes::attribute(motion, "repeatCount") == "indefinite");
            CHECK(values_of(motion) == 21 + 4);
            const std::string values = scenes::attribute(motion, "values"),
                              last = scenes::attribute(shape, "points");
            CHECK(values.ends_with(last + ";" + last)); // what does not play shows the end
        }
}

TEST_CASE("film: the dot goes along the curve", "[app][film_svg]")
{
    const auto page = scenes::parse_xml(film(scene(11, false)));
    const auto dot = elements(page, "circle").at(0);
    const auto motions = elements(dot, "animate");
    REQUIRE(motions.size() == 2);
    std::vector<double> x;
    std::string text = scenes::attribute(motions[0], "values");
    const std::regex number("[0-9.]+");
    for (std::sregex_iterator m(text.begin(), text.end(), number), end; m != end; ++m)
        x.push_back(std::stod(m->str()));
    REQUIRE(x.size() == 11 + 2);
    CHECK(std::is_sorted(x.begin(), x.end()));
    CHECK(x[5] - x[0] == Approx(0.5 * (x[10] - x[0])).epsilon(1e-3));
}

TEST_CASE("film: a crack is red from the frame on in which it is there", "[app][film_svg]")
{
    const auto red = [](const std::string& text) {
        return text.find(app::kCrackColour) != text.npos;
    };
    CHECK(red(film(scene(11, true))));
    CHECK_FALSE(red(film(scene(11, false))));
}

TEST_CASE("film: larger walls have fewer frames, and the file stays small", "[app][film_svg]")
{
    const std::string text = film(scene(61, false, {.courses = 24, .half_units = 24}));
    CHECK(text.size() < 700'000);
    for (const auto& shape : elements(scenes::parse_xml(text), "polygon"))
        for (const auto& motion : elements(shape, "animate")) CHECK(values_of(motion) < 20);
}

TEST_CASE("film: a shaken wall goes to and fro in real time, with a dot on its history",
          "[app][film_svg]")
{
    constexpr int kFrames = 51;
    constexpr double kApart = 0.05;
    Scene s = scene(kFrames, false);
    std::vector<double> times, history_times, history;
    for (int i = 0; i < kFrames; ++i) {
        times.push_back(3.0 + kApart * i);
        s.frames[static_cast<std::size_t>(i)].displacement = 0.01 * std::sin(0.5 * i);
    }
    for (int i = 0; i <= 1000; ++i) {
        history_times.push_back(0.01 * i);
        history.push_back(0.01 * std::sin(0.5 * (history_times.back() - 3.0) / kApart));
    }
    const std::string film = app::shaken_film_svg({s.frames, times, history_times, history},
                                                  {.title = "a record", .load_height = 1.0});
    const auto page = scenes::parse_xml(film);
    const auto motions = elements(elements(page, "circle").at(0), "animate");
    REQUIRE(motions.size() == 2);
    const std::string clock = scenes::attribute(motions[0], "dur");
    const double held = kFrames / 5;
    CHECK(std::stod(clock) == Approx(kApart * (kFrames - 1 + held)));
    CHECK(values_of(motions[0]) == kFrames + kFrames / 5);
    CHECK(film.find("4.00 s,  ") != film.npos);
    CHECK(film.find("mm,  drift -0.") != film.npos);
    CHECK(film.find(" kN") == film.npos); // nothing pushes it
    CHECK(film.find("Time [s]") != film.npos);
}

TEST_CASE("film: its pictures show the frames one after the other, from one place",
          "[app][film_svg]")
{
    const Scene s = scene(11, false);
    const std::vector<std::string> stills =
        app::film_stills(s.frames, s.displacement, s.force, {});
    REQUIRE(stills.size() == 11);
    const auto dot = [](const std::string& picture) {
        const auto page = scenes::parse_xml(picture);
        return std::stod(scenes::attribute(elements(page, "circle").front(), "cx"));
    };
    for (std::size_t i = 1; i < stills.size(); ++i)
        CHECK(dot(stills[i]) - dot(stills[i - 1]) ==
              Approx(dot(stills[1]) - dot(stills[0])).margin(0.2));
    CHECK(dot(stills[10]) - dot(stills[0]) > 100.0);
}

TEST_CASE("film: a GIF and a WebM of it are made where ffmpeg is installed, else it is said "
          "what to install",
          "[app][film_svg]")
{
    const scenes::TemporaryFolder folder;
    const Scene s = scene(3, false);
    const std::vector<std::string> stills =
        app::film_stills(s.frames, s.displacement, s.force, {});
    for (const char* const name : {"wall.gif", "wall.webm"}) {
        const std::filesystem::path file = folder.path / name;
        const std::string said = app::write_video(file, stills);
        if (app::is_missing(app::run_program({"ffmpeg", "-version"}))) {
            CHECK(said.find("apt install ffmpeg") != std::string::npos);
            CHECK(std::filesystem::is_empty(folder.path));
            continue;
        }
        CHECK(said == file.string() + " written");
        std::ifstream in(file, std::ios::binary);
        std::string begin(100, '\0');
        in.read(begin.data(), 100);
        CHECK(begin.find(app::video_mark(file)) != std::string::npos);
        std::filesystem::remove(file);
        CHECK(std::filesystem::is_empty(folder.path)); // nothing else is left
    }
}

TEST_CASE("film: one frame is no film", "[app][film_svg]")
{
    Scene s = scene(2, false);
    s.frames.pop_back();
    CHECK_THROWS_AS(film(s), std::invalid_argument);
}
