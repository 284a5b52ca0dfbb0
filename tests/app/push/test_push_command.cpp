#include "app/commands.hpp"
#include "app/text/csv.hpp"

#include "scenes/temporary_folder.hpp"
#include "scenes/terminal.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using scenes::read_text;

/// Quick and coarse: what is written is tested, not what is found.
const std::vector<std::string> kCoarse = {
    "solver.contact_points=2", "solver.block_modes=6", "solver.steps_per_mm=500",
    "load.max_displacement=4 mm", "output.snapshot_every=1 mm"};

struct Written {
    int code = -1;
    std::string terminal;
};

using scenes::Terminal;

Written push(const std::string& study, const fs::path& out, std::vector<std::string> overrides,
             int threads = 1, bool film = false)
{
    app::Command command;
    command.study = std::string(DRYSTONE_SOURCE_DIR) + "/configs/" + study;
    command.out = out.string();
    command.overrides = std::move(overrides);
    command.threads = threads;
    command.mean_wall = study == "quick.ini";
    command.quiet = true;
    command.film = film;
    const Terminal terminal;
    const int code = app::push_command(command);
    return {code, terminal.text()};
}

nlohmann::json summary(const fs::path& folder)
{
    return nlohmann::json::parse(read_text(folder / "summary.json"));
}

} // namespace

TEST_CASE(
    "push command: one wall gives curve, summary, pictures, series and the effective study",
    "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    CHECK(push("wall.ini", folder.path / "out", kCoarse).code == 0);
    for (const char* file : {"capacity.csv", "capacity.svg", "wall.svg", "summary.json",
                             "study.ini", "series/wall.pvd", "series/joints.pvd"})
        CHECK(fs::file_size(folder.path / "out" / file) > 0);
    const nlohmann::json s = summary(folder.path / "out");
    for (const char* key :
         {"peak_force_kN", "peak_displacement_mm", "ultimate_displacement_mm",
          "ultimate_censored", "mode", "energy_residual", "solver_error_percent",
          "points_error_percent", "solver_seconds", "contact_updates_per_second"})
        CHECK_FALSE(s.at(key).is_null());
    CHECK(s["vertical_stress_MPa"] == 0.5);
    CHECK(s["study"] == read_text(folder.path / "out" / "study.ini"));
}

TEST_CASE("push command: walls from pictures and drawings have all their stones in picture and "
          "series",
          "[app][push_command]")
{
    const auto [study, blocks] =
        GENERATE(std::pair{"picture.ini", 49 + 1}, std::pair{"drawing.ini", 15 + 1});
    const scenes::TemporaryFolder folder;
    const fs::path out = folder.path / "out";
    REQUIRE(push(study, out,
                 {"solver.fidelity=rigid", "solver.steps_per_mm=1000",
                  "load.max_displacement=0.2 mm", "output.snapshot_every=0.1 mm"})
                .code == 0);
    const std::string cells = "NumberOfCells=\"" + std::to_string(blocks) + "\"";
    CHECK(read_text(out / "series" / "wall_0001.vtu").find(cells) != std::string::npos);
    const std::string picture = read_text(out / "wall.svg");
    int polygons = 0;
    for (std::size_t at = 0; (at = picture.find("<polygon points", at)) != std::string::npos;
         ++at)
        ++polygons;
    CHECK(polygons >= 2 * blocks); // at the peak and at the end
    // Stones are outlines, read back to the same wall.
    CHECK(read_text(out / "study.ini").find("outlines ") != std::string::npos);
}

TEST_CASE("push command: a film changes nothing else, and goes with the push that made it",
          "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    const std::string paraview = GENERATE("yes", "no");
    std::vector<std::string> keys = kCoarse;
    keys.push_back("output.paraview=" + paraview);
    const fs::path still = folder.path / "still", film = folder.path / "film";
    CHECK(push("wall.ini", still, keys).code == 0);
    CHECK(push("wall.ini", film, keys, 1, true).code == 0);
    CHECK_FALSE(fs::exists(still / "film.svg"));
    const std::string moving = read_text(film / "film.svg");
    CHECK(moving.find("repeatCount") != std::string::npos);
    CHECK(moving.find("0.0 mm,  drift 0.00 %,") != std::string::npos);
    CHECK(moving.find("4.0 mm,  drift 0.36 %,") != std::string::npos);
    for (const char* const file : {"capacity.csv", "wall.svg", "study.ini"})
        CHECK(read_text(still / file) == read_text(film / file));
    CHECK(fs::exists(film / "series") == (paraview == "yes"));
    if (paraview == "yes")
        CHECK(read_text(still / "series/wall.pvd") == read_text(film / "series/wall.pvd"));
    CHECK(push("wall.ini", film, keys).code == 0); // without: the old film goes
    CHECK_FALSE(fs::exists(film / "film.svg"));
}

TEST_CASE("push command: the study it wrote gives the same curve again", "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    REQUIRE(push("wall.ini", folder.path / "a", kCoarse).code == 0);
    const fs::path again = fs::relative(folder.path / "a" / "study.ini",
                                        std::string(DRYSTONE_SOURCE_DIR) + "/configs");
    REQUIRE(push(again.string(), folder.path / "b", {}).code == 0);
    CHECK(read_text(folder.path / "a" / "capacity.csv") ==
          read_text(folder.path / "b" / "capacity.csv"));
}

TEST_CASE("push command: the series is spaced, of peak and end alone, or left out",
          "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    const auto files = [&](const std::string& setting) {
        std::vector<std::string> overrides = kCoarse;
        overrides.back() = setting;
        CHECK(push("wall.ini", folder.path / "out", overrides).code == 0);
        const fs::path series = folder.path / "out" / "series";
        return fs::exists(series) ? std::distance(fs::directory_iterator(series), {}) : 0;
    };
    CHECK(files("output.snapshot_every=1 mm") == 12); // five walls, twice, and what names them
    const auto ends = files("output.snapshot_every=0 mm");
    CHECK((ends == 4 || ends == 6)); // the peak may be the end
    CHECK(files("output.paraview=no") == 0);
}

TEST_CASE("push command: the wall of means is that of a study with the means for numbers",
          "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    const std::vector<std::string> means = {
        "joint.friction_angle=31.8 deg", "joint.stiffness_factor=1",
        "unit.tensile_strength=3.7 MPa", "unit.friction_angle=35 deg",
        "unit.stiffness_factor=1"};
    std::vector<std::string> numbers = kCoarse;
    numbers.insert(numbers.end(), means.begin(), means.end());
    CHECK(push("quick.ini", folder.path / "mean", kCoarse).code == 0);
    CHECK(push("quick.ini", folder.path / "numbers", numbers).code == 0);
    for (const char* level : {"0.50_MPa", "1.00_MPa", "1.25_MPa"})
        CHECK(read_text(folder.path / "mean" / level / "capacity.csv") ==
              read_text(folder.path / "numbers" / level / "capacity.csv"));
    CHECK(read_text(folder.path / "mean" / "0.50_MPa" / "study.ini")
              .starts_with("# The wall in which"));
}

TEST_CASE("push command: a wall taken out of a study runs again as it is, with the same bits",
          "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    const std::string spatial = GENERATE("none", "independent");
    std::vector<std::string> overrides = kCoarse;
    overrides[3] = "load.max_displacement=1 mm";
    overrides.push_back("uq.spatial=" + spatial);
    app::Command command;
    command.study = std::string(DRYSTONE_SOURCE_DIR) + "/configs/quick.ini";
    command.out = (folder.path / "a").string();
    command.overrides = overrides;
    command.sample = 5;
    command.level = "1.00 MPa";
    command.quiet = true;
    const auto run = [](const app::Command& c) {
        const Terminal terminal;
        return app::push_command(c);
    };
    REQUIRE(run(command) == 0);
    app::Command again;
    again.study = (folder.path / "a" / "study.ini").string();
    again.out = (folder.path / "b").string();
    again.quiet = true;
    REQUIRE(run(again) == 0);
    CHECK(read_text(folder.path / "a" / "capacity.csv") ==
          read_text(folder.path / "b" / "capacity.csv"));
    const auto values = [&](const char* name) {
        return summary(folder.path / name)["study"].get<std::string>();
    };
    CHECK(values("a").substr(values("a").find("\ndrawn")) ==
          values("b").substr(values("b").find("\ndrawn")));
    again.sample = 5;
    CHECK_THROWS_WITH(run(again), Catch::Contains("uq.drawn"));
    again.sample.reset();
    again.overrides = {"uq.drawn=1 MPa; joint.friction_angle = 30 deg"};
    CHECK_THROWS_WITH(run(again), Catch::Contains("the wall takes"));
}

TEST_CASE("push command: a run leaves no file of the one before it, and replaces no other's",
          "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    std::vector<std::string> overrides = kCoarse;
    overrides[3] = "load.max_displacement=0.5 mm";
    const fs::path out = folder.path / "out";
    REQUIRE(push("levels.ini", out, overrides).code == 0);
    REQUIRE(fs::exists(out / "levels.svg"));
    REQUIRE(push("wall.ini", out, overrides).code == 0);
    CHECK(fs::exists(out / "summary.json"));
    for (const char* name : {"levels.csv", "levels.svg", "0.15_MPa", "1.25_MPa"})
        CHECK_FALSE(fs::exists(out / name));
    fs::remove(out / "drystone_push_files.txt"); // now the files are somebody's
    const std::string before = read_text(out / "summary.json");
    CHECK_THROWS_WITH(push("wall.ini", out, overrides), Catch::Contains("exists already"));
    CHECK(read_text(out / "summary.json") == before);
}

TEST_CASE(
    "push command: the curve has the energies of each point, the last that of the summary",
    "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    REQUIRE(push("wall.ini", folder.path / "out", kCoarse).code == 0);
    const std::string csv = read_text(folder.path / "out" / "capacity.csv");
    CHECK(csv.starts_with("displacement_mm,drift_percent,force_kN,base_shear_kN,unbalance_kN,"
                          "work_J,elastic_J,friction_J,fracture_J,crushing_J,damping_J,"
                          "kinetic_J,lifted_J\n"));
    const std::size_t last = csv.rfind('\n', csv.size() - 2) + 1;
    std::istringstream line(csv.substr(last));
    std::vector<double> values;
    for (std::string cell; std::getline(line, cell, ',');) values.push_back(std::stod(cell));
    REQUIRE(values.size() == 13);
    const auto energy = summary(folder.path / "out")["energy"];
    CHECK(values[5] == Approx(energy["work_J"].get<double>()).epsilon(1e-8));
    CHECK(values[7] == Approx(energy["friction_J"].get<double>()).epsilon(1e-8));
    CHECK(values[3] == Approx(values[2]).epsilon(0.01)); // nearly in balance
}

TEST_CASE("push command: limit states are in tables, with what governs", "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    std::vector<std::string> overrides = kCoarse;
    overrides[3] = "load.max_displacement=14 mm";
    overrides.push_back("load.vertical_stress=0.15 MPa");
    const Written w = push("wall.ini", folder.path / "out", overrides);
    REQUIRE(w.code == 0);
    CHECK(w.terminal.find("ntc SLC") != std::string::npos);
    const std::string csv = read_text(folder.path / "out" / "limit_states.csv");
    CHECK(csv.find("ntc SLC") != std::string::npos);
    CHECK(csv.find("governed by the code's drift limit") != std::string::npos);
    CHECK(w.terminal.starts_with("stress [MPa]"));
    CHECK(w.terminal.find("energy residual") == std::string::npos); // in summary.json
    CHECK(w.terminal.find("\nsolver error of the peak force: ") != std::string::npos);
    CHECK(w.terminal.find("\nerror of the force by the number of contact points: ") !=
          std::string::npos);
    CHECK(w.terminal.find("\n\n") ==
          w.terminal.rfind("\n\n")); // two tables, none in two blocks
    const auto results = summary(folder.path / "out");
    int found = 0;
    for (const auto& state : results["limit_states"])
        if (state["name"] == "SLC") {
            ++found;
            CHECK(state["drift_percent"] == Approx(1.0));
        }
    CHECK(found == 1);
}

TEST_CASE("push command: a wall that is not symmetric is pushed the other way too, and says "
          "both peaks",
          "[app][push_command][repeats]")
{
    const scenes::TemporaryFolder folder;
    std::vector<std::string> keys = kCoarse;
    keys.back() = "output.paraview=no";
    const int threads = GENERATE(1, 2);
    const Written both = push("facade.ini", folder.path / "both", keys, threads);
    CHECK(both.terminal.find("the wall is not symmetric: pushed to the right") !=
          std::string::npos);
    const nlohmann::json right = summary(folder.path / "both");
    keys.emplace_back("load.targets=-4 mm"); // its toe is at the left, too
    static_cast<void>(push("facade.ini", folder.path / "left", keys, threads));
    const nlohmann::json left = summary(folder.path / "left");
    CHECK(right["other_way"]["peak_force_kN"] == left["peak_force_kN"]); // to the bit
    CHECK(left["other_way"]["peak_force_kN"] == right["peak_force_kN"]);
    CHECK(right["peak_force_kN"] > left["peak_force_kN"]);

    CHECK(push("wall.ini", folder.path / "wall", kCoarse).terminal.find("symmetric") ==
          std::string::npos);
    CHECK_FALSE(summary(folder.path / "wall").contains("other_way"));
}

TEST_CASE("push command: a wall that failed has its reason on stderr, however quiet",
          "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    std::ostringstream said;
    std::streambuf* const screen = std::cerr.rdbuf(said.rdbuf());
    const int code = push("wall.ini", folder.path / "out", {"solver.most_steps=10"}).code;
    std::cerr.rdbuf(screen);
    CHECK(code == 1);
    CHECK(said.str() ==
          "drystone: 0.50 MPa: the wall failed: solver.most_steps was not enough\n");
}

TEST_CASE(
    "push command: the error of an ultimate displacement is a least error where its range "
    "goes on beyond the push",
    "[app][push_command]")
{
    const auto error_line = [](const std::string& end) {
        const scenes::TemporaryFolder folder;
        const std::string text =
            push("wall.ini", folder.path / "out",
                 {"solver.kinematics=finite", "solver.fidelity=rigid", "unit.cracks=none",
                  "solver.contact_points=2", "solver.accuracy=10 %", "load.stop_below=0.5",
                  "load.max_displacement=" + end})
                .terminal;
        const std::size_t from = text.find("solver error of the peak force");
        REQUIRE(from != std::string::npos);
        return text.substr(from, text.find('\n', from) - from);
    };
    // The wall rocks; its force comes down to 80 % of the peak at 104 mm.
    const std::string known = error_line("150 mm"), open = error_line("110 mm");
    CHECK(known.find("; of the ultimate displacement: ") != std::string::npos);
    CHECK(known.find("at least") == std::string::npos);
    CHECK(open.find("; of the ultimate displacement: at least ") != std::string::npos);
}

TEST_CASE("push command: one thread and two give the same bits", "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    const Written one = push("levels.ini", folder.path / "one", kCoarse, 1);
    const Written two = push("levels.ini", folder.path / "two", kCoarse, 2);
    CHECK(one.code == 0);
    CHECK(two.code == 0);
    for (const char* level : {"0.15_MPa", "0.50_MPa", "0.75_MPa", "1.00_MPa", "1.25_MPa"})
        for (const char* file : {"capacity.csv", "wall.svg", "series/joints_0002.vtu"}) {
            const std::string a = read_text(folder.path / "one" / level / file);
            REQUIRE_FALSE(a.empty());
            CHECK(a == read_text(folder.path / "two" / level / file));
        }
    for (const char* table : {"levels.csv", "levels.md", "levels.tex"})
        CHECK(read_text(folder.path / "one" / table) == read_text(folder.path / "two" / table));
    CHECK(one.terminal.find("1.25") != std::string::npos);
}

TEST_CASE("push command: a push that turns back has cycles, and limit states by direction",
          "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    std::vector<std::string> overrides = kCoarse;
    overrides[3] = "load.amplitudes=1, 2 mm";
    overrides[4] = "output.snapshot_every=0.5 mm";
    REQUIRE(push("wall.ini", folder.path / "out", overrides).code == 0);
    const nlohmann::json s = summary(folder.path / "out");
    CHECK(s["read_on"] == "mean");
    CHECK(s["ultimate_displacement_mm"] == Approx(2.0).epsilon(0.01)); // where it ends
    CHECK_FALSE(s["limit_states"].empty());
    const auto& sides = s["backbones"];
    const double right = sides["right"]["peak_force_kN"], left = sides["left"]["peak_force_kN"];
    CHECK(s["peak_force_kN"].get<double>() == Approx(0.5 * (right + left)).epsilon(0.02));
    CHECK(sides["worse"]["peak_force_kN"].get<double>() == std::min(right, left));
    CHECK(s["mechanism"]["rotation_share"].get<double>() != 0.0);
    const std::string cycles = read_text(folder.path / "out" / "cycles.csv"),
                      backbones = read_text(folder.path / "out" / "backbones.csv");
    CHECK(std::ranges::count(cycles, '\n') == 3);
    CHECK(cycles.find("\n2,2,") != std::string::npos); // its amplitude is that of the protocol
    CHECK(backbones.find("\nleft,2,") != std::string::npos);
    const app::Csv rows = app::parse_csv("cycles.csv", cycles);
    const auto cell = [&](const app::CsvRow& row, const char* head) {
        return std::stod(row.cells.at(app::find_column(rows, head)));
    };
    for (const app::CsvRow& row : rows.rows) {
        double sum = 0.0;
        for (const char* const part :
             {"friction_J", "fracture_J", "crushing_J", "solver_J", "stored_J"})
            sum += cell(row, part);
        // the energy is read off the points of the curve: a difference of what goes in and out
        const double through = cell(row, "amplitude_mm") *
                               (cell(row, "force_plus_kN") - cell(row, "force_minus_kN"));
        CHECK(sum == Approx(cell(row, "energy_J")).margin(2e-3 * through));
    }
    // The series for ParaView goes through the cycles: a way of 12 mm.
    const std::string series = read_text(folder.path / "out" / "series" / "wall.pvd");
    std::size_t files = 0;
    for (std::size_t at = 0; (at = series.find("<DataSet", at)) != std::string::npos; ++at)
        ++files;
    CHECK(files >= 24);
    const std::string_view last = "timestep=\"";
    CHECK(std::stod(series.substr(series.rfind(last) + last.size())) ==
          Approx(12.0).epsilon(0.1));
}

TEST_CASE("push command: a push to and fro beyond the drift limit of a code says so",
          "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    std::vector<std::string> overrides = kCoarse;
    overrides[3] = "load.amplitudes=3, 12 mm"; // a wall that rocks has SLC at 11 mm
    overrides[4] = "solver.accuracy=20 %";
    REQUIRE(push("wall.ini", folder.path / "out", overrides).code == 0);
    const std::string table = read_text(folder.path / "out" / "limit_states.csv");
    CHECK_THAT(table, Catch::Contains("governed by the code's drift limit"));
    CHECK_THAT(table, !Catch::Contains("pier"));
}

TEST_CASE(
    "push command: stress levels that differ in the third place have folders of their own",
    "[app][push_command]")
{
    const scenes::TemporaryFolder folder;
    std::vector<std::string> overrides = kCoarse;
    overrides[3] = "load.max_displacement=0.5 mm";
    overrides.insert(overrides.end(), {"load.vertical_stress=0.501, 0.502 MPa",
                                       "joint.wall_modulus=768, 769 MPa"});
    REQUIRE(push("wall.ini", folder.path / "out", overrides).code == 0);
    CHECK(summary(folder.path / "out" / "0.501_MPa")["vertical_stress_MPa"] == Approx(0.501));
    CHECK(summary(folder.path / "out" / "0.502_MPa")["vertical_stress_MPa"] == Approx(0.502));
}
