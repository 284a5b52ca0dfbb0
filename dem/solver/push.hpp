#pragma once
/// One wall: loaded vertically, then pushed to a list of target displacements. The result says
/// how far it can be trusted (outcome, energy balance, unbalance).

#include "dem/scene/geometry/snapshot.hpp"
#include "dem/scene/wall.hpp"
#include "dem/solver/state/curve_point.hpp"
#include "dem/solver/state/energy.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace dem {

struct Model; // dem/block/model.hpp

enum class Outcome {
    reached_target, ///< the wall reached all target displacements
    decided,        ///< PushPlan::decided stopped the push, because there was no more to learn
    lost_equilibrium, ///< the wall collapsed: blocks fall freely, or gaps or overlaps exceed its height. This is a
    ///< result, not an error
    not_finite,    ///< a number is NaN or infinite; the run is counted, but none of it is used
    energy_astray, ///< the energy balance missed energy_tolerance even with the smallest step
    out_of_steps,  ///< SolverOptions::most_steps were not enough
    no_wall        ///< its materials make no wall, so that nothing was pushed
};

/// Names in the order of Outcome.
inline constexpr std::array<std::string_view, 7> kOutcomeNames = {
    "reached target", "decided",      "lost equilibrium", "not finite",
    "energy astray",  "out of steps", "no wall"};
[[nodiscard]] constexpr std::string_view name(Outcome outcome)
{
    return kOutcomeNames[static_cast<int>(outcome)];
}

/// Whether a run says nothing about the wall, or not enough. Such runs are kept and counted,
/// but never averaged.
[[nodiscard]] constexpr bool failed(Outcome o)
{
    return o == Outcome::not_finite || o == Outcome::energy_astray ||
           o == Outcome::out_of_steps || o == Outcome::no_wall;
}

/// Cost of a run.
struct RunCost {
    long long steps = 0;
    long long contact_updates = 0;
    /// Time of one core (thread_time.hpp) [s]. Walls that share a register share its time.
    double seconds = 0.0;
};

struct PushResult {
    Outcome outcome = Outcome::reached_target;
    /// The first point is the wall before the push. Where the push turns back a point stands at
    /// the turn.
    std::vector<CurvePoint> curve;
    /// As PushPlan::snapshot_every asks, in the order of the push; the first is before the
    /// push. Empty where PushPlan::sink takes them.
    std::vector<Snapshot> snapshots;
    Snapshot at_peak;                ///< at the curve point with the largest force
    Snapshot faces_at_peak;          ///< faces alone, at that point
    std::optional<Snapshot> at_drop; ///< where the force first came down to PushPlan::drop
    /// Snapshot of a push for which PushPlan::drop was asked, and whose force had not come down
    /// to it: between 0.45 and 0.5 of the way to the end.
    std::optional<Snapshot> at_half;
    /// At the farthest turn, the last of equals; none where the push ends farther out, or goes
    /// one way.
    std::optional<Snapshot> at_farthest;
    Snapshot at_end;
    Energy energy;         ///< at the end
    double residual = 0.0; ///< largest |energy residual| wherever it was read [-]
    /// The step that was used, as a fraction of the proven stability limit (block_element.hpp)
    /// [-]. It is smaller than asked for where that step made energy or exceeded the measured
    /// limit: it is then halved, and the wall is pushed again from the start.
    double step_fraction = 0.0;
    int step_reductions = 0;
    /// Number of starts in ten times the steps or more, because the wall seemed to come down
    /// under its vertical load: 0 or 1.
    int slow_starts = 0;
    /// How often the wall was pushed again, twice as slowly, because its error was larger than
    /// the accuracy: 0 to 3. One way, a push was given up once its peak was past.
    int slowdowns = 0;
    /// Estimated error of the peak force by the speed of the drive [-], >= 0.
    double solver_error = 0.0;
    bool settled =
        false; ///< whether the wall was at rest under the vertical load before the push
    double settlement = 0.0; ///< of the beam under vertical load alone [m], positive downwards
    /// Number of crack contacts with f_T > sqrt(2 G k_n), which break at once and release more
    /// than G.
    int snap_back_contacts = 0;
    /// Number of crack contacts with c - c_res > sqrt(2 G_II k_s), which break at their first
    /// slip and release more than G_II.
    int shear_snap_back_contacts = 0;
    int crack_contacts = 0; ///< of cracks in units and of joints with mortar
    /// Contacts of cracks that have ever lost a part of their strength but not all of it: in
    /// tension, 0 < d_t < 1 while their bond lived, and in shear, 0 < d_s < 1.
    int softened_in_tension = 0, softened_in_shear = 0;
    /// Number of contacts with f_c > sqrt(2 G_c k_n), which crush at once and release more than
    /// G_c.
    int brittle_crushing_contacts = 0;
    double weight =
        0.0; ///< of all blocks, with body forces [N]: force over it is the load factor
    RunCost cost;
};

/// Takes the snapshots of walls as they come, so that none is kept in memory. Both functions
/// are called from the thread that pushes the wall, for several walls at the same time; what
/// they throw ends the push.
struct SnapshotSink {
    std::function<void(std::size_t wall, Snapshot&&)>
        take; ///< empty: PushResult::snapshots keeps them
    /// The push of this wall starts anew: what was taken of it so far is void. Not empty where
    /// `take` is not.
    std::function<void(std::size_t wall)> forget;
};

/// How far the push of a wall is. One that begins again says why by what it counts.
struct PushProgress {
    std::size_t wall = 0;      ///< number in its ensemble
    double done = 0.0;         ///< share of its way since it began (again) [-], in [0, 1]
    double displacement = 0.0; ///< of the load line [m]
    double force = 0.0;        ///< [N]
    int slow_starts = 0, step_reductions = 0, slowdowns = 0; ///< as in PushResult
    double error_before = 0.0; ///< of the push before the last slowdown [-]; 0: there is none
};

/// Where to push the wall and what to keep. Nothing is computed that is not asked for.
struct PushPlan {
    /// Displacements of the load line in order [m]; in a cyclic push they change sign.
    std::vector<double> targets = {0.03};
    double record_every = 5e-5;  ///< travelled displacement between curve points [m], > 0
    double snapshot_every = 0.0; ///< travelled displacement between snapshots [m]; 0 takes none
    /// Whether these snapshots tell mean stresses, over the steps of which the point of the
    /// curve is a mean. Forces of an instant ring where a block slips.
    bool mean_stresses = false;
    SnapshotSink sink; ///< of these snapshots; `push` calls its wall 0
    bool snapshot_at_peak = true;
    /// A snapshot is taken where the force first comes down to this share of its peak [-], in
    /// [0, 1); 0: none.
    double drop = 0.0;
    /// Is asked at each curve point and ends the push by returning true. May be empty.
    std::function<bool(std::span<const CurvePoint>)> decided;
    /// Is told every few hundred steps how far the push is. May be empty.
    std::function<void(const PushProgress&)> progress;
};

/// @throws std::invalid_argument if the materials do not fit the model or a value is outside
/// its range
void check(const Model& model, const WallMaterials& materials);
void check(const PushPlan& plan, const SolverOptions& options);
void check(const Model& model, const SolverOptions& options);

/// Pushes one wall, in plain doubles. push_ensemble gives the same bits.
/// @throws std::invalid_argument as check() does
[[nodiscard]] PushResult push(const Model& model, const WallMaterials& materials,
                              const PushPlan& plan, const SolverOptions& options = {});

} // namespace dem
