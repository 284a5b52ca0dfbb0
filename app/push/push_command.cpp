#include "app/push/push_command.hpp"

#include "app/input/number_text.hpp"
#include "app/input/study.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/capacity_csv.hpp"
#include "app/output/cells.hpp"
#include "app/output/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/vtk_series.hpp"
#include "app/output/wall_svg.hpp"
#include "app/push/capacity_svg.hpp"
#include "app/push/summary_json.hpp"
#include "app/study/pushed_wall.hpp"
#include "app/study/wanted_walls.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

namespace app {

namespace {

namespace fs = std::filesystem;

/// [MPa] "0.50"; more digits where two are not exact.
std::string stress_number(const PushedWall& w)
{
    const double mpa = w.vertical_stress * 1e-6;
    const std::string two = fixed(mpa, 2);
    return number(mpa, 12) == number(std::stod(two), 12) ? two : number(mpa, 12);
}

std::string stress_text(const PushedWall& w) { return stress_number(w) + " MPa"; }

/// Progress of several walls as one line.
class SharedProgress {
  public:
    SharedProgress(std::size_t walls, bool quiet)
        : line_(std::cerr, stderr_progress(quiet), steady_seconds), done_(walls, 0.0)
    {
    }
    void update(std::size_t wall, double done, double displacement, double force)
    {
        const std::lock_guard lock(mutex_);
        done_[wall] = done;
        double sum = 0.0;
        for (const double d : done_) sum += d;
        line_.update(sum / static_cast<double>(done_.size()),
                     fixed(force * 1e-3, 1) + " kN at " + fixed(displacement * 1e3, 1) + " mm");
    }
    void finish() { line_.finish(""); }

  private:
    std::mutex mutex_;
    Progress line_;
    std::vector<double> done_;
};

/// Every wall on its own; which thread runs it changes nothing in it.
std::vector<PushedWall> push_all(const Study& study, const std::vector<WantedWall>& wanted,
                                 int threads, bool quiet)
{
    const std::size_t n = wanted.size();
    std::vector<PushedWall> walls(n);
    std::vector<std::exception_ptr> errors(n);
    std::atomic<std::size_t> next{0};
    SharedProgress progress(n, quiet);
    const auto work = [&] {
        for (std::size_t i = next++; i < n; i = next++) try {
                walls[i] = push_wall(study, wanted[i].level, wanted[i].draw,
                                     [&progress, i](double d, double u, double f) {
                                         progress.update(i, d, u, f);
                                     });
            } catch (...) {
                errors[i] = std::current_exception();
            }
    };
    std::vector<std::jthread> team;
    for (std::size_t t = 1; t < std::min<std::size_t>(threads, n); ++t) team.emplace_back(work);
    work();
    team.clear();
    progress.finish();
    for (const std::exception_ptr& e : errors)
        if (e) std::rethrow_exception(e);
    return walls;
}

void write_wall(const fs::path& folder, const Study& study, const PushedWall& w)
{
    make_folder(folder);
    write_file(folder / "study.ini", effective_configuration(study));
    if (!dem::failed(w.result.outcome)) {
        write_file(folder / "capacity.csv",
                   capacity_csv(w.displacement, w.force, w.loads.height));
        write_file(folder / "capacity.svg", capacity_svg(w));
        WallPictureText text;
        text.vertical_load = stress_text(w);
        text.load_height = w.loads.height;
        write_file(folder / "wall.svg", wall_picture(w.result.at_peak, w.result.at_end, text));
        write_vtk_series(folder / "series", w.result.snapshots);
    }
    write_file(folder / "summary.json",
               summary_json(study, w)); // last: its presence says the rest is whole
}

Row level_row(const PushedWall& w)
{
    const bool failed = dem::failed(w.result.outcome);
    const auto ultimate = [&](double scale) {
        if (w.ultimate.reading == fragility::Reading::not_defined) return Number{};
        const bool censored = w.ultimate.reading == fragility::Reading::censored;
        return Number{.value = w.ultimate.displacement * scale,
                      .decimals = 2,
                      .sense = censored ? Sense::above : Sense::equal};
    };
    return {given(w.vertical_stress * 1e-6),
            w.peak ? plain_number(w.peak->force * 1e-3, 2) : Number{},
            w.peak ? plain_number(w.peak->displacement * 1e3, 2) : Number{},
            w.stiffness ? plain_number(*w.stiffness * 1e-6, 1) : Number{},
            ultimate(1e3),
            ultimate(100.0 / w.loads.height),
            failed ? "failed" : name(w.mode),
            count(w.mechanism.cracked_units),
            plain_number(100.0 * w.result.energy.residual(), 4)};
}

Table level_table(const std::vector<PushedWall>& walls)
{
    Table t;
    t.caption =
        "Capacity per vertical stress. Ultimate: the force first comes down to 80 % of the "
        "peak; > where it had not when the push ended.";
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
    std::string name = stress_text(w);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

void write_all(const fs::path& out, const Study& study, const std::vector<PushedWall>& walls)
{
    if (walls.size() == 1) return write_wall(out, study, walls.front());
    for (const PushedWall& w : walls) write_wall(out / folder_of(w), study, w);
    const Table table = level_table(walls);
    write_file(out / "levels.csv", as_csv(table));
    write_file(out / "levels.md", as_markdown(table));
    write_file(out / "levels.tex", as_latex(table));
}

} // namespace

int push_command(const Command& command)
{
    const StudySource source = study_source(command);
    const Study& study = source.study;
    const std::vector<PushedWall> walls =
        push_all(study, wanted_walls(source, command), command.threads, command.quiet);
    write_all(command.out, study, walls);
    std::cout << as_text(level_table(walls), terminal_width()) << "written to " << command.out
              << '\n';
    return std::any_of(walls.begin(), walls.end(),
                       [](const PushedWall& w) { return dem::failed(w.result.outcome); });
}

} // namespace app
