#include "app/text/number_text.hpp"
#include "bench/speed/scaling_parts.hpp"
#include "bench/speed/shortest.hpp"
#include "dem/block/model.hpp"
#include "dem/contact/pack.hpp"
#include "dem/solver/ensemble.hpp"
#include "scenes/paper_wall.hpp"

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace bench {

namespace {

constexpr std::size_t kWalls = 320; // many per lane: the last ones leave lanes empty
constexpr int kRuns = 3;

struct Run {
    double seconds = 0.0;
    std::vector<long long> steps; ///< by wall
};

Run run(const scenes::Scene& scene, const dem::Model& model, int threads)
{
    dem::PushPlan plan;
    plan.targets = {0.012};
    plan.snapshot_at_peak = false;
    Run result;
    result.steps.resize(kWalls);
    const dem::Ensemble ensemble{
        kWalls, [&](std::size_t i) { return scenes::table5_sample(scene, model, i); },
        [&](std::size_t i, dem::PushResult&& r) { result.steps[i] = r.cost.steps; }};
    dem::Workers workers;
    workers.threads = threads;
    result.seconds =
        shortest(1, [&] { dem::push_ensemble(model, ensemble, plan, {}, workers); });
    return result;
}

/// Steps until the last wall is done: each goes to the lane that is free first.
long long longest(const std::vector<long long>& steps, int lanes)
{
    std::vector<long long> busy(lanes, 0);
    for (const long long s : steps) *std::min_element(busy.begin(), busy.end()) += s;
    return *std::max_element(busy.begin(), busy.end());
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

app::Table thread_table()
{
    const scenes::Scene scene = scenes::paper_wall(0.75);
    const dem::Model model = scenes::model_of(scene);
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<double> one, all;
    std::vector<long long> steps;
    for (int i = 0; i < kRuns; ++i) { // in turns: a change of the machine meets both
        Run single = run(scene, model, 1);
        one.push_back(single.seconds);
        all.push_back(run(scene, model, cores).seconds);
        steps = std::move(single.steps);
        std::cerr << "run " << i + 1 << ": " << one.back() << " s, " << all.back() << " s\n";
    }
    const double single = median(one), team = median(all);
    app::Table t;
    t.head = {"threads", "walls", "time [s]", "walls/s", "against one thread", "at most"};
    const int lanes = dem::lanes<dem::Pack>;
    const auto add = [&](int threads, double seconds) {
        const double most = static_cast<double>(longest(steps, lanes)) /
                            static_cast<double>(longest(steps, threads * lanes));
        t.rows.push_back({std::to_string(threads), std::to_string(kWalls),
                          app::fixed(seconds, 2), app::fixed(kWalls / seconds, 2),
                          app::fixed(single / seconds, 2), app::fixed(most, 2)});
    };
    add(1, single);
    add(cores, team);
    return t;
}

} // namespace bench
