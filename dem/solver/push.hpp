#pragma once
/// A wall under vertical load, then pushed along a list of target displacements. The result can
/// be judged: energy, unbalance, outcome.

#include "dem/scene/snapshot.hpp"
#include "dem/scene/wall.hpp"
#include "dem/solver/curve_point.hpp"
#include "dem/solver/energy.hpp"
#include "dem/solver/solver_options.hpp"

#include <functional>
#include <span>
#include <vector>

namespace dem {

struct Model; // dem/block/model.hpp

enum class Outcome {
    reached_target,   ///< all target displacements reached
    decided,          ///< stopped by PushPlan::decided: nothing more to learn
    lost_equilibrium, ///< the wall came down: blocks parted by more than its height. A result
    not_finite,       ///< the numbers broke: kept, named, and no number of it is used
    energy_astray, ///< more energy appeared or vanished than energy_tolerance, at any step tried
    out_of_steps,  ///< SolverOptions::most_steps were not enough
    no_wall        ///< its materials make no wall, so that nothing was pushed
};

/// The run says nothing about the wall (or not enough): kept, counted, never averaged.
[[nodiscard]] constexpr bool failed(Outcome o)
{
    return o == Outcome::not_finite || o == Outcome::energy_astray ||
           o == Outcome::out_of_steps || o == Outcome::no_wall;
}

/// What a run took.
struct RunCost {
    long long steps = 0;
    long long contact_updates = 0;
    double seconds =
        0.0; ///< of one core (thread_time.hpp); walls that share a register share it
};

struct PushResult {
    Outcome outcome = Outcome::reached_target;
    std::vector<CurvePoint> curve; ///< the first point is the wall before the push
    std::vector<Snapshot>
        snapshots; ///< as asked for in PushPlan, in order of the way; the first before the push
    Snapshot at_peak; ///< at the curve point with the largest force
    Snapshot at_end;
    Energy energy;         ///< at the end
    double residual = 0.0; ///< largest |energy residual| wherever it was read [-]
    /// Of the step that is stable by the bound of block_element.hpp [-]; smaller than asked for
    /// where that step made energy or was above the measured limit: halved each time, and the wall
    /// pushed anew.
    double step_fraction = 0.0;
    int step_reductions = 0;
    bool settled = false;    ///< at rest under the vertical load before the push
    double settlement = 0.0; ///< of the beam under vertical load alone [m], positive down
    int snap_back_contacts =
        0; ///< in units, f_T > sqrt(2 G k_n): break at once and release f_T^2/(2 k_n) > G
    RunCost cost;
};

/// Where to go and what to keep. What is not asked for is not computed.
struct PushPlan {
    std::vector<double> targets = {
        0.03}; ///< load-line displacements [m] in order; a cyclic push changes sign
    double record_every = 5e-5;  ///< way between curve points [m], > 0
    double snapshot_every = 0.0; ///< way between snapshots [m]; 0: none
    bool energy_at_points =
        true; ///< ledger at every curve point, else only every few hundred steps
    bool snapshot_at_peak = true;
    /// Asked at each curve point; true ends the push. May be empty.
    std::function<bool(std::span<const CurvePoint>)> decided;
    std::function<void(double done, double displacement, double force)>
        progress; ///< done in [0, 1]; may be empty
};

/// @throws std::invalid_argument if materials do not fit the model or a value is outside its range
void check(const Model& model, const WallMaterials& materials);
void check(const PushPlan& plan, const SolverOptions& options);

/// One wall, in plain doubles. The same bits as from push_ensemble.
/// @param materials as many joints and cracks as the model has
/// @throws std::invalid_argument as check
[[nodiscard]] PushResult push(const Model& model, const WallMaterials& materials,
                              const PushPlan& plan, const SolverOptions& options = {});

} // namespace dem
