#include "app/fragility/fragility_output.hpp"

#include "app/fragility/fragility_command.hpp"
#include "app/fragility_scenes.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>
#include <string>

namespace fs = std::filesystem;

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
        for (const char* const end : {".csv", ".md", ".tex"}) wanted.insert(t.name + end);
    for (const app::NamedPicture& p : output.pictures) wanted.insert(p.name + ".svg");
    std::set<std::string> there;
    for (const auto& entry : fs::directory_iterator(folder.path))
        there.insert(entry.path().filename().string());
    CHECK(there == wanted);
    const std::string index = scenes::read_text(folder.path / "README.md");
    for (const app::NamedTable& t : output.tables)
        CHECK(index.find("](" + t.name + ".md)") != std::string::npos);
    for (const app::NamedPicture& p : output.pictures)
        CHECK(index.find("](" + p.name + ".svg)") != std::string::npos);
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
