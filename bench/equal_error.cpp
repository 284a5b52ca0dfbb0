#include "bench/equal_error.hpp"

#include "app/output/table.hpp"
#include "app/text/number_text.hpp"
#include "bench/nodal_scheme.hpp"
#include "scenes/paper_wall.hpp"

#include "dem/contact/pack.hpp"
#include "dem/solver/ensemble.hpp"

#include <cmath>
#include <iostream>

namespace bench {

namespace {

constexpr double kWay = 0.012; // [m]: past the peaks of the walls at hand
constexpr double kError = 0.01;

struct Level {
    double stress;      // [MPa]
    double first, last; // speeds of the paper's scheme that are tried [steps/mm]
};
constexpr Level kLevels[] = {{0.50, 320000, 640000}, {1.25, 20000, 160000}};

struct Attempt {
    double steps_per_mm = 0.0, peak = 0.0, seconds = 0.0;
};

/// A register full of the same wall: what a wall costs in an ensemble.
Attempt run_ours(const scenes::Scene& s, dem::Fidelity fidelity, const dem::SolverOptions& o)
{
    const dem::Model model = scenes::model_of(s, dem::discretisation_of(fidelity));
    dem::PushPlan plan;
    plan.targets = {kWay};
    plan.energy_at_points = plan.snapshot_at_peak = false;
    Attempt a{o.steps_per_mm};
    const auto lanes = static_cast<std::size_t>(dem::lanes<dem::Pack>);
    dem::push_ensemble(model,
                       {lanes, [&](std::size_t) { return scenes::uniform(s, model); },
                        [&](std::size_t, dem::PushResult&& r) {
                            a.peak = scenes::peak_force(r);
                            a.seconds += r.cost.seconds / static_cast<double>(lanes);
                        }},
                       plan, o, {.threads = 1});
    return a;
}

Attempt run_nodal(const scenes::Scene& s, double steps_per_mm)
{
    const dem::Model model = scenes::model_of(s, dem::discretisation_of(dem::Fidelity::zones));
    NodalOptions o;
    o.steps_per_mm = steps_per_mm;
    o.max_displacement = kWay;
    const NodalPush push = push_nodes(model, scenes::uniform(s, model), o);
    return {steps_per_mm, peak_force(push), push.cost.seconds};
}

/// Doubles the steps until the error is within 1 %, or up to `last`.
template <class Run>
Attempt search(double first, double last, double truth, Run run, bool& found)
{
    Attempt a;
    for (double steps = first; steps <= last; steps *= 2.0) {
        a = run(steps);
        std::cerr << steps << " steps per mm: " << 100.0 * (a.peak / truth - 1.0) << " %, "
                  << a.seconds << " s\n";
        found = std::abs(a.peak / truth - 1.0) <= kError;
        if (found) break;
    }
    return a;
}

} // namespace

std::string equal_error_text()
{
    app::Table t;
    t.head = {"stress [MPa]", "slow limit [kN]", "scheme", "steps per mm",
              "peak [kN]",    "error [%]",       "core s", "times dearer"};
    for (const Level& level : kLevels) {
        const scenes::Scene s = scenes::paper_wall(level.stress);
        dem::SolverOptions slow;
        slow.steps_per_mm = 6000;
        const double truth = run_ours(s, dem::Fidelity::fine, slow).peak;
        bool found = false, nodal_found = false;
        const auto standard = [&](double steps) {
            dem::SolverOptions o;
            o.steps_per_mm = steps;
            return run_ours(s, dem::Fidelity::standard, o);
        };
        // Within 1 % at half the speed as well: not by chance.
        Attempt ours, slower;
        for (double steps = 25; !found && steps <= 2000; steps = 2.0 * ours.steps_per_mm) {
            ours = search(steps, 2000, truth, standard, found);
            slower = standard(2.0 * ours.steps_per_mm);
            found = found && std::abs(slower.peak / truth - 1.0) <= kError;
        }
        const Attempt nodal = search(
            level.first, level.last, truth, [&](double steps) { return run_nodal(s, steps); },
            nodal_found);
        const auto add = [&](const char* name, const Attempt& a, bool reached, double ratio) {
            t.rows.push_back({app::fixed(level.stress, 2), app::fixed(truth * 1e-3, 2), name,
                              app::number(a.steps_per_mm, 6), app::fixed(a.peak * 1e-3, 2),
                              (reached ? "" : "not reached: ") +
                                  app::fixed(100.0 * (a.peak / truth - 1.0), 2),
                              app::number(a.seconds, 3), app::number(ratio, 3)});
        };
        add("standard", ours, found, 1.0);
        add("paper's scheme", nodal, nodal_found, nodal.seconds / ours.seconds);
    }
    return "\n## At equal error\n\nMean-value walls pushed by 12 mm, each scheme at half the "
           "speed "
           "until its peak is within 1 % of the slow limit (fine zones, 6000 steps per mm). "
           "Standard: a "
           "register full of walls, per wall; within 1 % at half that speed as well. The "
           "paper's scheme "
           "starts where earlier runs were still off by more than 1 %.\n\n" +
           app::as_markdown(t);
}

} // namespace bench
