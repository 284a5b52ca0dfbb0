#include "bench/nodal/nodal_answer.hpp"

#include "bench/nodal/nodal_scheme.hpp"
#include "fragility/curve/curve_reading.hpp"

#include <atomic>
#include <iostream>
#include <thread>

namespace bench {

namespace {

Answer run(const Case& c, double steps_per_mm)
{
    const dem::Model model = scenes::model_of(c.scene, c.discretisation);
    NodalOptions options;
    options.steps_per_mm = steps_per_mm;
    const NodalPush push = push_nodes(model, case_materials(c, model), options);
    Answer a;
    a.steps = push.cost.steps;
    a.seconds = push.cost.seconds;
    a.failed = dem::failed(push.outcome);
    if (a.failed) return a;
    std::vector<double> u, f;
    for (const NodalPoint& p : push.curve) {
        u.push_back(p.displacement);
        f.push_back(p.force);
    }
    const fragility::LimitDisplacement drop = fragility::drop_after_peak({u, f});
    a.peak = fragility::peak({u, f}).force;
    a.ultimate = drop.displacement;
    a.censored = drop.reading != fragility::Reading::observed;
    a.at_30mm = f.back();
    a.mixed = !a.censored; // the rest of the rule needs a picture of the wall
    return a;
}

} // namespace

std::vector<Answer> run_nodal(const std::vector<Case>& cases, double steps_per_mm)
{
    std::vector<Answer> answers(cases.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < cases.size(); i = next++) {
            answers[i] = run(cases[i], steps_per_mm);
            std::cerr << '\r' << next.load() << " of " << cases.size() << std::flush;
        }
    };
    {
        std::vector<std::jthread> team;
        for (unsigned t = 1; t < std::thread::hardware_concurrency(); ++t)
            team.emplace_back(work);
        work();
    }
    std::cerr << '\n';
    return answers;
}

} // namespace bench
