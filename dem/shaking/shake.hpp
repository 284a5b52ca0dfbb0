#pragma once
/// The time history of one wall on ground that moves: static start under its loads, the record,
/// and free vibration after it. The result says how far it can be trusted (outcome, energy
/// balance).
///
/// Verified against closed forms (docs/dynamics.md), and not validated: no open test of a
/// dry-joint wall that is shaken in its plane is known.

#include "dem/scene/geometry/snapshot.hpp"
#include "dem/scene/wall.hpp"
#include "dem/shaking/load_mass.hpp"
#include "dem/solver/state/energy.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <functional>
#include <string_view>
#include <vector>

namespace dem {

struct Model; // dem/block/model.hpp

/// A block before the ground moves, against the undeformed wall.
struct Displaced {
    int block = 0; ///< index in Layout::blocks
    double x = 0.0,
           z = 0.0;    ///< displacement of its pivot, which is the middle of its extent [m]
    double turn = 0.0; ///< rotation, clockwise [rad]
};

struct ShakePlan {
    double step = 0.0; ///< time between samples [s], > 0
    std::vector<double>
        horizontal; ///< acceleration of the ground to the right [m/s2], linear between samples
    std::vector<double> vertical; ///< upwards [m/s2]; as many, or empty
    LoadMass load = LoadMass::none;
    double load_height =
        0.0; ///< of the floor's mass above the point on which the load acts [m]
    double free_vibration = 30.0; ///< longest time that is followed after the record [s], >= 0
    /// Free vibration ends after a second in which the top has moved by no more than this share
    /// of the wall's height, or has swung a little about one place (free_vibration.hpp) [-]; 0:
    /// never.
    double quiet = 0.0;
    double record_every = 0.005;  ///< between points of the history [s], > 0
    double contact_damping = 0.0; ///< zeta of dry joints [-], >= 0
    /// Share of the largest stable step [-], in (0, 1].
    double step_fraction = 0.9;
    std::vector<Displaced>
        released; ///< the wall starts from there, without a static start; or empty
    double snapshot_every = 0.0; ///< [s]; 0: none
    /// Called now and then with the share of the time that is done, and the displacement of the
    /// top [m].
    std::function<void(double done, double displacement)> progress;
};

struct HistoryPoint {
    double time = 0.0;         ///< [s]
    double ground = 0.0;       ///< horizontal acceleration [m/s2]
    double displacement = 0.0; ///< of the top against the ground, to the right [m]
    double base_shear = 0.0;   ///< of the wall on the ground [N]
};

enum class ShakeOutcome {
    stood,     ///< to the end of the time that was asked for
    collapsed, ///< weight and load have come down by kCameDown of the height, or parts are farther apart than that
    unsettled, ///< the wall does not stand at rest under its loads
    not_finite,    ///< a number is NaN or infinite, even with the smallest step
    energy_astray, ///< the energy balance missed 1 % even with the smallest step
};
[[nodiscard]] std::string_view name_of(ShakeOutcome outcome);

/// Mean way down of weight and vertical load, as a share of the wall's height, at which a wall
/// has collapsed.
constexpr double kCameDown = 0.02;

struct ShakeResult {
    ShakeOutcome outcome = ShakeOutcome::stood;
    std::vector<HistoryPoint> history;
    double most_displacement = 0.0; ///< largest distance of the top from its place at rest [m]
    double most_at = 0.0;           ///< when [s]
    double residual_displacement =
        0.0;            ///< mean of the top in the last second of the free vibration [m]
    bool still = false; ///< at the end nothing moves any more
    double collapse_time = 0.0; ///< [s]; only of a wall that collapsed
    bool overturned =
        false; ///< collapsed as a whole: in the mean by weight past length over height
    double top_height = 0.0; ///< of the point whose displacement is told, above the base [m]
    double first_opening = 0.0,
           last_opening =
               0.0; ///< times at which a dry contact opened or closed [s]; 0: none did
    /// Largest share of the lowest joint between what the ground holds and what moves that was
    /// open [-].
    double uplift = 0.0;
    double peak_ground = 0.0; ///< largest acceleration of the ground [m/s2]
    double unbalance = 0.0;   ///< of the static start [-]
    double residual =
        0.0;       ///< largest error of the energy balance over the energy that passed [-]
    Energy energy; ///< at the end; kinetic with that of the true masses
    double ground_work = 0.0; ///< of the ground, in energy.work [J]
    double fall_work = 0.0;   ///< of weight and load since the ground moves, in energy.work [J]
    double time_step = 0.0;   ///< [s]
    double end = 0.0;         ///< of the history [s]
    int step_reductions = 0;
    long long steps = 0;
    double seconds = 0.0;               ///< of one core
    std::vector<Snapshot> snapshots;    ///< as snapshot_every asks; displacement: of the top
    std::vector<double> snapshot_times; ///< [s]
    /// Where the wall turned back from its largest displacement, or came down; and at the end.
    Snapshot at_most, at_end;
};

/// @throws std::invalid_argument if a number of the plan is out of its range, or the model is
/// of a kind that cannot be
/// shaken: pushed at its beam, with joints that close, crushing, or a toe that is held
[[nodiscard]] ShakeResult shake(const Model& model, const WallMaterials& materials,
                                const ShakePlan& plan, const SolverOptions& options = {});

} // namespace dem
