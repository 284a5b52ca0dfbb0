#pragma once
/// Laws of the walls of a batch: one array per quantity, one lane per wall.

#include "dem/contact/closure.hpp"
#include "dem/contact/contact_law.hpp"
#include "dem/contact/crushing.hpp"
#include "dem/contact/mixed_crack.hpp"
#include "dem/contact/wear.hpp"
#include "dem/scene/wall.hpp"
#include "dem/solver/state/solver_options.hpp"
#include "dem/solver/state/step_tables.hpp"

#include <vector>

namespace dem {

/// The materials of walls. They are set when a wall takes its lane and only read while the wall
/// is pushed, but for the fictitious masses of walls whose joints close (closing_joint.hpp).
/// The paper's wall: 4600 numbers, 37 kB per lane.
template <class Real> struct LaneLaws {
    std::vector<Real> inv_mass; ///< by mode: 1 / fictitious mass [1/step2]
    std::vector<Real> load;     ///< by mode: self-weight and vertical stress in full [sqrt(J)]
    std::vector<Real> elasticity; ///< by mode: lambda of this wall's stone [-]
    /// Loads of walls under body forces, else empty. By mode: self-weight, and the same acting
    /// to the right [sqrt(J)].
    std::vector<Real> weight, sway;
    Real whole_weight{0.0}, supported_weight{0.0}; ///< of all blocks, of those on supports [N]
    std::vector<DryLaw<Real>> dry;      ///< by joint ID - 1, then the joints at base and beam
    std::vector<DryLaw<Real>> tied;     ///< one, of the beam
    std::vector<CrackLaw<Real>> cracks; ///< by crack ID - 1
    std::vector<MixedLaw<Real>>
        mixed; ///< as cracks; empty where they follow the law of the paper
    std::vector<CrushingLaw<Real>> dry_crushing,
        crack_crushing;                                ///< as dry and cracks; or empty
    std::vector<WearLaw<Real>> dry_wear;               ///< as dry; or empty
    std::vector<ClosureLaw<Real>> closing;             ///< as dry; or empty
    Real inv_reference_kn{0.0}, inv_reference_ks{0.0}; ///< of joints that close [m/Pa]
    /// By block: largest stiffness of its contacts over the reference for which its masses make
    /// the step stable [-].
    std::vector<Real> ratio;
    Closure closure = Closure::linear;
    bool loses = false;                      ///< whether closing loses energy in any lane
    Unloading unloading = Unloading::secant; ///< of the cracks of all lanes
};

/// The law of a potential crack, or of the bond of a joint with mortar.
[[nodiscard]] CrackLaw<double> crack_law(const CrackMaterial& material);
/// Further constants of a crack that follows the law of mixed modes.
[[nodiscard]] MixedLaw<double> mixed_law(const CrackMaterial& material);

/// By block: the largest ratio of the stiffness of its contacts to the reference stiffness [-].
[[nodiscard]] std::vector<double> stiffness_ratio(const Model& model,
                                                  const WallMaterials& wall);

/// Laws of a model, of no wall yet; set_laws() fills the lanes.
template <class Real>
[[nodiscard]] LaneLaws<Real> empty_laws(const Model& model, const StepTables& tables);

/// Writes what one wall is made of into a lane.
template <class Real>
void set_laws(const Model& model, const StepTables& tables, const WallMaterials& wall,
              const SolverOptions& options, int lane, LaneLaws<Real>& laws);

} // namespace dem
