#include "bench/active/walls.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/reliability/event.hpp"

#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace active_bench {
namespace {

struct WallEvent {
    std::vector<std::string> keys;
    bool counted = false; ///< frequent enough for plain Monte Carlo
};

const std::vector<WallEvent> kEvents = {
    {{"reliability.response=peak_force", "reliability.demand=74 kN"}, true},
    {{"reliability.response=ultimate_drift", "reliability.demand=0.5",
      "solver.kinematics=finite"}},
    {{"reliability.response=peak_force", "reliability.demand=32 kN"}}};

/// Walls of subset simulation at most: several runs, so that its own standard error, from which
/// the walls that it needs at another error are worked out, is not that of few chains (tuned).
constexpr const char* kSubsetBudget = "reliability.budget=1500";

/// Walls of plain Monte Carlo, another judge of the frequent event.
constexpr const char* kPlainBudget = "reliability.budget=3000";

struct WallRun {
    std::string words;
    std::size_t walls;
    uq::MethodAnswer answer;
};

WallRun run(const WallEvent& event, const std::vector<std::string>& how)
{
    std::vector<std::string> keys = event.keys;
    keys.insert(keys.end(), how.begin(), how.end());
    const app::PreparedStudy ready =
        app::prepare(app::read_study(std::string("configs/reliability.ini"), keys));
    const auto threads = static_cast<int>(std::thread::hardware_concurrency());
    const uq::ReliabilityProblem problem = app::wall_problem(ready, "", threads);
    const uq::ReliabilityAnswer a = uq::reliability(problem);
    return {problem.words, a.evaluations, a.methods.front()};
}

std::string shown(std::optional<double> x, const char* format)
{
    if (!x) return "-";
    char text[40];
    std::snprintf(text, sizeof text, format, *x);
    return text;
}

} // namespace

void wall_table(const std::function<void(const app::Table&)>& seen)
{
    app::Table table;
    table.head = {"event",
                  "method",
                  "seed",
                  "walls",
                  "P",
                  "cov [%]",
                  "lower",
                  "upper",
                  "Monte Carlo at the same error",
                  "subset at the same error",
                  "times fewer than subset"};
    for (const WallEvent& event : kEvents) {
        const auto subset_run = [&](const std::string& seed) {
            return run(event, {"reliability.method=subset", kSubsetBudget,
                               "reliability.target_cov=0.05", "uq.seed=" + seed});
        };
        const WallRun subset = subset_run("1");
        const auto cov = [](const WallRun& r) {
            return r.answer.std_error.value_or(0.0) / r.answer.probability.value_or(1.0);
        };
        const auto add = [&](const WallRun& r, const std::string& seed) {
            const double same =
                static_cast<double>(subset.walls) * std::pow(cov(subset) / cov(r), 2);
            const double p = r.answer.probability.value_or(1.0);
            const double plain = (1.0 - p) / (p * cov(r) * cov(r));
            table.rows.push_back({r.words, r.answer.method, seed, std::to_string(r.walls),
                                  shown(r.answer.probability, "%.3g"),
                                  shown(100.0 * cov(r), "%.1f"), shown(r.answer.lower, "%.3g"),
                                  shown(r.answer.upper, "%.3g"), shown(plain, "%.0f"),
                                  shown(same, "%.0f"),
                                  shown(same / static_cast<double>(r.walls), "%.1f")});
            std::fprintf(stderr, "%s, %s: %zu walls, %.3g +- %.1f %%\n", r.words.c_str(),
                         r.answer.method.c_str(), r.walls, r.answer.probability.value_or(0.0),
                         100.0 * cov(r));
        };
        add(subset, "1");
        for (const char* const seed : {"2", "3"}) add(subset_run(seed), seed);
        if (event.counted)
            add(run(event, {"reliability.method=monte_carlo", kPlainBudget,
                            "reliability.target_cov=0.01", "uq.seed=4"}),
                "4");
        for (const char* const seed : {"1", "2", "3"})
            add(run(event, {"reliability.method=active", "reliability.budget=400",
                            "reliability.target_cov=0.1", std::string("uq.seed=") + seed}),
                seed);
        seen(table);
    }
}

} // namespace active_bench
