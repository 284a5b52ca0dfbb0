/// Every case of bad input, through the program: message, exit code, and nothing written.

#include "app/bad_input/cases.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// For the shell.
std::string for_shell(std::string_view word)
{
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

struct Run {
    int exit_code = -1; ///< -1: did not end by itself
    std::string out, err;
};

/// In the folder `work` of a place; the streams go beside it.
Run run(const fs::path& place, const std::vector<std::string>& arguments)
{
    std::string command =
        "cd " + for_shell((place / "work").string()) + " && " + for_shell(DRYSTONE_PROGRAM);
    for (const std::string& argument : arguments) command += " " + for_shell(argument);
    command += " >../out 2>../err </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, scenes::read_text(place / "out"),
            scenes::read_text(place / "err")};
}

void check_refused(std::string_view study, const std::vector<std::string>& arguments,
                   std::string_view message)
{
    const scenes::TemporaryFolder place;
    const fs::path work = place.path / "work";
    fs::create_directory(work);
    std::ofstream(work / "study.ini", std::ios::binary) << study;

    const Run result = run(place.path, arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.err == std::string(message) + "\n");
    CHECK(result.out.empty());
    std::vector<std::string> left;
    for (const auto& entry : fs::recursive_directory_iterator(work)) {
        left.push_back(entry.path().filename().string());
    }
    CHECK(left == std::vector<std::string>{"study.ini"});
    CHECK(scenes::read_text(work / "study.ini") == study);
}

/// A drawing that is no wall, and what is said of it: where, and what to do.
struct BadDrawing {
    std::string fault, file, bytes, unit, place, more = "";
};

std::string json(const std::string& outlines) { return "{\"blocks\": [\n" + outlines + "]}\n"; }
std::string dxf(const std::string& entities)
{
    return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

std::vector<BadDrawing> bad_drawings()
{
    const std::string block = "[[0, 0], [1, 0], [1, 1], [0, 1]]";
    const std::string triangle =
        "0\nLWPOLYLINE\n90\n3\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n";
    return {{"crosses itself", "w.json", json("[[0, 0], [1, 0], [0, 1], [1, 1]]"), "m",
             "w.json:2: ", "crosses itself at (0.5, 0.5)"},
            {"overlap", "w.json", json(block + ",\n[[0.9, 0], [2, 0], [2, 1], [0.9, 1]]"), "m",
             "w.json:3: this block overlaps", "(0.9, 0)"},
            {"floats", "w.json", json(block + ",\n[[0, 1.5], [1, 1.5], [1, 2], [0, 2]]"), "m",
             "w.json:3: the block at (0, 1.5) stands neither"},
            {"1 km", "w.json", json("[[0, 0], [1000, 0], [1000, 500], [0, 500]]"), "m",
             "w.json: the wall is 1000 x 500 m, from (0, 0) to (1000, 500)",
             "wall.length_unit = mm"},
            {"hidden", "w.json",
             json(block + ",\n[[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]]"), "m",
             "w.json:3: this block lies within the block of line 2, at (0.2, 0.2)"},
            {"drawn twice", "w.json", json(block + ",\n" + block), "m",
             "w.json:3: this block is drawn twice", "(0, 0)"},
            {"open", "w.dxf",
             dxf("0\nLWPOLYLINE\n90\n3\n70\n0\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n"),
             "m", "w.dxf:6: this outline is open: it begins at (0, 0)", "ends at (1, 1)"},
            {"empty", "w.dxf", dxf(""), "m", "w.dxf: holds no closed outline"},
            {"circle", "w.dxf", dxf(triangle + "0\nCIRCLE\n10\n2\n20\n3\n40\n1\n"), "m",
             "w.dxf:24: at (2, 3) there is a circle"},
            {"spline", "w.dxf", dxf(triangle + "0\nSPLINE\n10\n2\n20\n3\n"), "m",
             "w.dxf:24: at (2, 3) there is a spline"},
            {"empty layer", "w.dxf", dxf(triangle),
             "m\nlayer_stones = lintel: 30 GPa, 0.2, 2500 kg/m3",
             "study.ini:", "the drawing has no layer \"lintel\""},
            {"curve", "w.svg", "<svg><path d=\"M0,0 H1 V1 C 0,1 0,0.5 0,0 Z\"/></svg>", "m",
             "w.svg:1: ", "(1, 1)"},
            {"no picture", "w.png", "no picture",
             "m\npicture_width = 1 m\npicture_height = 1 m", "w.png: "}};
}

} // namespace

TEST_CASE("program: a drawing that is no wall is refused with its place, exit code 2 and "
          "nothing written",
          "[app][bad_input][program]")
{
    for (const BadDrawing& bad : bad_drawings())
        for (const char* verb : {"scene", "push"}) {
            INFO(bad.fault << ", " << verb);
            const scenes::TemporaryFolder place;
            const fs::path work = place.path / "work";
            fs::create_directory(work);
            std::ofstream(work / bad.file, std::ios::binary) << bad.bytes;
            std::ofstream(work / "study.ini")
                << "[wall]\ngeometry = " << bad.file << "\nlength_unit = " << bad.unit
                << "\nthickness = 0.3 m\n[stone]\nyoung_modulus = 15 GPa\npoisson_ratio = 0.2\n"
                   "density = 2000 kg/m3\n[joint]\nnormal_stiffness = 8 GPa/m\nfriction_angle "
                   "= 30 deg\n"
                   "[beam]\nheight = 0.2 m\nyoung_modulus = 30 GPa\ndensity = 2500 kg/m3\n"
                   "[load]\nvertical_stress = 0.1 MPa\n";
            const Run result = run(place.path, {verb, "study.ini", "--out", "results"});
            CHECK(result.exit_code == 2);
            CHECK_THAT(result.err, Catch::StartsWith(bad.place));
            CHECK_THAT(result.err, Catch::Contains(bad.more));
            CHECK(result.out.empty());
            const auto left =
                std::distance(fs::directory_iterator(work), fs::directory_iterator());
            CHECK(left == 2); // study and drawing
        }
}

TEST_CASE("program: a bad study file is refused with exit code 2 and nothing is written",
          "[app][bad_input][program]")
{
    for (const bad_input::BadStudy& bad : bad_input::bad_studies()) {
        INFO(bad.fault);
        check_refused(bad_input::text_of(bad), {"push", "study.ini", "--out", "results"},
                      bad.message);
    }
}

TEST_CASE("program: a bad command line is refused with exit code 2 and nothing is written",
          "[app][bad_input][program]")
{
    for (const bad_input::BadCommand& bad : bad_input::bad_commands()) {
        INFO(bad.fault);
        check_refused(bad_input::kGoodStudy, bad.arguments, bad.message);
    }
}
