#include "app/fragility/numbers/fragility_output.hpp"
#include "app/report/report_command.hpp"
#include "app/report/report_page.hpp"
#include "app/report/shaken_report.hpp"
#include "app/shake/shake_study.hpp"
#include "scenes/temporary_folder.hpp"
#include "scenes/terminal.hpp"
#include "tests/app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

constexpr const char* kShaking = R"([load]
vertical_stress = 0.05, 0.10 MPa
mass = floor
[solver]
fidelity = rigid
[shaking]
records = wave.txt, half_sine(peak 0.3 g, duration 0.2 s)
intensities = 0.3, 0.6 g
[uq]
samples = 2
)";

/// The page of a study that was shaken in a folder.
struct ShakenReport {
    fs::path folder;

    std::string results = "s.h5"; ///< from the folder

    explicit ShakenReport(fs::path in, std::string out = "s.h5")
        : folder(std::move(in)), results(std::move(out))
    {
        std::ofstream(folder / "study.ini") << study_texts::kShakenWall << kShaking;
        wave(1.0);
        app::Command c;
        c.study = (folder / "study.ini").string();
        c.words = {c.study};
        c.out = (folder / results).string();
        c.quiet = true;
        const scenes::Terminal terminal;
        REQUIRE(app::shake_study_command(c) == 0);
    }
    void wave(double peak) const
    {
        std::ofstream(folder / "wave.txt")
            << "0.00 0\n0.05 " << peak << "\n0.10 0\n0.15 " << -peak << "\n0.20 0\n";
    }
    [[nodiscard]] std::string page() const
    {
        app::Command c;
        c.words = {(folder / results).string()};
        c.out = (folder / "s.html").string();
        c.quiet = true;
        {
            const scenes::Terminal terminal;
            REQUIRE(app::report_command(c) == 0);
        }
        return scenes::read_text(folder / "s.html");
    }
};

std::size_t count_of(const std::string& text, const std::string& what)
{
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++n;
    return n;
}

} // namespace

TEST_CASE("shaken report: a film of each stress, all pictures and tables, in one file that "
          "asks for nothing",
          "[app][report]")
{
    const scenes::TemporaryFolder folder;
    const ShakenReport report(folder.path);
    const std::string page = report.page();
    CHECK_THAT(page, Contains(std::string(app::kPageMark)));
    CHECK_THAT(page, Contains("not validated"));
    for (const char* const stress : {"0.05 MPa: wall ", "0.10 MPa: wall "})
        CHECK(count_of(page, std::string("<figcaption>") + stress) == 1);
    CHECK(count_of(page, "<img src=\"data:image/svg+xml;base64,") == 2 + 2 * 4);
    for (const char* const title :
         {"Fragility on pga", "Histories at each intensity", "Fragility by failure mode",
          "Scatter of records and of walls", "How well each measure tells the drift"})
        CHECK_THAT(page, Contains(std::string("<summary>") + title));
    CHECK_THAT(page, !Contains("differ from what is stored"));
    CHECK_THAT(page, !Contains("<script") && !Contains("src=\"http"));
}

TEST_CASE("shaken report: records that are gone or others leave out the films, and it says so",
          "[app][report]")
{
    const scenes::TemporaryFolder folder;
    const ShakenReport report(folder.path);
    report.wave(0.9);
    CHECK_THAT(report.page(), Contains("No films: ") && Contains("has changed since"));
    fs::remove(report.folder / "wave.txt");
    const std::string page = report.page();
    CHECK_THAT(page, Contains("No films: ") && Contains("wave.txt"));
    CHECK(count_of(page, "<img src=") == 2 * 4);
}

TEST_CASE("shaken report: records are found from results in another folder, and beside results "
          "that have moved with them",
          "[app][report]")
{
    const scenes::TemporaryFolder folder;
    fs::create_directories(folder.path / "study" / "runs");
    ShakenReport report(folder.path / "study", "runs/s.h5");
    CHECK_THAT(report.page(), !Contains("No films: "));
    const fs::path moved = folder.path / "moved";
    fs::create_directories(moved);
    for (const char* const name : {"runs/s.h5", "wave.txt"})
        fs::rename(report.folder / name, moved / fs::path(name).filename());
    report.folder = moved;
    report.results = "s.h5";
    CHECK_THAT(report.page(), !Contains("No films: "));
}

TEST_CASE("shaken report: what a study says stands in the page as text", "[app][report]")
{
    app::FragilityOutput output;
    output.source = "a<b & \"c\".h5";
    const std::string page = app::shaken_page("<i>title", output, {}, "no <film>");
    CHECK_THAT(page, Contains("<h1>&lt;i&gt;title</h1>"));
    CHECK_THAT(page, Contains("a&lt;b &amp; &quot;c&quot;.h5"));
    CHECK_THAT(page, Contains("no &lt;film&gt;"));
}
