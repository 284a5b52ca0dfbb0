#include "app/sheet/print_pdf.hpp"
#include "app/sheet/sheet_command.hpp"
#include "app/sheet/sheet_page.hpp"
#include "app/sheet/wall_drawing.hpp"
#include "app/study_texts.hpp"
#include "app/text/config_error.hpp"
#include "scenes/count_text.hpp"
#include "scenes/temporary_folder.hpp"
#include "scenes/terminal.hpp"

#include <catch2/catch.hpp>

#include <stdlib.h> // setenv is POSIX

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace {

using scenes::count;

namespace fs = std::filesystem;

/// With small displacements, which a sheet has to name: they leave no drift limit.
const std::string kWall = std::string(study_texts::kSmallWall) + "kinematics = small\n";

std::string svg(double width, double height)
{
    const app::DrawnBlock stone{{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, ""};
    return app::wall_drawing({&stone, 1}, width, height);
}

/// More than a page has room for.
app::Sheet full_sheet()
{
    const std::string longest(900, 'w');
    std::string words;
    for (int i = 0; i < 200; ++i) words += "many words ";
    app::Sheet s;
    s.title = longest;
    s.subtitle = words;
    s.drawing = s.curve = s.mechanism = svg(400, 4000);
    for (int i = 0; i < 12; ++i) {
        s.answer.push_back(words);
        s.assumed.push_back({longest, words, words});
        s.certainty.push_back(words);
    }
    for (int i = 0; i < 30; ++i) s.limits.push_back({words, "1", "2", words, "3, 4, 5"});
    s.spread_head = "a head";
    s.footer = words;
    return s;
}

/// Runs the command on the wall of `file`, without a program that prints.
int sheet_of(const fs::path& file, const fs::path& out)
{
    app::Command c;
    c.study = file.string();
    c.out = out.string();
    c.quiet = true;
    c.title = "A <wall> & more";
    const std::string path = ::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    const scenes::Terminal terminal;
    int code = 0;
    try {
        code = app::sheet_command(c);
    } catch (...) {
        ::setenv("PATH", path.c_str(), 1);
        throw;
    }
    ::setenv("PATH", path.c_str(), 1);
    CHECK(terminal.text().find("apt install weasyprint") != std::string::npos);
    return code;
}

} // namespace

TEST_CASE("sheet: it is never two pages", "[app][sheet]")
{
    const scenes::TemporaryFolder folder;
    const fs::path html = folder.path / "a.html", pdf = folder.path / "a.pdf";
    std::ofstream(html) << app::sheet_page(full_sheet());
    const std::string said = app::print_pdf(html, pdf);
    if (!fs::exists(pdf)) {
        WARN("not tested: " << said);
        return;
    }
    const std::string bytes = scenes::read_text(pdf);
    CHECK(count(bytes, "/Type /Page") == 2); // the page and the list of pages
    CHECK(bytes.find("/Count 1") != std::string::npos);
    CHECK_FALSE(fs::exists(folder.path / "a.pdf.part"));
}

TEST_CASE("sheet: paragraphs on piers get the room they need from the picture above the table",
          "[app][sheet]")
{
    struct Box {
        double top, height; // [mm]
    };
    const auto boxes = [](const app::Sheet& s) {
        const std::string page = app::sheet_page(s);
        std::vector<Box> all;
        for (std::size_t at = page.find("<section "); at != std::string::npos;
             at = page.find("<section ", at + 1)) {
            const auto number = [&](const char* name) {
                return std::stod(page.substr(page.find(name, at) + std::string(name).size()));
            };
            all.push_back({number(";top:"), number(";height:")});
        }
        return all;
    };
    app::Sheet s;
    s.drawing = s.curve = s.mechanism = svg(400, 300);
    for (int i = 0; i < 9; ++i) s.limits.push_back({"state", "1", "2", "a rule", ""});
    const std::vector<Box> without = boxes(s);
    s.spread_head = "of random walls";
    s.piers = {std::string(260, 'w'), std::string(260, 'w')};
    for (app::SheetLimit& l : s.limits) l.rule = std::string(100, 'w');
    const std::vector<Box> with = boxes(s);
    constexpr std::size_t kMechanism = 3, kTable = 4, kLists = 5;
    REQUIRE(with.size() == 8);
    CHECK(without[kMechanism].height > with[kMechanism].height + 20.0);
    CHECK(with[kTable].height > without[kTable].height + 30.0);
    for (const std::vector<Box>& all : {without, with}) {
        CHECK(all[kMechanism].height >= 46.0);
        CHECK(all[kMechanism].top + all[kMechanism].height <= all[kTable].top + 1e-6);
        CHECK(all[kTable].top + all[kTable].height <= all[kLists].top + 1e-6);
        CHECK(all[kLists].height >= 34.0);
        CHECK(all[kLists].top + all[kLists].height <= 286.0 + 1e-6);
    }
}

TEST_CASE("sheet: of many limits the first are shown, the others counted", "[app][sheet]")
{
    const std::string page = app::sheet_page(full_sheet());
    CHECK(count(page, "<td class=\"rule\">") == app::kMostSheetLimits);
    CHECK(page.find("and 21 more") != std::string::npos);
}

TEST_CASE("sheet: a page of a wall has every part, and texts obey nothing", "[app][sheet]")
{
    const scenes::TemporaryFolder folder;
    const fs::path study = folder.path / "a.ini", out = folder.path / "a.html";
    std::ofstream(study) << kWall;
    CHECK(sheet_of(study, out) == 0);
    const std::string page = scenes::read_text(out);
    CHECK(count(page, "<svg") >= 3);
    CHECK(count(page, "</svg>") == count(page, "<svg"));
    for (const char* const part :
         {"A &lt;wall&gt; &amp; more", "0.6 x 0.3 x 0.2 m", "the wall carries ",
          "paper ultimate", "ntc SLC", "solver.kinematics = small", "One wall of mean values",
          "solver.kinematics = finite and a larger load.max_displacement"})
        CHECK(page.find(part) != std::string::npos);
    CHECK(page.find("nan") == std::string::npos);
    CHECK(sheet_of(study, out) == 0); // its own page is replaced
    CHECK(scenes::read_text(out) == page);
}

TEST_CASE("sheet: the study that a push of mean values leaves gives a page", "[app][sheet]")
{
    const scenes::TemporaryFolder folder;
    const fs::path left = folder.path / "a.ini";
    std::ofstream(left) << kWall << "[uq]\ndrawn = 0.5 MPa; mean\n";
    REQUIRE(sheet_of(left, folder.path / "a.html") == 0);
    CHECK(count(scenes::read_text(folder.path / "a.html"), "</html>") == 1);
}

TEST_CASE("sheet: under body forces the wall moves, by the height of its centre of gravity",
          "[app][sheet]")
{
    const scenes::TemporaryFolder folder;
    const fs::path study = folder.path / "a.ini", out = folder.path / "a.html";
    std::ofstream(study) << R"([wall]
outlines = 0 0, 0.4 0, 0.4 0.5, 0 0.5; 0 0.5, 0.4 0.5, 0.4 1, 0 1
thickness = 0.2 m
base = joint
[stone]
young_modulus = 15 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
normal_stiffness = 10 GPa/m
friction_angle = 35 deg
[beam]
present = no
[load]
pattern = body
vertical_stress = 0 MPa
max_displacement = 1 mm
[solver]
fidelity = rigid
)";
    CHECK(sheet_of(study, out) == 0);
    const std::string page = scenes::read_text(out);
    CHECK(page.find("&gt; 0.0<") == std::string::npos); // limits of some hundredths of a mm
    for (const char* const part :
         {"wall moves [mm]", "Force over movement of the wall", "a mean by weight",
          "of the height of its centre of gravity", "without a load on its top"})
        CHECK(page.find(part) != std::string::npos);
    CHECK(page.find("the top moves") == std::string::npos);
    CHECK(page.find("top moves") == std::string::npos);
}

TEST_CASE("sheet: files of others stay", "[app][sheet]")
{
    const scenes::TemporaryFolder folder;
    const fs::path study = folder.path / "a.ini";
    std::ofstream(study) << kWall;
    std::ofstream(folder.path / "b.html") << "mine";
    CHECK_THROWS_AS(sheet_of(study, folder.path / "b.html"), app::ConfigError);
    std::ofstream(folder.path / "c.pdf") << "mine";
    CHECK_THROWS_AS(sheet_of(study, folder.path / "c.html"), app::ConfigError);
    CHECK_FALSE(fs::exists(folder.path / "c.html"));
}

TEST_CASE("sheet: the drawing is as large as fits, at its scale", "[app][sheet]")
{
    // 3 x 2 m in 328 x 1000 px: 64 + 8 px beside leave 256 px, 85.33 px for a metre
    const std::string drawn = svg(328, 1000);
    CHECK(drawn.find("64,178.67 320,178.67") != std::string::npos);
    CHECK(drawn.find(">3 m<") != std::string::npos);
    CHECK(drawn.find(">2 m<") != std::string::npos);
}
