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
    for (const double target : plan.targets)
        require(std::isfinite(target), "targets must be finite");
    require(plan.record_every > 0 && plan.snapshot_every >= 0,
            "curve points need a spacing > 0");
    require(o.steps_per_mm > 0 && o.damping_factor > 0 && o.damping_factor < 1 &&
                o.step_fraction > 0 && o.step_fraction <= 1,
            "steps per mm > 0, damping factor in (0, 1), step fraction in (0, 1]");
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
    const SolverOptions& options;
    WallState<double> state;
    Drive drive;
    Recorder recorder;
    PushResult result = {};
    double peak = 0.0;          ///< largest force so far, either way [N]
    double way = 0.0;           ///< travelled since the start of the push [m]
    double next_snapshot = 0.0; ///< on the way [m]

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

constexpr long long kLookEvery = 500; // steps between looks at the wall from outside

/// A step under vertical load alone.
void settle(Run& r)
{
    StepInput<double> in;
    in.load_factor = r.drive.load_factor();
    in.drive = r.drive.advance();
    step(r.tables, r.options, in, r.state);
    r.drive.settle([&r] { return unbalanced_ratio(r.state, 0); });
    if (!r.drive.settling()) begin_push(r);
}

/// A step of the push, and a point of the curve where one is due.
void go_on(Run& r)
{
    const double before = r.state.top_force;
    const double drive = r.drive.advance();
    step(r.tables, r.options, {1.0, drive}, r.state);
    r.way += std::abs(drive);
    r.recorder.add(drive, before, r.state.top_force, r.state.base_shear);
    if (r.tables.vertical_load > 0.0)
        r.drive.feel(std::abs(r.state.top_force - r.state.base_shear) / r.tables.vertical_load);
    const bool room_for_another = r.drive.left() > 0.5 * r.plan.record_every;
    const bool wanted = r.drive.finished() || (r.recorder.due() && room_for_another);
    if (wanted && r.recorder.any()) take_point(r);
}

void finish(Run& r)
{
    r.result.energy = energy_of(r.tables, r.state, 0);
    r.result.at_end =
        r.snapshot(r.result.curve.empty() ? r.state.top_force : r.result.curve.back().force);
    const std::size_t contacts =
        r.model.dry.size() + r.model.tied.size() + r.model.cracks.size();
    r.result.cost.contact_updates = r.result.cost.steps * static_cast<long long>(contacts);
}

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
          options,
          unloaded<double>(model, tables, {&materials, 1}, options),
          Drive(plan.targets, options),
          Recorder(plan.record_every)};
    r.result.snap_back_contacts = count_snap_back(model, materials);

    while (!r.drive.finished() && r.result.outcome == Outcome::reached_target) {
        r.drive.settling() ? settle(r) : go_on(r);
        if (++r.result.cost.steps % kLookEvery != 0) continue;
        r.result.outcome = judge(r);
        if (plan.progress) plan.progress(r.drive.done(), r.drive.position(), r.state.top_force);
    }
    finish(r);
    const auto end = std::chrono::steady_clock::now();
    r.result.cost.seconds = std::chrono::duration<double>(end - start).count();
    return r.result;
}

} // namespace dem
