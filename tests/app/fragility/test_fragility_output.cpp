#include "app/fragility/numbers/fragility_output.hpp"

#include "app/fragility/study_output.hpp"
#include "app/output/result_folder.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"
#include "tests/app/fragility/latex_width.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <sys/resource.h>

namespace fs = std::filesystem;

namespace {

std::set<std::string> files_in(const fs::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) names.insert(fs::relative(entry, folder).string());
    names.erase(std::string(app::kFileList));
    return names;
}

} // namespace

TEST_CASE(
    "fragility output: every table is there as CSV, Markdown and LaTeX, and the index links "
    "every file",
    "[app][fragility_output]")
{
    const scenes::TemporaryFolder folder;
    const auto output = app::study_output(scenes::study_walls(30));
    app::write_output(folder.path, output);
    std::set<std::string> wanted = {"README.md", "fragility.json", "pelicun_fragility.csv"};
    for (const app::NamedTable& t : output.tables)
        for (const char* const end : {".csv", ".md", ".tex"})
            wanted.insert((t.answer ? "" : "tables/") + t.name + end);
    for (const app::NamedPicture& p : output.pictures)
        wanted.insert("pictures/" + p.name + ".svg");
    CHECK(files_in(folder.path) == wanted);
    const std::string index = scenes::read_text(folder.path / "README.md");
    for (const std::string& file : wanted)
        if (file.ends_with(".md") && file != "README.md")
            CHECK(index.find("](" + file + ")") != std::string::npos);
    for (const app::NamedPicture& p : output.pictures)
        CHECK(index.find("](pictures/" + p.name + ".svg)") != std::string::npos);
}

TEST_CASE("fragility output: no table in LaTeX is wider than an A4 page",
          "[app][fragility_output]")
{
    for (const app::NamedTable& t : app::study_output(scenes::study_walls(30)).tables) {
        INFO(t.name << "\n" << app::as_latex(t.table));
        CHECK(scenes::widest_latex(app::as_latex(t.table)) <= scenes::kPagePoints);
    }
}

TEST_CASE("fragility output: README.md begins with the answer, then the drift limits and the "
          "shares of "
          "modes, which alone stand beside it",
          "[app][fragility_output]")
{
    const scenes::TemporaryFolder folder;
    app::write_output(folder.path, app::study_output(scenes::study_walls(30)));
    const std::string text = scenes::read_text(folder.path / "README.md");
    const auto answer = text.find("## The answer: "), first = text.find("## "),
               limits = text.find("Drifts at which 5 to 95 %"),
               modes = text.find("Shares of the modes"), files = text.find("## Files");
    REQUIRE(limits != std::string::npos);
    CHECK(answer == first);
    CHECK(answer < limits);
    CHECK(limits < modes);
    CHECK(modes < files);
    std::size_t top = 0;
    for (const auto& entry : fs::directory_iterator(folder.path))
        top += entry.is_regular_file() ? 1 : 0;
    CHECK(top == 16); // README.md, four tables in three forms, JSON, pelicun, list of files
}

TEST_CASE("fragility output: a full disk leaves no index of tables that are not there",
          "[app][fragility_output]")
{
    const scenes::TemporaryFolder folder, full;
    const auto output = app::study_output(scenes::study_walls(5));
    app::write_output(folder.path, output);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    rlimit limit = before;
    limit.rlim_cur = fs::file_size(folder.path / "README.md"); // a table is larger
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    CHECK_THROWS_WITH(app::write_output(full.path, output), Catch::Contains("File too large"));
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    CHECK(!fs::exists(full.path / "README.md"));
}

TEST_CASE("fragility output: another run into the folder leaves nothing of the first",
          "[app][fragility_output]")
{
    const scenes::TemporaryFolder twice, once;
    app::StudyWalls ntc = scenes::study_walls(5), paper = ntc;
    ntc.states = {{"user", "early", "x"}, {"user", "late", "x"}};
    for (app::StudyLevel& level : ntc.levels)
        for (app::StudyWall& w : level.walls) w.reading.limits.assign(2, w.reading.ultimate);
    app::write_output(twice.path, app::study_output(ntc));
    CHECK(app::write_output(twice.path, app::study_output(paper)) > 0);
    app::write_output(once.path, app::study_output(paper));
    CHECK(files_in(twice.path) == files_in(once.path));
}

TEST_CASE(
    "fragility output: groups and limit states whose names differ in signs alone have files "
    "of their own",
    "[app][fragility_output]")
{
    const std::vector<std::string> names = {"\u03b1", "\u03b2", "A/B", "A b", "a_b"};
    app::DriftData data = scenes::drifts(std::vector(names.size(), std::vector{1.0, 2.0, 4.0}));
    for (std::size_t g = 0; g < names.size(); ++g) data.groups[g].name = names[g];
    data.states.push_back({"ntc", "SLC/", "another"});
    data.states.push_back({"ntc", "SLC A", "one that a group's name could follow"});
    for (app::DriftGroup& g : data.groups)
        for (app::DriftWall& w : g.walls) w.limits.assign(3, w.limits[0]);
    const auto output = app::drift_output(data);
    std::set<std::string> pictures, tables;
    for (const app::NamedPicture& p : output.pictures) pictures.insert(p.name);
    for (const app::NamedTable& t : output.tables) tables.insert(t.name);
    CHECK(pictures.size() == 3 * (1 + names.size()));
    CHECK(tables.size() == output.tables.size());
}

TEST_CASE(
    "fragility output: every table has a caption that says how many walls or by what rule",
    "[app][fragility_output]")
{
    for (const app::NamedTable& t : app::study_output(scenes::study_walls(30)).tables) {
        CAPTURE(t.name);
        CHECK(t.table.caption.size() > 80);
        CHECK(scenes::sound(t.table));
        CHECK_FALSE(t.table.rows.empty());
    }
}

TEST_CASE("fragility output: in JSON numbers are numbers, empty cells null, intervals apart",
          "[app][fragility_output]")
{
    const auto data = scenes::drifts({{1.0, 2.0, 4.0, 2.0}, {}});
    const auto json = nlohmann::json::parse(app::fragility_json(app::drift_output(data)));
    const auto& rows = json["tables"]["performance_limits"]["rows"];
    CHECK(rows[0]["median drift [%]"].get<double>() == Approx(2.0).epsilon(1e-12));
    CHECK(rows[0]["median drift lower [%]"].get<double>() < 2.0);
    CHECK(rows[1]["median drift [%]"].is_null());
    CHECK(rows[1]["note"] == "No wall gave a result.");
    CHECK(rows[1]["dispersion"].is_null());
}

TEST_CASE(
    "fragility output: a study without a wall, with one, or with one mode is written out in "
    "full",
    "[app][fragility_output]")
{
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        const scenes::TemporaryFolder folder;
        const auto output = app::study_output(scenes::study_walls(n));
        app::write_output(folder.path, output);
        for (const app::NamedTable& t : output.tables) {
            CAPTURE(n, t.name);
            CHECK(scenes::sound(t.table));
        }
        CHECK(nlohmann::json::accept(scenes::read_text(folder.path / "fragility.json")));
    }
}
