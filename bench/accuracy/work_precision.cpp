/// work_precision FOLDER [WALLS]: cost against error of every setting, as work_precision.csv,
/// .md and two pictures; the paper's own scheme in the same table.

#include "bench/accuracy/work_precision.hpp"

#include "app/output/atomic_output.hpp"
#include "app/output/table/table.hpp"
#include "app/text/number_text.hpp"
#include "bench/machine.hpp"
#include "bench/nodal/nodal_answer.hpp"
#include "bench/sweep.hpp"
#include "dem/contact/pack.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

using bench::Answer;
using bench::Case;
using bench::Point;

constexpr double kStress[] = {0.50, 1.25}; // [MPa]
constexpr int kNodalWalls = 2;             // per level: a quarter of a minute each
constexpr dem::SolverOptions kSlow = [] {
    dem::SolverOptions o;
    o.accuracy = 0.001;
    return o;
}();

std::vector<Case> cases(const dem::Discretisation& d, const dem::SolverOptions& solver,
                        int walls)
{
    std::vector<Case> all;
    for (const double stress : kStress)
        for (int i = 0; i < walls; ++i) {
            Case c;
            c.scene = scenes::paper_wall(stress);
            c.discretisation = d;
            c.solver = solver;
            c.sample = i;
            all.push_back(c);
        }
    return all;
}

double quantile(std::vector<double> values, double p)
{
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(
        std::lround(p * static_cast<double>(values.size() - 1)))];
}

/// @param reference of the same walls
Point compare(const bench::Setting& s, const std::vector<Answer>& answers,
              const std::vector<Answer>& reference)
{
    Point p;
    p.setting = s;
    p.walls = static_cast<int>(answers.size());
    std::vector<double> error;
    double peak = 0.0, true_peak = 0.0, ultimate = 0.0, true_ultimate = 0.0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Answer &a = answers[i], &b = reference[i];
        p.seconds += a.seconds / p.walls;
        p.failed += a.failed;
        if (a.failed) continue;
        error.push_back(std::abs(a.peak / b.peak - 1.0));
        peak += a.peak;
        true_peak += b.peak;
        ultimate += a.ultimate;
        true_ultimate += b.ultimate;
        const bool close = a.censored == b.censored &&
                           (a.censored || std::abs(a.ultimate - b.ultimate) <= 0.3e-3);
        p.close += close ? 1.0 / p.walls : 0.0;
        p.same_mode += a.mixed == b.mixed ? 1.0 / p.walls : 0.0;
    }
    if (error.empty()) return p;
    p.peak_median = quantile(error, 0.5);
    p.peak_95 = quantile(error, 0.95);
    p.peak_mean = peak / true_peak - 1.0;
    p.ultimate = std::abs(ultimate / true_ultimate - 1.0);
    return p;
}

/// The reference of the first walls of each level.
std::vector<Answer> first_walls(const std::vector<Answer>& all, int walls, int wanted)
{
    std::vector<Answer> some;
    for (std::size_t level = 0; level < std::size(kStress); ++level)
        some.insert(some.end(), all.begin() + static_cast<std::ptrdiff_t>(level * walls),
                    all.begin() + static_cast<std::ptrdiff_t>(level * walls + wanted));
    return some;
}

std::string drive_text(const bench::Setting& s)
{
    const bool nodal = s.nodal_steps_per_mm > 0.0;
    return nodal || s.solver.unbalance_limit == 0.0
               ? app::number(nodal ? s.nodal_steps_per_mm : s.solver.steps_per_mm, 6) +
                     " steps per mm"
               : "accuracy " + app::number(100.0 * s.solver.accuracy, 3) + " %";
}

Point run(const bench::Setting& s, int walls, const std::vector<Answer>& reference)
{
    std::cerr << s.family << ", " << drive_text(s) << ": ";
    if (s.nodal_steps_per_mm > 0.0)
        return compare(s,
                       bench::run_nodal(cases(s.discretisation, s.solver, kNodalWalls),
                                        s.nodal_steps_per_mm),
                       first_walls(reference, walls, kNodalWalls));
    return compare(s, bench::run_all(cases(s.discretisation, s.solver, walls), s.workers),
                   reference);
}

std::string modes_text(const dem::Discretisation& d)
{
    return d.block_modes == 0 ? "all" : std::to_string(d.block_modes);
}

app::Table table_of(const std::vector<Point>& points)
{
    app::Table t;
    t.head = {"family",          "modes",
              "points",          "rule",
              "drive",           "unbalance [% of it]",
              "damping",         "lanes",
              "walls",           "core s per wall",
              "peak median [%]", "peak 95 % [%]",
              "mean peak [%]",   "mean ultimate [%]",
              "d80 close [%]",   "same mode [%]",
              "failed"};
    for (const Point& p : points) {
        const bench::Setting& s = p.setting;
        const bool nodal = s.nodal_steps_per_mm > 0.0;
        const int lanes = nodal || s.workers.scalar ? 1 : dem::lanes<dem::Pack>;
        const bool local = nodal || s.solver.damping == dem::Damping::local;
        t.rows.push_back(
            {s.family + (s.is_default ? " (default)" : ""), modes_text(s.discretisation),
             std::to_string(s.discretisation.contact_points),
             s.discretisation.face_rule == dem::FaceRule::even ? "even" : "Lobatto",
             drive_text(s),
             nodal || s.solver.unbalance_limit == 0.0
                 ? "constant"
                 : app::number(100.0 * s.solver.unbalance_limit, 3),
             (local ? "local " : "combined ") + app::number(s.solver.damping_factor, 2),
             std::to_string(lanes), std::to_string(p.walls), app::number(p.seconds, 3),
             app::fixed(100.0 * p.peak_median, 2), app::fixed(100.0 * p.peak_95, 2),
             app::fixed(100.0 * p.peak_mean, 2), app::fixed(100.0 * p.ultimate, 1),
             app::fixed(100.0 * p.close, 0), app::fixed(100.0 * p.same_mode, 0),
             std::to_string(p.failed)});
    }
    return t;
}

std::string front_text(const std::vector<Point>& points)
{
    std::string text = "\nOn the front of the peak force, from cheap to exact: ";
    std::string separator;
    for (const Point* p : bench::front(points, &Point::peak_median)) {
        text += separator + p->setting.family + " at " + drive_text(p->setting) + " (" +
                app::number(p->seconds, 2) + " s, " + app::fixed(100.0 * p->peak_median, 2) +
                " %)";
        separator = "; ";
    }
    return text + ".\n";
}

constexpr const char* kText = R"(# Work and precision

Random walls of Table 5 at 0.50 and 1.25 MPa, pushed by 30 mm,
against the same walls with fine zones (6 Gauss-Lobatto points, all modes) and a slow drive (accuracy 0.1 %). Cost: processor
seconds of the solver per wall, all cores busy. Ultimate: mean over all walls of the displacement at the 80 % drop, walls without a drop at
30 mm. d80 close: both walls drop within 0.3 mm, or neither does. "paper's scheme": one wall at a time, all zones, nodal masses,
local damping, constant speed, plain doubles (bench/nodal/nodal_scheme.hpp).

![peak force](work_precision_peak.svg)

![ultimate displacement](work_precision_ultimate.svg)
)";

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2 && argc != 3) {
        std::cerr << "usage: work_precision FOLDER [WALLS per level]\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const int walls = argc == 3 ? std::stoi(argv[2]) : 16;
    std::cerr << "reference: ";
    const std::vector<Answer> reference =
        bench::run_all(cases(dem::discretisation_of(dem::Fidelity::fine), kSlow, walls));
    std::vector<Point> points;
    for (const bench::Setting& s : bench::settings())
        points.push_back(run(s, walls, reference));

    const app::Table table = table_of(points);
    const bench::Panels panels = bench::draw(points);
    std::filesystem::create_directories(folder);
    app::write_file(folder / "work_precision.csv", app::as_csv(table));
    app::write_file(folder / "work_precision_peak.svg", panels.peak);
    app::write_file(folder / "work_precision_ultimate.svg", panels.ultimate);
    app::write_file(folder / "work_precision.md",
                    kText + ("\nWritten by `" + bench::command_line()) + "` on " +
                        bench::machine_line() + ".\n" + front_text(points) + "\n" +
                        app::as_markdown(table));
    return 0;
}
