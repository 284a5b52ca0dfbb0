/// The series of pushes, written while the walls are pushed.

#include "app/push/pushed_series.hpp"

#include "app/child_process.hpp"
#include "app/commands.hpp"
#include "app/store/hdf5/store_error.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <sys/resource.h>
#include <thread>

namespace {

namespace fs = std::filesystem;
using scenes::read_text;

using Overrides = std::vector<std::string>;

/// Three courses of three units, rigid.
const Overrides kSmall = {"wall.length=0.6 m",         "wall.courses=3",
                          "load.height=0.4 m",         "solver.fidelity=rigid",
                          "solver.contact_points=2",   "solver.steps_per_mm=500",
                          "load.max_displacement=2 mm"};

/// Overrides of `base`, but for keys that `more` has.
Overrides with(Overrides more, const Overrides& base = kSmall)
{
    const auto key = [](const std::string& text) { return text.substr(0, text.find('=')); };
    const Overrides given = more;
    for (const std::string& text : base)
        if (std::ranges::none_of(given,
                                 [&](const std::string& g) { return key(g) == key(text); }))
            more.push_back(text);
    return more;
}

int push(const fs::path& out, const Overrides& overrides, const std::string& study = "wall.ini",
         int threads = 1)
{
    app::Command command;
    command.study = std::string(DRYSTONE_SOURCE_DIR) + "/configs/" + study;
    command.out = out.string();
    command.overrides = overrides;
    command.threads = threads;
    command.quiet = true;
    const std::ostringstream nowhere;
    std::streambuf* const screen = std::cout.rdbuf(nowhere.rdbuf());
    struct Back {
        std::streambuf* screen;
        ~Back() { std::cout.rdbuf(screen); }
    } const back{screen};
    return app::push_command(command);
}

/// Names below the folder, with what is in them.
std::map<std::string, std::string> content(const fs::path& folder)
{
    std::map<std::string, std::string> files;
    if (!fs::exists(folder)) return files;
    for (const fs::directory_entry& e : fs::recursive_directory_iterator(folder))
        if (e.is_regular_file())
            files[e.path().lexically_relative(folder).string()] = read_text(e.path());
    return files;
}

nlohmann::json summary(const fs::path& out)
{
    return nlohmann::json::parse(read_text(out / "summary.json"));
}

/// Largest resident memory of this process so far [MiB].
double peak_memory()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

} // namespace

TEST_CASE("pushed series: a push that starts anew has the series of its last try alone",
          "[app][pushed_series]")
{
    // A wall that cracks, whose ledger is more open at the larger step.
    const Overrides weak = {"wall.length=0.6 m",           "wall.courses=3",
                            "load.height=0.4 m",           "load.vertical_stress=1.25 MPa",
                            "solver.contact_points=3",     "solver.block_modes=6",
                            "unit.tensile_strength=1 MPa", "output.snapshot_every=0.25 mm",
                            "load.max_displacement=3 mm",  "joint.wall_modulus=1000 MPa"};
    const Overrides first = with({"solver.step_fraction=0.9", "solver.steps_per_mm=300"}, weak),
                    half = with({"solver.step_fraction=0.45", "solver.steps_per_mm=600"}, weak);
    const scenes::TemporaryFolder folder;
    REQUIRE(push(folder.path / "first", first) == 0);
    REQUIRE(push(folder.path / "half", half) == 0);
    const double open = summary(folder.path / "first")["energy_residual"],
                 closed = summary(folder.path / "half")["energy_residual"];
    REQUIRE(std::abs(open) > 1.5 * std::abs(closed));
    std::ostringstream tolerance;
    tolerance.precision(17);
    tolerance << "solver.energy_tolerance=" << std::sqrt(std::abs(open * closed));
    REQUIRE(push(folder.path / "anew", with({tolerance.str()}, first)) == 0);
    const auto series = content(folder.path / "anew" / "series");
    CHECK(summary(folder.path / "anew")["step_reductions"] == 1);
    CHECK(series.size() > 20);
    CHECK(series == content(folder.path / "half" / "series"));
    CHECK(series != content(folder.path / "first" / "series"));
}

TEST_CASE("pushed series: memory does not grow with the number of snapshots",
          "[app][pushed_series][slow]") // slow: a sanitizer holds on to memory that is free
{
    const scenes::TemporaryFolder folder;
    const auto grown = [&] {
        const auto run = [&](const char* every) {
            return push(
                folder.path / "out",
                with({"output.record_every=0.002 mm", "wall.courses=6", "load.height=0.7 m",
                      "output.snapshot_every=" + std::string(every) + " mm"}));
        };
        if (run("0.5") != 0) return 200;
        const double before = peak_memory();
        if (run("0.002") != 0) return 201;
        return static_cast<int>(std::min(100.0, peak_memory() - before));
    };
    CHECK(scenes::wait_for(scenes::start_child(grown)) <= 8); // kept, they took some 60
    std::size_t files = 0;
    for (const auto& [name, text] : content(folder.path / "out" / "series"))
        files += name.starts_with("wall_");
    CHECK(files > 800);
}

TEST_CASE("pushed series: a push that is killed leaves nothing under the name of a series, and "
          "the next one works",
          "[app][pushed_series]")
{
    const scenes::TemporaryFolder folder;
    const fs::path out = folder.path / "out", part = out / "series.part";
    const Overrides many = with({"output.record_every=0.01 mm", "output.snapshot_every=0.01 mm",
                                 "load.max_displacement=500 mm"});
    const pid_t child = scenes::start_child([&] { return push(out, many); });
    const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (!fs::exists(part / "joints_0003.vtu") && std::chrono::steady_clock::now() < limit)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ::kill(child, SIGKILL);
    REQUIRE(scenes::wait_for(child) == -SIGKILL);
    REQUIRE(fs::exists(part / "joints_0003.vtu"));
    CHECK_FALSE(fs::exists(out / "series"));
    const Overrides few = with({"output.snapshot_every=0.5 mm"});
    REQUIRE(push(out, few) == 0);
    REQUIRE(push(folder.path / "fresh", few) == 0);
    CHECK(content(out / "series") == content(folder.path / "fresh" / "series"));
    CHECK_FALSE(fs::exists(part));
    CHECK_FALSE(fs::exists(out / "drystone_push.lock"));
}

TEST_CASE(
    "pushed series: a full disk ends the push with an error and leaves the earlier results",
    "[app][pushed_series]")
{
    const scenes::TemporaryFolder folder;
    const fs::path out = folder.path / "out";
    const bool earlier = GENERATE(true, false);
    const Overrides few = with({"output.snapshot_every=0.5 mm"});
    if (earlier) REQUIRE(push(out, few) == 0);
    const auto before = content(out);
    const auto full = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{2000, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &small);
        try {
            return push(out, few);
        } catch (const std::runtime_error& e) {
            const std::string what = e.what();
            return what.starts_with("cannot write '") && what.find(".vtu") != std::string::npos
                       ? 77
                       : 2;
        }
    };
    CHECK(scenes::wait_for(scenes::start_child(full)) == 77);
    CHECK(content(out) == before);
    CHECK(fs::exists(out) == earlier);
}

TEST_CASE("pushed series: a series that no run of ours wrote is not replaced",
          "[app][pushed_series]")
{
    const scenes::TemporaryFolder folder;
    const fs::path out = folder.path / "out";
    const std::string where = GENERATE("series/wall.pvd", "series.part/wall_0000.vtu");
    fs::create_directories((out / where).parent_path());
    std::ofstream(out / where) << "mine";
    const auto before = content(out);
    const Overrides few = with({"output.snapshot_every=0.5 mm"});
    CHECK_THROWS_WITH(push(out, few), Catch::Contains(where + ": exists already"));
    CHECK(content(out) == before);
    REQUIRE(push(out, with({"output.paraview=no"}, few)) == 0); // writes none
    CHECK(read_text(out / where) == "mine");
}

TEST_CASE("pushed series: a folder that another run holds is refused", "[app][pushed_series]")
{
    const scenes::TemporaryFolder folder;
    {
        const app::PushedSeries other(folder.path / "out", {""});
        CHECK_THROWS_AS(push(folder.path / "out", kSmall), app::StoreError);
    }
    CHECK(fs::is_empty(folder.path));
    CHECK(push(folder.path / "out", kSmall) == 0);
}

TEST_CASE("pushed series: what a killed push left of walls that this one has not goes too",
          "[app][pushed_series]")
{
    const scenes::TemporaryFolder folder;
    const fs::path out = folder.path / "out", level = out / "0.15_MPa";
    fs::create_directories(level / "series.part");
    std::ofstream(level / "series.part" / "drystone_unfinished.txt") << "";
    std::ofstream(level / "series.part" / "wall_0000.vtu") << "";
    REQUIRE(push(out, kSmall) == 0);
    CHECK_FALSE(fs::exists(level / "series.part"));
}

TEST_CASE("pushed series: of any number of snapshots there is at most one for each point",
          "[app][pushed_series]")
{
    const scenes::TemporaryFolder folder;
    const fs::path out = folder.path / "out";
    REQUIRE(push(out, with({"output.snapshot_every=1e-6 mm", "output.record_every=0.1 mm"})) ==
            0);
    const std::string curve = read_text(out / "capacity.csv");
    const auto points = static_cast<std::size_t>(std::ranges::count(curve, '\n') - 1);
    CHECK(content(out / "series").size() == 2 * points + 2);
}
