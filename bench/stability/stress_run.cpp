#include "bench/stability/stress_run.hpp"

#include "bench/stability/stress_limit.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/step/stability_limit.hpp"
#include "dem/solver/thread_time.hpp"

#include <cmath>
#include <exception>

namespace bench {

namespace {

using dem::PushResult;

bool finite(const dem::Energy& e)
{
    return std::isfinite(e.work + e.kinetic + e.elastic + e.friction + e.fracture + e.damping);
}

bool finite(const dem::Snapshot& s)
{
    double sum = s.displacement + s.force;
    for (const dem::BlockState& b : s.blocks)
        for (const dem::Point& u : b.displacement) sum += u.x + u.z;
    for (const dem::FaceState& f : s.faces)
        for (const dem::ContactState& c : f.contacts)
            sum += c.opening + c.slip + c.sigma + c.tau + c.damage;
    return std::isfinite(sum);
}

bool finite(const PushResult& r)
{
    bool all = finite(r.energy) && finite(r.at_end) && finite(r.at_peak) &&
               std::isfinite(r.residual + r.settlement + r.step_fraction);
    for (const dem::CurvePoint& p : r.curve)
        all = all && finite(p.energy) &&
              std::isfinite(p.displacement + p.force + p.base_shear + p.unbalance);
    for (const dem::Snapshot& s : r.snapshots) all = all && finite(s);
    return all;
}

bool same_curve(const PushResult& a, const PushResult& b)
{
    if (a.outcome != b.outcome || a.curve.size() != b.curve.size()) return false;
    for (std::size_t i = 0; i < a.curve.size(); ++i) {
        const dem::CurvePoint &p = a.curve[i], &q = b.curve[i];
        if (p.displacement != q.displacement || p.force != q.force ||
            p.base_shear != q.base_shear || p.energy.damping != q.energy.damping ||
            p.energy.friction != q.energy.friction)
            return !std::isfinite(p.force) && !std::isfinite(q.force); // both broke here
    }
    return true;
}

/// Rule that the outcome of one wall promises and does not keep; empty: nothing.
std::string broken_rule(const PushResult& r)
{
    if (dem::failed(r.outcome)) return {};
    if (!finite(r)) return "a number is not finite";
    if (r.curve.empty() && r.outcome != dem::Outcome::lost_equilibrium) return "no curve";
    double residual = std::max(r.residual, std::abs(r.energy.residual()));
    for (const dem::CurvePoint& p : r.curve)
        residual = std::max(residual, std::abs(p.energy.residual()));
    if (r.outcome != dem::Outcome::lost_equilibrium && residual >= 0.01)
        return "called ok with an energy residual of " + std::to_string(residual);
    return {};
}

/// Results by wall; `without`: a wall that is left out.
std::vector<PushResult> push_all(const StressScene& s, const dem::Model& model,
                                 std::optional<int> without)
{
    std::vector<int> numbers;
    for (int i = 0; i < s.walls; ++i)
        if (without != i) numbers.push_back(i);
    std::vector<PushResult> results(s.walls);
    dem::Ensemble e;
    e.size = numbers.size();
    e.wall = [&](std::size_t i) { return stress_wall(s, model, numbers[i]); };
    e.done = [&](std::size_t i, PushResult&& r) { results[numbers[i]] = std::move(r); };
    dem::Workers workers;
    workers.threads = 1;
    dem::push_ensemble(model, e, s.plan, s.solver, workers);
    return results;
}

/// Only where the bound proves nothing and the wall was called ok all the same.
double over_limit(const StressScene& s, const dem::Model& model, int wall, const PushResult& r)
{
    if (dem::failed(r.outcome) || r.step_fraction <= 1.0 || s.spoil == wall) return 0.0;
    dem::SolverOptions used = s.solver;
    used.step_fraction = r.step_fraction;
    return dem::step_over_limit(model, stress_wall(s, model, wall), used);
}

/// One wall alone, in every eighth scene, and one on its way where joints close.
void look_alone(const StressScene& s, const dem::Model& model,
                const std::vector<PushResult>& results, SceneReport& report)
{
    constexpr int kAlone = 8;
    const int wall = s.spoil == 0 ? 1 : 0;
    const auto complain = [&](const std::string& what) {
        report.broken_rules.push_back("wall " + std::to_string(wall) + ": " + what);
    };
    report.alone = report.number % kAlone == 0;
    if (report.alone && !same_curve(results[wall], dem::push(model, stress_wall(s, model, wall),
                                                             s.plan, s.solver)))
        complain("not the same bits alone");
    if (s.scene.closure == dem::Closure::linear) return;
    report.on_the_way = over_limit_on_the_way(s, model, wall);
    if (!(report.on_the_way <= 1.0))
        complain("step is " + std::to_string(report.on_the_way) + " of the limit on the way");
}

void run(const StressScene& s, SceneReport& report)
{
    const dem::Model model = model_of(s);
    const std::vector<PushResult> results = push_all(s, model, {});
    const auto complain = [&](int wall, const std::string& what) {
        if (!what.empty())
            report.broken_rules.push_back("wall " + std::to_string(wall) + ": " + what);
    };
    for (int i = 0; i < s.walls; ++i) {
        const PushResult& r = results[i];
        report.walls.push_back({r.outcome, s.spoil == i, r.step_reductions, r.residual,
                                r.cost.steps, r.settled, over_limit(s, model, i, r)});
        complain(i, broken_rule(r));
        if (report.walls.back().over_limit > 1.0) complain(i, "pushed with an unstable step");
    }
    if (s.laws == DrawnLaws::all) look_alone(s, model, results, report);
    if (!s.spoil) return;
    const std::vector<PushResult> others = push_all(s, model, s.spoil);
    for (int i = 0; i < s.walls; ++i)
        if (s.spoil != i && !same_curve(results[i], others[i]))
            complain(i, "not the same bits without its spoilt neighbour");
}

} // namespace

SceneReport run_stress_scene(std::uint64_t seed, std::uint64_t number,
                             dem::Kinematics kinematics, DrawnLaws laws)
{
    const double start = dem::thread_seconds();
    SceneReport report;
    report.number = number;
    report.scene = stress_scene(seed, number, laws);
    if (kinematics == dem::Kinematics::finite) report.scene.solver.kinematics = kinematics;
    try {
        run(report.scene, report);
    } catch (const std::exception& e) {
        report.broken_rules.push_back(std::string("exception: ") + e.what());
    }
    report.seconds = dem::thread_seconds() - start;
    return report;
}

const char* name_of(dem::Outcome o)
{
    switch (o) {
    case dem::Outcome::reached_target:
        return "ok";
    case dem::Outcome::decided:
        return "ok, decided";
    case dem::Outcome::lost_equilibrium:
        return "collapsed";
    case dem::Outcome::not_finite:
        return "failed: not finite";
    case dem::Outcome::energy_astray:
        return "failed: energy astray";
    case dem::Outcome::out_of_steps:
        return "failed: out of steps";
    case dem::Outcome::no_wall:
        return "failed: no wall";
    }
    return "";
}

} // namespace bench
