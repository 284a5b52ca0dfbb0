#include "bench/sweep.hpp"

#include "dem/block/model.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "fragility/curve/curve_reading.hpp"

#include <cmath>
#include <iostream>

namespace bench {

namespace {

Answer read(const dem::PushResult& r, double load_height)
{
    std::vector<double> u, f;
    for (const dem::CurvePoint& p : r.curve) {
        u.push_back(p.displacement);
        f.push_back(p.force);
    }
    Answer a;
    a.residual = r.residual;
    a.steps = r.cost.steps;
    a.seconds = r.cost.seconds;
    a.failed = dem::failed(r.outcome);
    if (a.failed) return a;
    const fragility::Curve curve{u, f};
    const fragility::Peak peak = fragility::peak(curve);
    const fragility::LimitDisplacement drop = fragility::drop_after_peak(curve);
    const dem::Mechanism m = dem::mechanism(r.at_end, load_height);
    a.peak = peak.force;
    a.at_peak = peak.displacement;
    a.censored = drop.reading != fragility::Reading::observed;
    a.ultimate = drop.displacement;
    a.at_30mm = f.back();
    a.cracked_units = m.cracked_units;
    a.mixed = dem::failure_mode(m, !a.censored, {.modes = dem::ModeRule::paper}) ==
              dem::FailureMode::mixed;
    return a;
}

bool share_model(const Case& a, const Case& b)
{
    return a.scene.wall == b.scene.wall && a.scene.stone == b.scene.stone &&
           a.scene.beam == b.scene.beam && a.scene.loads.height == b.scene.loads.height &&
           a.scene.loads.gravity == b.scene.loads.gravity &&
           a.discretisation == b.discretisation && a.solver == b.solver &&
           a.record_every == b.record_every;
}

} // namespace

dem::WallMaterials case_materials(const Case& c, const dem::Model& m)
{
    if (c.sample < 0) return scenes::uniform(c.scene, m);
    return c.spatial ? scenes::table5_spatial_sample(c.scene, m, c.sample)
                     : scenes::table5_sample(c.scene, m, c.sample);
}

std::vector<Answer> run_all(const std::vector<Case>& cases, const dem::Workers& workers)
{
    std::vector<Answer> answers(cases.size());
    std::vector<bool> done(cases.size(), false);
    std::size_t count = 0;
    for (std::size_t first = 0; first < cases.size(); ++first) {
        if (done[first]) continue;
        std::vector<std::size_t> group;
        for (std::size_t i = first; i < cases.size(); ++i)
            if (!done[i] && share_model(cases[first], cases[i])) group.push_back(i);
        for (const std::size_t i : group) done[i] = true;
        const Case& common = cases[first];
        const dem::Model model = scenes::model_of(common.scene, common.discretisation);
        dem::PushPlan plan;
        plan.record_every = common.record_every;
        plan.snapshot_at_peak = false;
        const dem::Ensemble ensemble{
            group.size(), [&](std::size_t k) { return case_materials(cases[group[k]], model); },
            [&](std::size_t k, dem::PushResult&& r) {
                answers[group[k]] = read(r, common.scene.loads.height);
                if (++count % 8 == 0 || count == cases.size())
                    std::cerr << '\r' << count << " of " << cases.size() << std::flush;
            }};
        dem::push_ensemble(model, ensemble, plan, common.solver, workers);
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
