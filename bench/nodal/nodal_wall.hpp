#pragma once
/// A wall for the nodal scheme: stiffness, loads and scaled masses of its nodes, its contacts,
/// and where they are.

#include "dem/block/model.hpp"
#include "dem/contact/contact_law.hpp"
#include "dem/scene/wall.hpp"

#include <Eigen/Dense>

#include <vector>

namespace bench {

/// Rows (x) of the two points of a contact, its law and its state.
template <class Law, class State> struct Link {
    int a = 0, b = 0;
    double nx = 0.0, nz = 0.0; ///< unit normal from a to b; the tangent is (nz, -nx)
    double area = 0.0;         ///< [m2]
    Law law;
    State state;
};
using DryLink = Link<dem::DryLaw<double>, dem::DryState<double>>;
using CrackLink = Link<dem::CrackLaw<double>, dem::CrackState<double>>;

/// A stone block's share of the rows.
struct BlockRows {
    int element = 0; ///< index in NodalWall::stiffness
    int first = 0, count = 0;
};

/// The loading beam stays in its modes: along its load line the motion is prescribed.
struct ModalBeam {
    Eigen::MatrixXd phi; ///< rows of its points x modes
    Eigen::VectorXd lambda, load, inv_mass, q, v, last_force;
    int first = 0; ///< row
};

/// Rows: x and z of each contact point in turn; those of the stone come first, then the beam's
/// and the ground's. Velocities are displacements per step.
struct NodalWall {
    std::vector<BlockRows> blocks;
    std::vector<Eigen::MatrixXd> stiffness; ///< by element [N/m]; zero where a support holds
    std::vector<double> load;               ///< of the stone: self-weight [N]
    std::vector<double> inv_mass;           ///< of the stone [step2/kg]; 0: held
    std::vector<double> u, last_force;      ///< of the stone [m] [N]
    std::vector<double> v;                  ///< of all rows
    std::vector<double> force;              ///< of the contacts on all rows [N]
    std::vector<DryLink> dry, tied;
    std::vector<CrackLink> cracks;
    ModalBeam beam;
};

/// @param materials as many joints and cracks as the model has
/// @param mass_factor on the smallest masses that are stable, >= 1
/// @throws std::invalid_argument if the model leaves out modes of its blocks, or the materials
/// do not fit it
[[nodiscard]] NodalWall unloaded_nodes(const dem::Model& model,
                                       const dem::WallMaterials& materials, double mass_factor);

} // namespace bench
