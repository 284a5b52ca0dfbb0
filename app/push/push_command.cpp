#include "app/push/push_command.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/random_layouts.hpp"
#include "app/input/study.hpp"
#include "app/input/units.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/backbones_csv.hpp"
#include "app/output/cells.hpp"
#include "app/output/cycles_csv.hpp"
#include "app/output/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/vtk_series.hpp"
#include "app/output/wall_svg.hpp"
#include "app/push/capacity_svg.hpp"
#include "app/push/capacity_text.hpp"
#include "app/push/hand_checks.hpp"
#include "app/push/summary_json.hpp"
#include "app/reading/wall_words.hpp"
#include "app/study/mode_rule.hpp"
#include "app/study/push_walls.hpp"
#include "app/study/study_walls.hpp"
#include "app/study/wanted_walls.hpp"
#include "app/text/number_text.hpp"
#include "dem/block/model.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace app {

namespace {

namespace fs = std::filesystem;

/// Pushes all walls. One line shows how far they are together: those that are done, and the one
/// that spoke last.
std::vector<PushedWall> push_all(const Study& study, const std::vector<WantedWall>& wanted,
                                 int threads, bool quiet)
{
    std::vector<PushedWall> walls(wanted.size());
    Progress line(std::cerr, stderr_progress(quiet), steady_seconds);
    std::mutex mutex;
    double finished = 0.0;
    dem::PushPlan plan = push_plan(study);
    plan.progress = [&](double done, double displacement, double force) {
        const std::lock_guard lock(mutex);
        line.update(std::min(1.0, (finished + done) / static_cast<double>(wanted.size())),
                    fixed(force * 1e-3, 1) + " kN at " + fixed(displacement * 1e3, 1) + " mm");
    };
    PushList list;
    list.size = wanted.size();
    list.wall = [&](std::size_t i) { return wanted[i]; };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        const std::lock_guard lock(mutex);
        walls[i] = std::move(wall);
        finished += 1.0;
    };
    push_walls(study, model_of(study), plan, list, threads);
    line.finish("");
    return walls;
}

/// The values that were drawn for one wall, in the units of their keys.
Table drawn_table(const Study& study, const WallDraw& draw)
{
    Table t;
    t.head = {"input", "unit", "value"};
    for (std::size_t i = 0; i < draw.values.size(); ++i) {
        const RandomInput& input = study.random[i];
        const std::vector<double>& values = draw.values[i];
        const std::string unit = input.unit.empty() ? "-" : std::string(input.unit);
        for (std::size_t id = 0; id < values.size(); ++id)
            t.rows.push_back(
                {values.size() == 1 ? input.key : input.key + "." + std::to_string(id + 1),
                 unit, Number{from_si(values[id], input.unit)}});
    }
    return t;
}

/// The study as it was used. Of a study with samples it says which wall was pushed.
std::string configuration(const Study& study, const PushedWall& w, std::optional<int> sample)
{
    if (!sample && !is_random(study)) return effective_configuration(study);
    if (!sample)
        return "# The wall in which each value is the mean of its distribution, under " +
               stress_text(w.vertical_stress) + ".\n" + effective_configuration(study);
    return "# Wall " + std::to_string(*sample) + " of this study, under " +
           stress_text(w.vertical_stress) + "; the values drawn for it are in drawn.csv.\n" +
           effective_configuration(study);
}

/// Of a push that turns back.
void write_cycles(const fs::path& folder, const PushedWall& w)
{
    const fragility::Path path{w.displacement, w.force};
    std::vector<dem::Energy> ledger;
    for (const dem::CurvePoint& p : w.result.curve) ledger.push_back(p.energy);
    write_file(folder / "cycles.csv", cycles_csv(fragility::cycles(path), ledger));
    write_file(folder / "backbones.csv", backbones_csv(path));
}

void write_wall(const fs::path& folder, const Study& study, const PushedWall& w,
                std::optional<int> sample)
{
    make_folder(folder);
    write_file(folder / "study.ini", configuration(study, w, sample));
    if (!dem::failed(w.result.outcome)) {
        write_file(folder / "capacity.csv", capacity_text(w));
        if (push_way(study).direction == 0) write_cycles(folder, w);
        write_file(folder / "capacity.svg", capacity_svg(study, w));
        WallPictureText text;
        if (study.beam.present) text.vertical_load = stress_text(w.vertical_stress);
        text.load_height = w.loads.height;
        const dem::PushResult& r = w.result;
        // A wall that comes down under its vertical load has no peak.
        const dem::Snapshot& peak = r.at_peak.blocks.empty() ? r.at_end : r.at_peak;
        write_file(folder / "wall.svg", wall_picture(peak, r.at_end, text));
        if (study.output.paraview)
            write_vtk_series(folder / "series",
                             r.snapshots.empty() ? std::vector{peak, r.at_end} : r.snapshots);
    }
    if (dem::failed(w.result.outcome) || !study.output.paraview)
        remove_vtk_series(folder / "series"); // of an earlier run
    write_file(folder / "summary.json",
               summary_json(study, w)); // last: its presence says the rest is whole
}

Row level_row(const PushedWall& w)
{
    const WallReading& r = w.reading;
    const auto ultimate = [&](double scale) {
        if (!is_defined(r.ultimate)) return Number{};
        return Number{.value = r.ultimate.displacement * scale,
                      .decimals = 2,
                      .sense = is_censored(r.ultimate) ? Sense::above : Sense::equal};
    };
    return {given(w.vertical_stress / 1e6),
            plain_number(peak_force(r) * 1e-3, 2),
            plain_number(peak_displacement(r) * 1e3, 2),
            r.stiffness ? plain_number(*r.stiffness * 1e-6, 1) : Number{},
            ultimate(1e3),
            ultimate(100.0 / w.loads.height),
            std::string(dem::failed(w.result.outcome) ? "failed" : words(r.mode)),
            count(w.mechanism.cracked_units),
            plain_number(100.0 * energy_residual(w), 4)};
}

Table level_table(const Study& study, const std::vector<PushedWall>& walls)
{
    Table t;
    t.caption = "Capacity per vertical stress. Ultimate: the " +
                ultimate_text(study.fragility) + "; > where it had not when the push ended." +
                backbone_text(study);
    t.head = {"stress [MPa]",
              "peak [kN]",
              "at [mm]",
              "stiffness [kN/mm]",
              {"ultimate [mm]", kCensored},
              {"drift [%]", kCensored},
              "mode",
              "cracked units",
              "energy residual [%]"};
    for (const PushedWall& w : walls) t.rows.push_back(level_row(w));
    return t;
}

/// "0.50_MPa": the folder of a level.
fs::path folder_of(const PushedWall& w)
{
    std::string name = stress_text(w.vertical_stress);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

void write_all(const fs::path& out, const Study& study, const std::vector<PushedWall>& walls,
               std::optional<int> sample)
{
    if (walls.size() == 1) return write_wall(out, study, walls.front(), sample);
    for (const PushedWall& w : walls) write_wall(out / folder_of(w), study, w, sample);
    const Table table = level_table(study, walls);
    write_file(out / "levels.csv", as_csv(table));
    write_file(out / "levels.md", as_markdown(table));
    write_file(out / "levels.tex", as_latex(table));
}

/// With the layout of the wall that is pushed.
Study pushed_study(const Study& study, std::optional<int> sample)
{
    if (!has_layouts(study)) return study;
    return in_layout(study, layout_seed(study, static_cast<std::uint32_t>(sample.value_or(0))));
}

} // namespace

int push_command(const Command& command)
{
    const StudySource source = study_source(command);
    const std::vector<WantedWall> wanted = wanted_walls(source, command);
    say_effects(source.study, command);
    const Study study = pushed_study(source.study, command.sample);
    const std::vector<PushedWall> walls =
        push_all(study, wanted, command.threads, command.quiet);
    write_all(command.out, study, walls, command.sample);
    if (command.sample)
        write_file(fs::path(command.out) / "drawn.csv",
                   as_csv(drawn_table(study, wanted.front().draw)));
    std::cout << as_text(level_table(study, walls), terminal_width());
    for (const PushedWall& w : walls)
        for (const std::string& remark : hand_checks(study, w).remarks)
            std::cout << wrapped("remark: " + stress_text(w.vertical_stress) + ": " + remark +
                                     ".\n",
                                 terminal_width());
    std::cout << "written to " << command.out << '\n';
    return std::any_of(walls.begin(), walls.end(),
                       [](const PushedWall& w) { return dem::failed(w.result.outcome); });
}

} // namespace app
