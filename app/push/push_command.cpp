#include "app/commands.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/keys/limit_state_text.hpp"
#include "app/input/sheet_offer.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_name.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/backbones_csv.hpp"
#include "app/output/cycles_csv.hpp"
#include "app/output/picture/film_video.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/replaced_file.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/cells.hpp"
#include "app/output/table/table_files.hpp"
#include "app/push/capacity_svg.hpp"
#include "app/push/capacity_text.hpp"
#include "app/push/drawn_picture.hpp"
#include "app/push/hand_checks.hpp"
#include "app/push/level_table.hpp"
#include "app/push/limit_table.hpp"
#include "app/push/pier_picture.hpp"
#include "app/push/pier_table.hpp"
#include "app/push/push_film.hpp"
#include "app/push/push_until_told.hpp"
#include "app/push/pushed_picture.hpp"
#include "app/push/pushed_series.hpp"
#include "app/push/summary_json.hpp"
#include "app/push/test_curve.hpp"
#include "app/reading/points_error.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/other_way.hpp"
#include "app/study/pushed/drawn_wall.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {

namespace {

namespace fs = std::filesystem;

/// The values that were drawn for one wall, in the units of their keys.
Table drawn_table(const std::vector<RandomInput>& random, const WallDraw& draw)
{
    Table t;
    t.head = {"input", "unit", "value"};
    for (std::size_t i = 0; i < draw.values.size(); ++i) {
        const RandomInput& input = random[i];
        const std::vector<double>& values = draw.values[i];
        const std::string unit = input.unit.empty() ? "-" : std::string(input.unit);
        for (std::size_t id = 0; id < values.size(); ++id)
            t.rows.push_back(
                {values.size() == 1 ? input.key : input.key + "." + std::to_string(id + 1),
                 unit, Number{from_si(values[id], input.unit)}});
    }
    return t;
}

/// The study as it was used. Of a study with distributions it names the wall that was pushed,
/// and can be pushed as it is.
std::string configuration(const Study& used, const Command& command)
{
    if (used.random.empty())
        return (command.sample ? "# Wall " + std::to_string(*command.sample) +
                                     " of this study: wall.seed gives its layout.\n"
                               : std::string()) +
               effective_configuration(used);
    const std::string which =
        command.mean_wall ? "The wall in which each value is the mean of its distribution"
        : command.sample  ? "Wall " + std::to_string(*command.sample) + " of this study"
                          : "One wall of this study";
    return "# " + which + ": uq.drawn gives its values, which push takes.\n" +
           effective_configuration(used);
}

constexpr std::string_view kPushList = "drystone_push_files.txt";
constexpr const char* kInterruptedCurve = "capacity_interrupted.csv";

/// The files of one wall, but for the series.
std::vector<OutputFile> wall_files(const Study& used, const dem::Layout& layout,
                                   const PushedWall& w, const Command& command,
                                   const std::vector<TestCurve>& beside)
{
    std::vector<OutputFile> files = {{"study.ini", configuration(used, command)},
                                     {"summary.json", summary_json(used, layout, w)}};
    if (dem::failed(w.result.outcome)) return files;
    files.push_back({"capacity.csv", capacity_text(w)});
    if (push_way(used.load).direction == 0) {
        const fragility::Path path{w.displacement, w.force};
        files.push_back({"cycles.csv", cycles_csv(fragility::cycles(path), w.result.curve)});
        files.push_back({"backbones.csv", backbones_csv(path)});
    }
    files.push_back({"capacity.svg", capacity_svg(reading_rules(used), w, beside)});
    files.push_back({"wall.svg", pushed_picture(used.beam, used.load, layout, w)});
    if (!w.piers.empty())
        files.push_back({"piers.svg", pier_picture(used, used.load, layout, w)});
    const PushedWall* const other = other_way_of(w);
    if (other == nullptr || dem::failed(other->result.outcome)) return files;
    const Study turned = turned_round(used);
    const std::string way = way_name(push_way(turned.load).direction);
    files.push_back({"capacity_" + way + ".csv", capacity_text(*other)});
    files.push_back(
        {"wall_" + way + ".svg", pushed_picture(turned.beam, turned.load, layout, *other)});
    if (!other->piers.empty())
        files.push_back(
            {"piers_" + way + ".svg", pier_picture(turned, turned.load, layout, *other)});
    return files;
}

bool any_piers(const std::vector<PushedWall>& walls)
{
    return std::ranges::any_of(walls, [](const PushedWall& w) { return !w.piers.empty(); });
}

std::string pier_text(const ReadingRules& rules, const std::vector<PushedWall>& walls)
{
    if (!any_piers(walls)) return {};
    return "\n" + as_text(without_details(pier_table(rules, walls)), terminal_width());
}

/// "solver error of the peak force: at most 0.5 %, asked for: 1 %; of the ultimate
/// displacement: at most 2 %"; empty where no wall gave a result.
std::string error_line(const dem::SolverOptions& solver, const std::vector<PushedWall>& walls)
{
    double largest = -1.0, of_fall = -1.0;
    bool beyond = false; // a range of the ultimate displacement goes on beyond the push
    for (const PushedWall& w : walls) {
        if (const double error = solver_error(w); error > largest) largest = error;
        const double error = ultimate_error(w.reading);
        if (error > of_fall) of_fall = error;
        beyond = beyond || (error >= 0.0 && ends_in_range(w.reading));
    }
    if (largest < 0.0) return {};
    const std::string at_most = walls.size() > 1 ? "at most " : "";
    return "solver error of the peak force: " + at_most + error_text(largest) +
           ", asked for: " + error_text(solver.accuracy) +
           (of_fall < 0.0 ? ""
                          : "; of the ultimate displacement: " +
                                (beyond ? "at least " : at_most) + error_text(of_fall)) +
           "\n";
}

/// "error of the force by the number of contact points: 0.42 %"; empty where no wall gave a
/// result.
std::string points_line(const std::vector<PushedWall>& walls)
{
    double largest = -1.0;
    for (const PushedWall& w : walls)
        if (const double error = points_error(w.result); error > largest) largest = error;
    if (largest < 0.0) return {};
    return std::string("error of the force by the number of contact points: ") +
           (walls.size() > 1 ? "at most " : "") + error_text(largest) + "\n";
}

/// "0.50_MPa": the folder of a level.
fs::path folder_of(double stress)
{
    std::string name = stress_text(stress);
    std::ranges::replace(name, ' ', '_');
    return name;
}

/// Where the files of a wall are, below command.out.
fs::path wall_folder(std::size_t walls, double stress)
{
    return walls == 1 ? fs::path() : folder_of(stress);
}

std::vector<fs::path> wall_folders(const LoadInput& load, const std::vector<WantedWall>& wanted)
{
    std::vector<fs::path> folders;
    for (const WantedWall& w : wanted)
        folders.push_back(wall_folder(wanted.size(), load.vertical_stress[w.level]));
    return folders;
}

void write_all(const Command& command, const PreparedStudy& ready,
               const std::vector<WantedWall>& wanted, const std::vector<PushedWall>& walls,
               PushedSeries& series, const std::optional<PushFilm>& film,
               const std::vector<TestCurve>& beside)
{
    const Study& study = ready.study;
    std::vector<OutputFile> files, moved;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const fs::path folder = wall_folder(walls.size(), walls[i].vertical_stress);
        const Study used = study.random.empty() ? study : with_drawn(study, wanted[i]);
        for (OutputFile& f : wall_files(used, ready.layout, walls[i], command, beside))
            files.push_back({folder / f.name, std::move(f.content)});
        if (film && !dem::failed(walls[i].result.outcome))
            files.push_back({folder / "film.svg", film->film(ready.layout, i, walls[i])});
        if (study.output.paraview && !dem::failed(walls[i].result.outcome))
            for (const OutputFile& f : series.seal(i, walls[i].result))
                moved.push_back({folder / f.name, {}, f.from});
    }
    const ReadingRules rules = reading_rules(study);
    if (walls.size() > 1) {
        add_table(files, "levels", level_table(study.load, study.fragility, walls));
        files.push_back({"levels.svg", levels_svg(rules, walls, beside)});
    }
    add_table(files, "limit_states", limit_table(rules, walls));
    if (any_piers(walls)) {
        add_table(files, "piers", pier_table(rules, walls));
        add_table(files, "pier_limit_states", pier_limit_table(rules, walls));
        add_table(files, "spandrels", spandrel_table(rules, walls));
    }
    if (!wanted.front().draw.values.empty())
        files.push_back({"drawn.csv", as_csv(drawn_table(study.random, wanted.front().draw))});
    if (std::string drawn = drawn_picture(study.random, ready.layout, wanted.front().draw);
        !drawn.empty())
        files.push_back({"drawn.svg", std::move(drawn)});
    files.insert(files.end(), moved.begin(), moved.end());
    write_results(command.out, files, kPushList);
}

/// Writes the curves so far, and nothing else: results of an earlier push stay as they are.
/// @throws Interrupted
[[noreturn]] void keep_curves(const Command& command, const std::vector<PushedWall>& walls)
{
    std::vector<OutputFile> files;
    std::string where;
    for (const PushedWall& w : walls) {
        if (w.displacement.size() < 2 || dem::failed(w.result.outcome)) continue;
        const fs::path name = wall_folder(walls.size(), w.vertical_stress) / kInterruptedCurve;
        files.push_back({name, capacity_text(w)});
        where += (where.empty() ? "" : ", ") + (fs::path(command.out) / name).string() +
                 " (up to " + fixed(w.displacement.back() * 1e3, 1) + " mm)";
    }
    if (files.empty()) throw Interrupted();
    add_results(command.out, files, kPushList);
    throw Interrupted{std::string("nothing was written but the ") +
                      (files.size() == 1 ? "curve" : "curves") + " so far, " + where};
}

/// Before any wall is pushed: what cannot be written afterwards.
void check_folder(const Command& command, const LoadInput& load, const OutputInput& output,
                  const std::vector<WantedWall>& wanted)
{
    std::vector<fs::path> names = {"levels.svg", "drawn.csv", "drawn.svg"};
    for (const char* const ending : kTableEndings)
        for (const char* const stem :
             {"limit_states", "levels", "piers", "pier_limit_states", "spandrels"})
            names.push_back(std::string(stem) + ending);
    const std::vector<fs::path> folders = wall_folders(load, wanted);
    for (const fs::path& folder : folders)
        for (const char* const name :
             {"study.ini", "summary.json", "capacity.csv", "capacity_left.csv",
              "capacity_right.csv", "cycles.csv", "backbones.csv", "capacity.svg", "wall.svg",
              "wall_left.svg", "wall_right.svg", "piers.svg", "piers_left.svg",
              "piers_right.svg", "film.svg", kInterruptedCurve})
            names.push_back(folder / name);
    if (output.paraview) {
        const std::vector<fs::path> there = series_there(command.out, folders);
        names.insert(names.end(), there.begin(), there.end());
    }
    if (const std::string note = check_results(command.out, names, kPushList); !command.quiet)
        std::cerr << note;
}

/// With the layout of the wall that is pushed.
PreparedStudy pushed_study(PreparedStudy ready, std::optional<int> sample)
{
    const Study& study = ready.study;
    if (!has_layouts(study.geometry)) return ready;
    return in_layout(study, layout_seed(study, static_cast<std::uint32_t>(sample.value_or(0))));
}

/// "wall.gif", of several walls "wall_0.50_MPa.gif".
fs::path video_of(const Command& command, std::size_t walls, double stress)
{
    fs::path name = command.video;
    if (walls > 1)
        name.replace_filename(name.stem().string() + "_" + folder_of(stress).string() +
                              name.extension().string());
    return name;
}

void check_video(const fs::path& file, bool quiet)
{
    if (const std::string note = check_replaced(file, video_mark(file)); !quiet)
        std::cerr << note;
}

/// Films in a file of their own; a line for each.
std::string write_videos(const Command& command, const PreparedStudy& ready,
                         const std::vector<PushedWall>& walls,
                         const std::optional<PushFilm>& film)
{
    std::string said;
    if (command.video.empty() || !film) return said;
    const fs::path folder = fs::path(command.video).parent_path();
    if (!folder.empty()) make_folder(folder);
    for (std::size_t i = 0; i < walls.size(); ++i)
        if (!dem::failed(walls[i].result.outcome))
            said += write_video(video_of(command, walls.size(), walls[i].vertical_stress),
                                film->stills(ready.layout, i, walls[i])) +
                    "\n";
    return said;
}

} // namespace

int push_command(const Command& command)
{
    StudySource source = study_source(command.study, command.overrides);
    const std::vector<WantedWall> wanted =
        wanted_walls(source, {command.sample, command.mean_wall, command.level});
    std::vector<TestCurve> beside;
    for (const std::string& path : command.beside) beside.push_back(read_test_curve(path));
    std::cerr << study_notes(source.ready, command.verb);
    if (!source.other_revision.empty())
        std::cerr << wrapped("note: " + source.other_revision + "\n", terminal_width());
    const PreparedStudy ready = pushed_study(std::move(source.ready), command.sample);
    const Study& study = ready.study;
    check_folder(command, study.load, study.output, wanted);
    for (const double stress : study.load.vertical_stress)
        if (!command.video.empty())
            check_video(video_of(command, wanted.size(), stress), command.quiet);
    catch_interrupts();
    PushedSeries series(command.out, wall_folders(study.load, wanted));
    dem::PushPlan plan = push_plan(study);
    plan.sink = series.sink();
    std::optional<PushFilm> film;
    if (command.film) film.emplace(study.load, wanted.size(), plan);
    const auto [walls, whole, other_way_left_out] =
        push_until_told(ready, std::move(plan), wanted, command.threads, command.quiet);
    if (!whole) keep_curves(command, walls);
    write_all(command, ready, wanted, walls, series, film, beside);
    if (other_way_left_out)
        throw Interrupted{"all results of the push are in " + command.out +
                          "; only the push the other way was left out"};
    const ReadingRules rules = reading_rules(study);
    std::cout << as_text(without_details(level_table(study.load, study.fragility, walls)),
                         terminal_width())
              << '\n'
              << as_text(limit_table(rules, walls), terminal_width()) << pier_text(rules, walls)
              << error_line(study.solver, walls) << points_line(walls);
    for (const PushedWall& w : walls)
        for (const std::string& remark : hand_checks(study, ready.layout, w).remarks)
            std::cout << wrapped("remark: " + stress_text(w.vertical_stress) + ": " + remark +
                                     ".\n",
                                 terminal_width());
    std::cout << "written to " << command.out << '\n'
              << wrapped(write_videos(command, ready, walls, film), terminal_width());
    if (walls.front().reading.peak)
        std::cout << sheet_offer(fs::path(command.out) /
                                     wall_folder(walls.size(), walls.front().vertical_stress) /
                                     "study.ini",
                                 study_title(command.study), {})
                  << '\n';
    for (const PushedWall& w : walls)
        if (dem::failed(w.result.outcome))
            std::cerr << "drystone: " << stress_text(w.vertical_stress)
                      << ": the wall failed: " << w.reading.no_reading << '\n';
    return std::ranges::any_of(
        walls, [](const PushedWall& w) { return dem::failed(w.result.outcome); });
}

} // namespace app
