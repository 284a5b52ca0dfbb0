#include "bench/sweep.hpp"

#include "dem/mechanism.hpp"
#include "fragility/curve_reading.hpp"

#include <atomic>
#include <cmath>
#include <iostream>
#include <thread>

namespace bench {

namespace {

Answer run(const Case& c)
{
    const dem::Model model = scenes::model_of(c.scene, c.discretisation);
    const dem::WallMaterials walls = c.sample < 0
                                         ? scenes::uniform(c.scene, model)
                                         : scenes::table5_sample(c.scene, model, c.sample);
    dem::PushPlan plan;
    plan.record_every = c.record_every;
    const dem::PushResult r = dem::push(model, walls, plan, c.solver);

    std::vector<double> u, f;
    Answer a;
    for (const dem::CurvePoint& p : r.curve) {
        u.push_back(p.displacement);
        f.push_back(p.force);
        a.residual = std::max(a.residual, std::abs(p.energy.residual()));
    }
    const fragility::Curve curve{u, f};
    const fragility::Peak peak = fragility::peak(curve);
    const fragility::LimitDisplacement drop = fragility::drop_after_peak(curve);
    const dem::Mechanism m = dem::mechanism(r.at_end, c.scene.loads.height);
    a.peak = peak.force;
    a.at_peak = peak.displacement;
    a.censored = drop.reading != fragility::Reading::observed;
    a.ultimate = drop.displacement;
    a.at_30mm = f.back();
    a.cracked_units = m.cracked_units;
    a.mixed = dem::failure_mode(m, !a.censored) == dem::FailureMode::mixed;
    a.steps = r.cost.steps;
    a.seconds = r.cost.seconds;
    return a;
}

} // namespace

std::vector<Answer> run_all(const std::vector<Case>& cases)
{
    std::vector<Answer> answers(cases.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < cases.size(); i = next++) {
            answers[i] = run(cases[i]);
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

Moments moments(const std::vector<double>& values)
{
    Moments m;
    m.n = static_cast<int>(values.size());
    if (m.n < 2) return m;
    double sum = 0.0, squares = 0.0;
    for (const double v : values) sum += v;
    m.mean = sum / m.n;
    for (const double v : values) squares += (v - m.mean) * (v - m.mean);
    m.cov = std::sqrt(squares / (m.n - 1)) / m.mean;
    return m;
}

} // namespace bench
