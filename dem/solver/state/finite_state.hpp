#pragma once
/// State of walls with finite displacements besides their WallState.

#include "dem/kinematics/block_frame.hpp"
#include "dem/scene/wall.hpp"
#include "dem/solver/state/finite_tables.hpp"

#include <vector>

namespace dem {

template <class Real> struct FiniteState {
    std::vector<BlockFrame<Real>>
        frames;               ///< by block, then the ground; empty: small displacements
    std::vector<Real> weight; ///< by block [N]
    std::vector<Real> sway;   ///< by mode: load of the weight acting to the right
    std::vector<Real>
        acting; ///< (sigma, tau) by contact, on the undeformed area: what blocks feel [Pa]
    /// State of a pair of faces, after the last step.
    struct Pair {
        Real gap{0.0}, widening{0.0};       ///< see Overlap [m]
        Real share{1.0};                    ///< of the undeformed area that overlaps [-]
        Real slip{0.0};                     ///< so far [m]
        Real past_far{0.0}, past_near{0.0}; ///< see Overlap [m]
        Real centre{0.5};                   ///< of pressure, along the overlap, 0 to 1
    };
    std::vector<Pair> pairs;
    std::vector<Pair> further; ///< of blocks that have slid there; share 0: not in contact
    std::vector<Real> further_u_n, further_tau; ///< by contact of `further`
    std::vector<Real>
        further_crushed; ///< the same: thickness [m]; empty where nothing can crush
    std::vector<Real> further_shear,
        further_rest;   ///< see ClosingState; empty where closure is linear
    Real vertical{0.0}; ///< load on the beam [N]
    /// Dashpots of walls that are shaken with damping of contacts, else empty. By run of dry
    /// contacts: stress of the dashpots over stiffness times displacement in a step [-]. By dry
    /// contact: their stresses (normal, tangential) [Pa].
    std::vector<Real> dashpots, dashed;
};

/// Frames at rest where the model has them.
/// @param crushes, closes whether any joint can
template <class Real>
[[nodiscard]] FiniteState<Real> undeformed(const FiniteTables& tables, int modes, int contacts,
                                           bool crushes, bool closes);

/// Loads of one wall into a lane that is at rest.
template <class Real>
void load_lane(const Model& model, const FiniteTables& tables, const WallMaterials& wall,
               int lane, FiniteState<Real>& state);

/// A lane back to the undeformed wall.
template <class Real>
void clear_lane(const FiniteTables& tables, int lane, FiniteState<Real>& state);

/// One wall from its own state into a lane.
template <class Real>
void copy_to_lane(const FiniteState<double>& wall, int lane, FiniteState<Real>& state);

} // namespace dem
