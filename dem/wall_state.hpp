#pragma once
/// Where the walls of a batch are: one array per quantity, one lane per wall. What they are is
/// in the model.

#include "dem/contact_law.hpp"
#include "dem/dense.hpp"
#include "dem/energy.hpp"
#include "dem/model.hpp"

#include <span>
#include <vector>

namespace dem {

/// A contact as the step needs it.
struct ContactIndex {
    int a, b; ///< first row (x) of the points in the arrays of displacements and forces
    int law;  ///< index in the arrays of laws
    double nx, nz, area;
};

/// Shared by all lanes, made once per batch.
struct StepTables {
    struct BlockRow {
        int element, first_row, rows, first_mode, modes;
    };
    std::vector<BlockRow> blocks;
    std::vector<SharedMatrix> to_modes; ///< by element: forces at points -> modal forces
    std::vector<SharedMatrix>
        to_points;              ///< by element: modal velocities -> velocities of points
    std::vector<double> lambda; ///< by mode
    std::vector<ContactIndex> dry, cracks, tied;
    std::vector<int> support_rows; ///< rows (x) of the points of blocks held by the ground
    int beam_first_row = 0, beam_rows = 0, ground_row = 0;
    double vertical_load = 0.0; ///< on the base, self-weight included [N]
};

[[nodiscard]] StepTables step_tables(const Model& model);

template <class Real> struct WallState {
    std::vector<Real> q, v; ///< by mode: position and velocity (half a step behind) [sqrt(J)]
    std::vector<Real> last_force; ///< by mode, of the previous step
    std::vector<Real> inv_mass;   ///< by mode [1/step2]
    std::vector<Real> load;       ///< by mode: self-weight and vertical stress, full
    std::vector<Real> elasticity; ///< by mode: lambda of this wall's stone
    std::vector<Real> du;         ///< by row: displacement of the points in the last step [m]
    std::vector<Real> force;      ///< by row: contact forces on the points [N]
    std::vector<DryLaw<Real>> dry_laws, tied_laws;
    std::vector<CrackLaw<Real>> crack_laws;
    std::vector<DryState<Real>> dry, tied;
    std::vector<CrackState<Real>> cracks;
    Real work{0.0}, friction{0.0}, fracture{0.0}, damping{0.0}; ///< energy so far [J]
    Real top_force{0.0};  ///< of the drive on the beam [N]
    Real base_shear{0.0}; ///< of the wall on the ground [N]
};

/// Unloaded walls. Lanes without a wall of their own repeat the last one.
template <class Real>
[[nodiscard]] WallState<Real> unloaded(const Model& model, const StepTables& tables,
                                       std::span<const WallMaterials> walls,
                                       const SolverOptions& options);

/// Puts one wall, unloaded, into a lane.
template <class Real>
void load_lane(const Model& model, const StepTables& tables, const WallMaterials& wall,
               const SolverOptions& options, int lane, WallState<Real>& state);

/// Ledger of one lane, kinetic and elastic parts summed now.
template <class Real>
[[nodiscard]] Energy energy_of(const StepTables& tables, const WallState<Real>& state,
                               int lane);

} // namespace dem
