#include "dem/push.hpp"

#include "dem/drive.hpp"
#include "dem/picture.hpp"
#include "dem/recorder.hpp"
#include "dem/step.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace dem {

namespace {

void check(const Model& m, const WallMaterials& w, const PushPlan& plan, const SolverOptions& o)
{
    const auto require = [](bool ok, const char* what) {
        if (!ok) throw std::invalid_argument(what);
    };
    require(static_cast<int>(w.joints.size()) == m.layout.n_joints,
            "one material per joint ID");
    require(static_cast<int>(w.cracks.size()) == m.layout.n_cracks,
            "one material per crack ID");
    for (const JointMaterial& j : w.joints)
        require(j.kn > 0 && j.ks > 0 && j.tan_phi >= 0,
                "a joint needs positive stiffness and friction >= 0");
    for (const CrackMaterial& c : w.cracks)
        require(
            c.kn > 0 && c.ks > 0 && c.ft >= 0 && c.cohesion >= c.cohesion_res &&
                c.cohesion_res >= 0 && c.tan_phi >= 0 && c.tan_phi_res >= 0 &&
                c.fracture_energy >= 0,
            "a unit crack needs positive stiffness and strengths >= 0, residual <= initial");
    require(plan.record_every > 0 && plan.snapshot_every >= 0,
            "curve points need a spacing > 0");
    require(o.steps > 0 && o.damping_factor > 0 && o.damping_factor < 1 &&
                o.step_fraction > 0 && o.step_fraction <= 1,
            "steps > 0, damping factor in (0, 1), step fraction in (0, 1]");
}

int count_snap_back(const Model& m, const WallMaterials& w)
{
    int n = 0;
    for (const Contact& c : m.cracks) {
        const CrackMaterial& k = w.cracks[c.material];
        n += k.ft > std::sqrt(2.0 * k.fracture_energy * k.kn);
    }
    return n;
}

/// One wall on its way: what is kept of it between steps.
struct Run {
    const Model& model;
    const StepTables& tables;
    const PushPlan& plan;
    WallState<double> state;
    Drive drive;
    Recorder recorder;
    PushResult result;
    double peak = 0.0;
    double next_snapshot = 0.0; ///< share of the way [m]
    double way = 0.0;

    [[nodiscard]] Snapshot snapshot(double force) const
    {
        return picture(model, tables, state, 0, drive.position(), force);
    }
};

/// Mean settlement of the beam's lower face [m].
double settlement_of(const Snapshot& s)
{
    double sum = 0.0;
    int n = 0;
    const BlockState& beam = s.blocks.back();
    for (std::size_t p = 0; p < beam.outline.size(); ++p)
        if (std::abs(beam.outline[p].z - beam.outline.front().z) < 1e-9) {
            sum -= beam.displacement[p].z;
            ++n;
        }
    return sum / n;
}

void begin_push(Run& r)
{
    const Energy e = energy_of(r.tables, r.state, 0);
    r.result.curve.push_back({0.0, r.state.top_force, r.state.base_shear, 0.0, e});
    const Snapshot s = r.snapshot(r.state.top_force);
    r.result.settlement = settlement_of(s);
    r.result.at_peak = s;
    if (r.plan.snapshot_every > 0.0) r.result.snapshots.push_back(s);
    r.next_snapshot = r.plan.snapshot_every;
}

void take_point(Run& r)
{
    const CurvePoint p = r.recorder.take(r.drive.position(), energy_of(r.tables, r.state, 0));
    r.result.curve.push_back(p);
    if (std::abs(p.force) > r.peak) {
        r.peak = std::abs(p.force);
        r.result.at_peak = r.snapshot(p.force);
    }
    if (r.plan.snapshot_every > 0.0 && r.way >= r.next_snapshot) {
        r.result.snapshots.push_back(r.snapshot(p.force));
        r.next_snapshot += r.plan.snapshot_every;
    }
    if (r.plan.progress) r.plan.progress(r.drive.done(), p.displacement, p.force);
}

/// Whether the run can go on.
Outcome judge(const Run& r)
{
    const double height = r.model.wall.courses * r.model.wall.course_height;
    double worst = 0.0;
    for (const double du : r.state.du) {
        if (!std::isfinite(du)) return Outcome::not_finite;
        worst = std::max(worst, std::abs(du));
    }
    for (const DryState<double>& c : r.state.dry) worst = std::max(worst, std::abs(c.u_n));
    return worst > height ? Outcome::lost_equilibrium : Outcome::reached_target;
}

constexpr long long kJudgeEvery = 500; // steps

} // namespace

PushResult push(const Model& model, const WallMaterials& materials, const PushPlan& plan,
                const SolverOptions& options)
{
    check(model, materials, plan, options);
    const auto start = std::chrono::steady_clock::now();
    const StepTables tables = step_tables(model);
    Run r{model,
          tables,
          plan,
          unloaded<double>(model, tables, {&materials, 1}, options),
          Drive(plan.targets, options),
          Recorder(plan.record_every),
          {},
          0.0,
          0.0,
          0.0};
    r.result.snap_back_contacts = count_snap_back(model, materials);

    bool settled = false;
    while (!r.drive.finished()) {
        StepInput<double> in;
        in.load_factor = r.drive.load_factor();
        const bool settling = r.drive.settling();
        in.drive = r.drive.advance();
        const double before = r.state.top_force;
        step(tables, options, in, r.state);
        ++r.result.cost.steps;
        if (settling) {
            r.drive.settle([&r] { return unbalanced_ratio(r.state, 0); });
        } else {
            r.way += std::abs(in.drive);
            r.recorder.add(in.drive, before, r.state.top_force, r.state.base_shear);
            r.drive.feel(std::abs(r.state.top_force - r.state.base_shear) /
                         tables.vertical_load);
            if (r.drive.finished() || (r.recorder.due() && r.drive.left() > 0.5 * plan.record_every)) take_point(r);
        }
        if (r.result.cost.steps % kJudgeEvery == 0) r.result.outcome = judge(r);
        if (r.result.outcome != Outcome::reached_target) break;
        if (!settled && !r.drive.settling()) {
            settled = true;
            begin_push(r);
        }
    }
    r.result.energy = energy_of(tables, r.state, 0);
    r.result.at_end = r.snapshot(r.result.curve.empty() ? r.state.top_force : r.result.curve.back().force);
    r.result.cost.contact_updates =
        r.result.cost.steps *
        static_cast<long long>(model.dry.size() + model.tied.size() + model.cracks.size());
    r.result.cost.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return r.result;
}

} // namespace dem
