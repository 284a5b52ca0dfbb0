#pragma once
/// A wall under vertical load, then pushed along a list of target displacements. The result can
/// be judged: energy, unbalance, outcome.

#include "dem/energy.hpp"
#include "dem/model.hpp"
#include "dem/snapshot.hpp"
#include "dem/solver_options.hpp"
#include "dem/wall.hpp"

#include <functional>
#include <vector>

namespace dem {

enum class Outcome {
    reached_target,   ///< all target displacements reached
    lost_equilibrium, ///< the wall came down: blocks parted by more than its height. A result
    not_finite        ///< the numbers broke: kept, named, and no number of it is used
};

/// A point of the capacity curve: means over the way since the previous point, placed at its
/// middle.
struct CurvePoint {
    double displacement = 0.0; ///< of the load line [m]
    double force = 0.0;        ///< horizontal load [N]: work of the drive / way
    double base_shear = 0.0;   ///< horizontal force on the ground [N]
    double unbalance = 0.0;    ///< mean of |load - base shear| [N]
    Energy energy;             ///< at the end of the interval, since the unloaded wall [J]
};

/// What a run took.
struct RunCost {
    long long steps = 0;
    long long contact_updates = 0;
    double seconds = 0.0; ///< wall clock
};

struct PushResult {
    Outcome outcome = Outcome::reached_target;
    std::vector<CurvePoint> curve; ///< the first point is the wall before the push
    std::vector<Snapshot>
        snapshots; ///< as asked for in PushPlan, in order of the way; the first before the push
    Snapshot at_peak; ///< at the curve point with the largest force
    Snapshot at_end;
    Energy energy;
    double settlement = 0.0; ///< of the beam under vertical load alone [m], positive down
    int snap_back_contacts =
        0; ///< in units, f_T > sqrt(2 G k_n): break at once and release f_T^2/(2 k_n) > G
    RunCost cost;
};

/// Where to go and what to keep.
struct PushPlan {
    std::vector<double> targets = {
        0.03}; ///< load-line displacements [m] in order; a cyclic push changes sign
    double record_every = 5e-5;  ///< way between curve points [m], > 0
    double snapshot_every = 0.0; ///< way between snapshots [m]; 0: none
    std::function<void(double done, double displacement, double force)>
        progress; ///< done in [0, 1]; may be empty
};

/// @param materials as many joints and cracks as the model has
/// @throws std::invalid_argument if they do not fit or a value is outside its range
[[nodiscard]] PushResult push(const Model& model, const WallMaterials& materials,
                              const PushPlan& plan, const SolverOptions& options = {});

} // namespace dem
