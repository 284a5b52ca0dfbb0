#include "app/output/series_folder.hpp"

#include "app/child_process.hpp"
#include "app/text/config_error.hpp"
#include "tests/app/output/series_scene.hpp"
#include "tests/scenes/snapshot_scenes.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <tuple>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>
#include <sys/resource.h>

namespace fs = std::filesystem;
using app::SeriesFolder;
using scenes::read_text;

namespace {

std::vector<dem::Snapshot> a_push(int walls, double step = 1e-3)
{
    std::vector<dem::Snapshot> all = {scenes::wall_at_rest()};
    for (int i = 1; i < walls; ++i) all.push_back(scenes::stair_step_rocking(step * i));
    return all;
}

/// Content by name; empty where there is no folder.
std::map<std::string, std::string> content(const fs::path& folder)
{
    std::map<std::string, std::string> files;
    std::error_code nothing_there;
    for (const fs::directory_entry& e : fs::directory_iterator(folder, nothing_there))
        files[e.path().filename().string()] = read_text(e.path());
    return files;
}

/// The same, written at once into a folder of its own.
std::map<std::string, std::string> at_once(const std::vector<dem::Snapshot>& walls)
{
    const scenes::TemporaryFolder folder;
    scenes::write_series(folder.path / "series", walls);
    return content(folder.path / "series");
}

void add_all(SeriesFolder& series, const std::vector<dem::Snapshot>& walls)
{
    for (const dem::Snapshot& wall : walls) series.add(wall);
}

struct Folder {
    scenes::TemporaryFolder temporary;
    fs::path series = temporary.path / "series", part = temporary.path / "series.part";
};

/// The refusal of a run that would write a series; empty if there is none.
std::string in_the_way(const Folder& f)
{
    std::vector<fs::path> names;
    for (const fs::path& file : app::in_the_way_of_series(f.series))
        names.push_back(file.lexically_relative(f.temporary.path));
    try {
        std::ignore = app::check_results(f.temporary.path, names);
    } catch (const app::ConfigError& e) {
        return e.what();
    }
    return {};
}

} // namespace

TEST_CASE("series folder: walls go to disk one by one, and under their name when all are there",
          "[app][series_folder]")
{
    const Folder f;
    scenes::write_series(f.series, a_push(5));
    const auto before = content(f.series);
    const std::vector<dem::Snapshot> walls = a_push(3, 2e-3);
    {
        SeriesFolder series(f.series);
        CHECK(series.empty());
        CHECK_FALSE(fs::exists(f.part));
        for (std::size_t i = 0; i < walls.size(); ++i) {
            series.add(walls[i]);
            CHECK(fs::exists(f.part / ("wall_000" + std::to_string(i) + ".vtu")));
            CHECK(fs::exists(f.part / ("joints_000" + std::to_string(i) + ".vtu")));
        }
        CHECK_FALSE(series.empty());
        const std::vector<app::OutputFile> files = series.seal();
        CHECK(content(f.series) == before);
        app::write_results(f.temporary.path, files);
        CHECK(content(f.series) == at_once(walls));
    }
    CHECK(content(f.series) == at_once(walls));
    CHECK_FALSE(fs::exists(f.part));
}

TEST_CASE("series folder: a push that starts anew leaves nothing of its first try",
          "[app][series_folder]")
{
    const Folder f;
    SeriesFolder series(f.series);
    series.begin_anew(); // before the first wall too
    add_all(series, a_push(6, 3e-3));
    series.begin_anew();
    CHECK(series.empty());
    CHECK(content(f.part).size() == 1); // that it is unfinished
    const std::vector<dem::Snapshot> walls = a_push(3);
    add_all(series, walls);
    app::write_results(f.temporary.path, series.seal());
    CHECK(content(f.series) == at_once(walls));
}

TEST_CASE(
    "series folder: a value that is not finite counts only if the push is not started anew",
    "[app][series_folder]")
{
    const Folder f;
    std::vector<dem::Snapshot> walls = a_push(3);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SECTION("in a joint") { walls[1].faces[5].contacts[0].sigma = nan; }
    SECTION("in the way") { walls[1].displacement = nan; }
    SeriesFolder series(f.series);
    CHECK_NOTHROW(add_all(series, walls));
    CHECK_THROWS_AS(series.seal(), std::invalid_argument);
    CHECK_FALSE(fs::exists(f.series));
    series.begin_anew();
    add_all(series, a_push(2));
    app::write_results(f.temporary.path, series.seal());
    CHECK(content(f.series) == at_once(a_push(2)));
}

TEST_CASE("series folder: what is not moved goes, with the folders that were made for it",
          "[app][series_folder]")
{
    const scenes::TemporaryFolder folder;
    {
        SeriesFolder series(folder.path / "level" / "series");
        add_all(series, a_push(2));
        (void)series.seal();
    }
    CHECK(fs::is_empty(folder.path));
    fs::create_directory(folder.path / "level");
    {
        SeriesFolder series(folder.path / "level" / "series");
        add_all(series, a_push(2));
    }
    CHECK(fs::is_empty(folder.path / "level")); // was there before
}

TEST_CASE(
    "series folder: a kill leaves what is known as unfinished, and the next run starts clean",
    "[app][series_folder]")
{
    const Folder f;
    const bool earlier = GENERATE(false, true);
    if (earlier) scenes::write_series(f.series, a_push(5));
    const auto before = content(f.series);
    const pid_t child = scenes::start_child([&]() -> int {
        SeriesFolder series(f.series);
        add_all(series, a_push(4));
        std::ofstream(f.part / ".wall_0004.vtu.77-1.tmp") << "half of it";
        if (earlier) (void)series.seal();
        return std::raise(SIGKILL);
    });
    REQUIRE(scenes::wait_for(child) == -SIGKILL);
    CHECK(content(f.series) == before);
    CHECK(fs::exists(f.part / "wall_0003.vtu"));
    CHECK(in_the_way(f).empty());
    scenes::write_series(f.series, a_push(2));
    CHECK(content(f.series) == at_once(a_push(2)));
    CHECK_FALSE(fs::exists(f.part));
}

TEST_CASE(
    "series folder: a full disk is an error that names the file, and leaves what was there",
    "[app][series_folder]")
{
    const Folder f;
    scenes::write_series(f.series, a_push(2));
    const auto before = content(f.series);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const auto full = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{fs::file_size(f.series / "joints_0000.vtu") - 1, limit.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
        SeriesFolder series(f.series);
        try {
            add_all(series, a_push(2));
        } catch (const std::runtime_error& e) {
            const std::string what = e.what();
            return what.find("joints_0000.vtu") != std::string::npos ? 0 : 2;
        }
        return 3;
    };
    CHECK(scenes::wait_for(scenes::start_child(full)) == 0);
    CHECK(content(f.series) == before);
    CHECK_FALSE(fs::exists(f.part));
}

TEST_CASE("series folder: files of others are told, and stay", "[app][series_folder]")
{
    const Folder f;
    const std::string name =
        GENERATE("wall.pvd", "joints.pvd", "wall_0000.vtu", "joints_12345.vtu");
    CHECK(in_the_way(f).empty());
    fs::create_directory(f.series);
    for (const char* other : {"wall_000.vtu", "wall_00x0.vtu", "walls_0000.vtu", "notes.txt"})
        std::ofstream(f.series / other) << "mine";
    CHECK(in_the_way(f).empty());
    std::ofstream(f.series / name) << "mine";
    CHECK_THAT(in_the_way(f), Catch::Contains((f.series / name).string()));
    fs::rename(f.series, f.part); // not marked as ours
    CHECK_THAT(in_the_way(f), Catch::Contains((f.part / name).string()));
    app::remove_unfinished_series(f.series);
    CHECK(read_text(f.part / name) == "mine");
}

TEST_CASE(
    "series folder: what was interrupted while it was removed or moved is still known as ours",
    "[app][series_folder]")
{
    const Folder f;
    scenes::write_series(f.series, a_push(4));
    for (const char* gone : {"wall.pvd", "joints.pvd", "wall_0003.vtu"})
        fs::remove(f.series / gone);
    CHECK(in_the_way(f).empty());
    app::write_results(f.temporary.path, {});
    CHECK_FALSE(fs::exists(f.series));
}

TEST_CASE("series folder: of two series the files of both are never side by side",
          "[app][series_folder]")
{
    const Folder f;
    scenes::write_series(f.series, a_push(5));
    fs::create_directory(f.part);
    std::ofstream(f.part / "wall_0000.vtu") << "new";
    // the second file cannot be moved: as after a kill
    CHECK_THROWS_WITH(
        app::write_results(f.temporary.path,
                           {{"series/wall_0000.vtu", {}, f.part / "wall_0000.vtu"},
                            {"series/wall.pvd", {}, f.part / "wall.pvd"}}),
        Catch::Contains("cannot write") && Catch::Contains("wall.pvd"));
    CHECK(content(f.series) == std::map<std::string, std::string>{{"wall_0000.vtu", "new"}});
    fs::remove_all(f.part);
    CHECK(in_the_way(f).empty());
    scenes::write_series(f.series, a_push(2));
    CHECK(content(f.series) == at_once(a_push(2)));
}
