/// Active learning against limit states of known probability and against walls; bench/active.sh
/// runs it and writes docs/bench/uq/active.md and active_walls.md.

#include "bench/active/problems.hpp"
#include "bench/active/walls.hpp"
#include "bench/report.hpp"

#include "uq/reliability/active/active_learning.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

using namespace active_bench;

constexpr double kTarget = 0.1;
constexpr std::size_t kBudget = 1000;

/// Sums over the repetitions of a problem; errors over the exact probability.
struct Tally {
    int runs = 0, held = 0, below = 0, above = 0, reached = 0;
    double calls = 0.0, most_calls = 0.0, error = 0.0, squares = 0.0, told = 0.0;
};

void note(Tally& t, const uq::ActiveResult& r, double exact)
{
    const uq::Estimate& e = r.exceedance.estimate;
    const auto calls = static_cast<double>(r.exceedance.ledger.evaluations);
    const double error = e.value / exact - 1.0;
    ++t.runs;
    t.held += e.interval.lower <= exact && exact <= e.interval.upper;
    t.below += exact < e.interval.lower;
    t.above += exact > e.interval.upper;
    t.reached += r.exceedance.outcome == uq::SamplingOutcome::target_reached;
    t.calls += calls;
    t.most_calls = std::max(t.most_calls, calls);
    t.error += error;
    t.squares += error * error;
    t.told += e.std_error / exact;
}

std::string shown(double x, const char* format)
{
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// Evaluations that Monte Carlo needs for the same error.
double monte_carlo(double exact, double error)
{
    return (1.0 - exact) / (exact * error * error);
}

app::Table problem_table(int runs)
{
    app::Table table;
    table.head = {"problem",
                  "exact P",
                  "calls",
                  "most calls",
                  "bias [%]",
                  "rms error [%]",
                  "told [%]",
                  "holds",
                  "truth below",
                  "truth above",
                  "target",
                  "Monte Carlo, same error",
                  {"source", app::kNote}};
    for (const BenchProblem& p : bench_problems()) {
        Tally t;
        for (int run = 1; run <= (p.slow ? runs / 5 : runs); ++run) {
            uq::ActiveOptions o;
            o.target_cov = kTarget;
            o.max_evaluations = kBudget;
            o.seed = static_cast<std::uint64_t>(run);
            note(t, uq::active_learning(p.limit, o), p.exact);
        }
        const double n = t.runs, rms = std::sqrt(t.squares / n);
        table.rows.push_back({p.name, shown(p.exact, "%.4g"), shown(t.calls / n, "%.0f"),
                              shown(t.most_calls, "%.0f"), shown(100.0 * t.error / n, "%.1f"),
                              shown(100.0 * rms, "%.1f"), shown(100.0 * t.told / n, "%.1f"),
                              std::to_string(t.held) + " of " + std::to_string(t.runs),
                              std::to_string(t.below), std::to_string(t.above),
                              std::to_string(t.reached),
                              shown(monte_carlo(p.exact, rms), "%.2g"), p.source});
        std::fprintf(stderr, "%s: %.0f calls, rms %.1f %%, holds %d of %d\n", p.name.c_str(),
                     t.calls / n, 100.0 * rms, t.held, t.runs);
    }
    return table;
}

/// Opens both pages.
const std::string kOpening =
    "`reliability.method = active` "
    "([theory](../../theory.md#11-reliability)); `bash bench/active.sh`. ";

void write_problems(const std::string& path, int runs)
{
    const std::string opening =
        kOpening + "Limit states of known probability, " + std::to_string(runs) +
        " repetitions each with other seeds, target coefficient of variation 10 %, budget " +
        std::to_string(kBudget) +
        ". Errors are errors of the probability over the exact probability. Told: mean "
        "standard error that the method states. Holds: 95 % intervals that contain the exact "
        "probability; truth below and above: intervals that miss it. Target: runs that reached "
        "the target. Other methods on the same limit states: "
        "[active_openturns.md](active_openturns.md).";
    bench::write_report(
        path,
        {"Active learning: known probabilities", opening, {{"", "", "", problem_table(runs)}}});
}

void write_walls(const std::string& path)
{
    const std::string opening =
        kOpening +
        "The wall of `configs/reliability.ini` under 1.00 MPa, compared with subset simulation "
        "of up to 1500 walls. At the same error: number of walls that another method would "
        "need for the standard error of the row (Monte Carlo in closed form; subset from its "
        "own standard error, which falls with the root of the number of walls). Subset "
        "simulation runs with three seeds: one 95 % interval in twenty misses the truth, and "
        "that of seed 1 of the first event does. For the coverage of subset simulation on "
        "limit states of known probability see [theory](../../theory.md#11-reliability).";
    wall_table([&](const app::Table& table) {
        bench::write_report(path, {"Active learning: walls", opening, {{"", "", "", table}}});
    });
}

} // namespace

int main(int argc, char** argv)
try {
    const std::string what = argc > 2 ? argv[1] : "";
    if (what == "problems")
        write_problems(argv[2], argc > 3 ? std::atoi(argv[3]) : 50);
    else if (what == "walls")
        write_walls(argv[2]);
    else {
        std::fputs("usage: active problems OUT.md [REPETITIONS=50] | active walls OUT.md\n",
                   stderr);
        return 2;
    }
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "active: %s\n", e.what());
    return 1;
}
