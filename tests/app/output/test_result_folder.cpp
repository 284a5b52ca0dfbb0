#include "app/output/result_folder.hpp"

#include "app/text/config_error.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <set>
#include <string>

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

void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

} // namespace

TEST_CASE(
    "result folder: files of an earlier run are removed, with folders that are empty then",
    "[app][result_folder]")
{
    const scenes::TemporaryFolder out;
    CHECK(app::write_results(out.path, {{"a.csv", "1"}, {"old/b.csv", "2"}}) == 0);
    CHECK(app::write_results(out.path, {{"a.csv", "3"}, {"new/c.csv", "4"}}) == 1);
    CHECK(files_in(out.path) == std::set<std::string>{"a.csv", "new/c.csv"});
    CHECK_FALSE(fs::exists(out.path / "old"));
    CHECK(app::write_results(out.path, {{"a.csv", "3"}, {"new/c.csv", "4"}}) == 0);
}

TEST_CASE("result folder: files that are not ours, and ours that were edited, are left alone",
          "[app][result_folder]")
{
    const scenes::TemporaryFolder out;
    app::write_results(out.path, {{"a.csv", "1"}, {"b.csv", "2"}});
    put(out.path / "mine.txt", "mine");
    put(out.path / "b.csv", "edited");
    CHECK(app::write_results(out.path, {{"c.csv", "3"}}) == 1);
    CHECK(files_in(out.path) == std::set<std::string>{"b.csv", "c.csv", "mine.txt"});
}

TEST_CASE("result folder: files that are added leave those of before, and the next run removes "
          "both",
          "[app][result_folder]")
{
    const scenes::TemporaryFolder out;
    app::write_results(out.path, {{"a.csv", "1"}});
    app::add_results(out.path, {{"0.50_MPa/b.csv", "2"}});
    CHECK(files_in(out.path) == std::set<std::string>{"0.50_MPa/b.csv", "a.csv"});
    CHECK(scenes::read_text(out.path / "a.csv") == "1");
    put(out.path / "mine.txt", "mine");
    CHECK_THROWS_AS(app::add_results(out.path, {{"mine.txt", "ours"}}), app::ConfigError);
    CHECK(app::write_results(out.path, {{"c.csv", "3"}}) == 2);
    CHECK(files_in(out.path) == std::set<std::string>{"c.csv", "mine.txt"});
}

TEST_CASE("result folder: a file that is not ours is not replaced, and nothing is written then",
          "[app][result_folder]")
{
    const scenes::TemporaryFolder out;
    put(out.path / "README.md", "mine");
    CHECK_THROWS_AS(app::write_results(out.path, {{"a.csv", "1"}, {"README.md", "ours"}}),
                    app::ConfigError);
    CHECK(files_in(out.path) == std::set<std::string>{"README.md"});
}

TEST_CASE("result folder: a list that names files outside removes none of them",
          "[app][result_folder]")
{
    const scenes::TemporaryFolder out;
    const fs::path folder = out.path / "results";
    app::write_results(folder, {{"a.csv", "1"}});
    put(out.path / "secret.txt", "");
    std::ifstream in(folder / app::kFileList);
    std::string opening;
    std::getline(in, opening);
    put(folder / app::kFileList,
        opening + "\ncbf29ce484222325 ../secret.txt\n"); // sum of nothing
    app::write_results(folder, {{"b.csv", "1"}});
    CHECK(fs::exists(out.path / "secret.txt"));
}
