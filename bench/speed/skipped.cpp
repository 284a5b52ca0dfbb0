/// skipped OUT.md: what a scene does not need, what leaving it out saves, and what that does to
/// the answer.

#include "app/output/atomic_output.hpp"
#include "app/output/table/table.hpp"
#include "app/text/number_text.hpp"
#include "bench/machine.hpp"
#include "bench/speed/law_cost.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/ensemble.hpp"
#include "scenes/paper_wall.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace {

struct Scene {
    scenes::Scene wall;
    dem::Discretisation discretisation;
    dem::SolverOptions options;
    dem::PushPlan plan;
};

/// The default run with one thing not skipped.
struct Trial {
    std::string name, how;
    std::function<void(Scene&)> change;
};

struct Run {
    double seconds = 0.0;
    std::vector<std::vector<double>> force; ///< by wall, by curve point
};

const std::vector<double> kStress = {0.75, 1.25}; // [MPa]
constexpr int kWalls = 16;                        // per level

Run run(const Trial& trial)
{
    std::vector<Scene> levels;
    for (const double stress : kStress) {
        levels.emplace_back();
        levels.back().wall = scenes::paper_wall(stress);
        levels.back().plan.snapshot_at_peak = false;
        trial.change(levels.back());
    }
    const Scene& first = levels.front();
    Run r;
    r.force.resize(kWalls * levels.size());
    const auto start = std::chrono::steady_clock::now();
    const dem::Model model = scenes::model_of(first.wall, first.discretisation);
    const auto wall = [&](std::size_t i) {
        return scenes::table5_sample(levels[i / kWalls].wall, model, i % kWalls);
    };
    const auto done = [&](std::size_t i, dem::PushResult&& p) {
        for (const dem::CurvePoint& point : p.curve) r.force[i].push_back(point.force);
    };
    dem::push_ensemble(model, {r.force.size(), wall, done}, first.plan, first.options);
    r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return r;
}

double largest(const std::vector<double>& values, std::size_t n)
{
    return *std::max_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
}

/// Same bits, or the median change of the peak force.
std::string effect(const Run& lean, const Run& full)
{
    bool same = true;
    std::vector<double> change;
    for (std::size_t i = 0; i < lean.force.size(); ++i) {
        const std::size_t n = std::min(lean.force[i].size(), full.force[i].size());
        same = same && std::equal(lean.force[i].begin(),
                                  lean.force[i].begin() + static_cast<std::ptrdiff_t>(n),
                                  full.force[i].begin());
        change.push_back(std::abs(largest(lean.force[i], lean.force[i].size()) /
                                      largest(full.force[i], full.force[i].size()) -
                                  1.0));
    }
    std::sort(change.begin(), change.end());
    const std::string peaks =
        "peak " + app::number(100.0 * change[change.size() / 2], 2) + " %";
    if (!same) return peaks;
    const bool cut = lean.force.front().size() != full.force.front().size();
    return cut ? "same bits as far as it goes; " + peaks : "same bits";
}

std::vector<Trial> trials()
{
    return {
        {"damage law of cracks that neither open nor slip",
         "`SolverOptions::shortcuts = false`", [](Scene& s) { s.options.shortcuts = false; }},
        {"picture of the wall at each new peak", "`PushPlan::snapshot_at_peak = true`",
         [](Scene& s) { s.plan.snapshot_at_peak = true; }},
        {"waiting for the vertical load", "`solver.preload = ramped`",
         [](Scene& s) { s.options.preload = dem::Preload::ramped; }},
        {"dry law under a tied beam", "`beam.interface = joint`",
         [](Scene& s) { s.wall.beam.interface = dem::BeamInterface::joint; }},
        {"contacts under a fixed base", "`wall.base = joint`",
         [](Scene& s) { s.wall.wall.base = dem::Base::joint; }},
        {"modes of the beam beyond 15", "`solver.beam_modes = all`",
         [](Scene& s) { s.discretisation.beam_modes = 0; }},
        {"modes of the blocks beyond 12", "`solver.fidelity = zones`",
         [](Scene& s) { s.discretisation.block_modes = 0; }},
    };
}

/// The other way round: what an early stop leaves out.
Trial early_stop(double share)
{
    return {"", "", [share](Scene& s) {
                s.plan.decided = [share](std::span<const dem::CurvePoint> curve) {
                    double peak = 0.0;
                    for (const dem::CurvePoint& p : curve) peak = std::max(peak, p.force);
                    return curve.back().force < share * peak && curve.size() > 1;
                };
            }};
}

/// Fastest of three, so that another process does not count.
Run best_of_three(const Trial& trial)
{
    Run best = run(trial);
    for (int i = 0; i < 2; ++i) {
        Run again = run(trial);
        if (again.seconds < best.seconds) best = std::move(again);
    }
    return best;
}

app::Table measure()
{
    app::Table t;
    t.head = {"not computed", "switch that computes it", "s without", "s with",
              "saved [%]",    "effect on the curves"};
    const auto row = [&t](const std::string& name, const std::string& how, const Run& lean,
                          const Run& full) {
        t.rows.push_back({name, how, app::fixed(lean.seconds, 2), app::fixed(full.seconds, 2),
                          app::fixed(100.0 * (1.0 - lean.seconds / full.seconds), 0),
                          effect(lean, full)});
    };
    const Run lean = best_of_three({"", "", [](Scene&) {}});
    for (const Trial& trial : trials()) {
        std::cerr << trial.name << '\n';
        row(trial.name, trial.how, lean, best_of_three(trial));
    }
    for (const double share : {0.8, 0.2})
        row("push on below " + app::fixed(share, 1) +
                " of the peak, once nothing is left to read",
            "`load.stop_below = 0` (default)", best_of_three(early_stop(share)), lean);
    return t;
}

constexpr const char* kText = R"(# What is not computed

32 walls of Table 5 at 0.75 and 1.25 MPa, 30 mm, default settings, all
cores; fastest of three runs. The test that the answer stays is named where the bits must stay.

What a scene cannot need is not in its arrays at all: joints without strength have no damage (below), a fixed base has no
contacts, a tied beam no friction law, units without cracks (`wall.unit_cracks = no`) no inner faces. One model (modes, tables)
serves all stress levels and samples of a study. A lane whose wall is done gets the next wall in the same step.

| skipped | test that the answer stays |
|---|---|
| damage law of elastic cracks | `elastic trial: holds where the law changes nothing else, and gives its bits` |
| energy nobody asked for | `wall run: energies nobody asked for are zero, and the forces the same` |
| pictures nobody asked for | `wall run: snapshots nobody asked for are empty, and all else the same` |
| the end of a decided push | `wall run: ends where nothing more is to be learnt, the curve so far unchanged` |
| waiting for the vertical load | `static start: settlement and peak are those of the load brought on by a ramp` |
| waiting for the slowest lane | `ensemble: a wall has the same bits alone and in any register, thread and size` |
| damage of dry joints | `contact law: a crack without strength is a dry joint` |

Solving the vertical load costs as much as a ramp of some 750 steps would (1.5 ms a wall, in which the other lanes wait): it does not
save time on this wall. It saves the choice of the ramp, which grows with the wall.
)";

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "usage: skipped OUT.md\n";
        return 2;
    }
    const std::string text = kText + ("\nWritten by `" + bench::command_line()) + "` on " +
                             bench::machine_line() + ".\n\n" + app::as_markdown(measure()) +
                             bench::law_cost_text();
    app::write_file(argv[1], text);
    return 0;
}
