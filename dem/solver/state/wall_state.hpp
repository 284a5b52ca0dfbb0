#pragma once
/// Where the walls of a batch are and what they are made of: one array per quantity, one lane
/// per wall.

#include "dem/solver/state/energy.hpp"
#include "dem/solver/state/finite_state.hpp"
#include "dem/solver/state/lane_laws.hpp"

#include <span>
#include <vector>

namespace dem {

/// WallState::borne of masses that are not known to be enough even without pressure [Pa].
constexpr double kNothingBorne = -1.0;

/// Where walls are. A step reads and writes all of it.
/// The paper's wall: 9200 numbers, 74 kB per lane.
template <class Real> struct WallState {
    std::vector<Real> q, v; ///< by mode: position and velocity (half a step behind) [sqrt(J)]
    std::vector<Real> last_force;  ///< by mode: modal force of the previous step [sqrt(J)]
    std::vector<Real> block_force; ///< modal forces of the block at hand [sqrt(J)]
    std::vector<Real> du;          ///< (normal, tangential) by contact; zero between steps [m]
    std::vector<Real> stress;      ///< (sigma, tau) by contact [Pa]
    std::vector<Real> u_n;         ///< by contact: opening, without what is crushed [m]
    /// Values that a crack remembers besides (see CrackState).
    struct Memory {
        Real u_max, bond, unloading, integrity;
    };
    std::vector<Memory> cracks; ///< by crack contact
    std::vector<Real> crushed;  ///< by contact: thickness [m]; empty where nothing can crush
    std::vector<Real>
        roughness; ///< by dry contact: asperities left, 1 to 0; empty where nothing can wear
    /// By dry contact, see ClosingState; empty where closure is linear.
    std::vector<Real> shear, rest;
    /// By run of dry contacts: pressure for which the masses of its blocks are known to be
    /// enough [Pa]; or empty.
    std::vector<Real> borne;
    Real work{0.0}, friction{0.0}, fracture{0.0}, crushing{0.0},
        damping{0.0};  ///< energy so far [J]
    Real closing{0.0}; ///< of the friction, what joints lose as they close [J]
    /// Crack contacts that have ever lost a part of their strength but not all of it: in
    /// tension, in shear.
    Real softened_in_tension{0.0}, softened_in_shear{0.0};
    Real top_force{0.0};   ///< of the drive on the beam [N]
    Real base_shear{0.0};  ///< of the wall on the ground [N]
    Real load_x{0.0};      ///< horizontal part of the loads, beside the drive [N]
    Real body_factor{0.0}; ///< body force over weight [-]
    /// By mode: forces, vertical loads, and what a body force of the weight does [sqrt(J)]; of
    /// body forces, else empty.
    std::vector<Real> total, loaded, pull;
    FiniteState<Real> finite; ///< empty where displacements are small
    LaneLaws<Real> laws;
};

/// A state with every lane empty; load_lane() fills the lanes.
template <class Real>
[[nodiscard]] WallState<Real> empty_lanes(const Model& model, const StepTables& tables,
                                          Kinematics kinematics = Kinematics::small);

/// Puts a lane to rest at zero: it has no wall, or is about to get one.
template <class Real>
void clear_lane(const StepTables& tables, int lane, WallState<Real>& state);

/// Puts one wall, unloaded, into a lane.
template <class Real>
void load_lane(const Model& model, const StepTables& tables, const WallMaterials& wall,
               const SolverOptions& options, int lane, WallState<Real>& state);

/// Unloaded walls. Lanes without a wall of their own repeat the last one.
template <class Real>
[[nodiscard]] WallState<Real> unloaded(const Model& model, const StepTables& tables,
                                       std::span<const WallMaterials> walls,
                                       const SolverOptions& options);

/// The energy balance of one lane, with its kinetic and elastic parts as they are now.
template <class Real>
[[nodiscard]] Energy energy_of(const StepTables& tables, const WallState<Real>& state,
                               int lane);

template <class Real>
void set_contact(WallState<Real>& s, int k, Real u_n, Real sigma, Real tau)
{
    s.u_n[k] = u_n;
    s.stress[2 * k] = sigma;
    s.stress[2 * k + 1] = tau;
}

/// Crushes a contact as far as its relative displacement in this step makes it, and gives what
/// is left of that to its law. A crack that has begun to crush has no bond left.
/// @param area over which the energy counts [m2]
template <class Real>
[[nodiscard]] Real crush(const CrushingLaw<Real>& law, int k, Real du_n, Real area,
                         WallState<Real>& s)
{
    const Real u_e = s.u_n[k] + du_n, by = crushed_by(law, s.crushed[k], u_e);
    if (!any(by > Real(0.0))) return du_n;
    const Real after = Real(0.0) - law.kn * (u_e + by);
    const Real mean = Real(0.5) * (after - s.stress[2 * k]);
    s.crushing = multiply_add(area, select(by > Real(0.0), mean * by, Real(0.0)), s.crushing);
    s.crushed[k] += by;
    return du_n + by;
}

/// Law of a dry contact as worn as it is.
template <class Real>
[[nodiscard]] DryLaw<Real> worn_law(const WallState<Real>& s, int law, int k)
{
    DryLaw<Real> worn = s.laws.dry[law];
    worn.tan_phi = worn_tan_phi(s.laws.dry_wear[law], worn.tan_phi, s.roughness[k]);
    return worn;
}

/// State of one crack contact. @param contact its number, from StepTables::first_crack on
template <class Real>
[[nodiscard]] inline CrackState<Real> crack_state(const StepTables& t, const WallState<Real>& s,
                                                  int contact)
{
    const auto& memory = s.cracks[contact - t.first_crack];
    return {s.u_n[contact], s.stress[2 * contact + 1], s.stress[2 * contact], memory.u_max,
            memory.bond,    memory.unloading,          memory.integrity};
}

} // namespace dem
