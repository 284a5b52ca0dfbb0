#pragma once
/// The paper's own numerical scheme, as the baseline of speed claims: one wall at a time, all
/// zones, the motion of every node from Eq. 1 with local damping, constant speed of the drive.
///
/// The degrees of freedom of a block are the displacements of its contact points, with the
/// zones condensed onto them: K u is dense per block. The paper's code also integrates the
/// nodes between; the baseline is spared them. Nodal masses are scaled, as usual for static
/// solutions: with a unit time step a mass of a quarter of the absolute row sum of the
/// stiffness is stable (Gershgorin's bound on the highest frequency; Underwood 1983, Dynamic
/// relaxation, in: Computational Methods for Transient Analysis; Papadrakakis 1981, Comput.
/// Methods Appl. Mech. Eng. 25:35),
///   m_i = (1 + gamma)/f^2 (sum_j |K_ij| + 2 sum_contacts k)/4.
/// The bound is close: the paper's wall at 0.50 MPa is unstable at f = 1.2. The loading beam
/// stays in its modes, as in dem/solver/step/step.hpp: its motion is prescribed along its load
/// line.

#include "dem/block/model.hpp"
#include "dem/scene/wall.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <vector>

namespace bench {

struct NodalOptions {
    double steps_per_mm = 20000; ///< of the load line's way [1/mm], > 0
    dem::Damping damping = dem::Damping::local;
    double damping_factor = 0.8;     ///< gamma of Eq. 1 [-], in [0, 1)
    double step_fraction = 0.95;     ///< f, of the stable step [-], in (0, 1]
    long long preload_steps = 20000; ///< at most, for the vertical load; a quarter to apply it
    double preload_unbalance = 1e-4; ///< unbalanced / acting force that ends the preload [-]
    double max_displacement = 0.03;  ///< of the load line [m], > 0
    double record_every = 5e-5;      ///< way between curve points [m], > 0
};

struct NodalPoint {
    double displacement = 0.0; ///< of the load line, middle of the interval [m]
    double force = 0.0;        ///< horizontal load, mean over the interval [N]
};

struct NodalPush {
    dem::Outcome outcome = dem::Outcome::reached_target; ///< or not_finite: unstable, cut there
    std::vector<NodalPoint> curve;
    double preload_unbalance = 1.0; ///< reached under the vertical load alone [-]
    long long preload_steps = 0;    ///< taken
    dem::RunCost cost;              ///< preload included
};

/// Coupled law (Table 2).
/// @param model with all modes of its blocks (Discretisation::block_modes = 0)
/// @throws std::invalid_argument if it has fewer, if the materials do not fit it, or an option
/// is outside its range
[[nodiscard]] NodalPush push_nodes(const dem::Model& model, const dem::WallMaterials& materials,
                                   const NodalOptions& options = {});

/// Largest force of the curve [N].
[[nodiscard]] double peak_force(const NodalPush& push);

} // namespace bench
