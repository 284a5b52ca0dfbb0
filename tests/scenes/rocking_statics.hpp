#pragma once
/// A rigid block that rocks on a dry joint, in balance at every moment: no masses, no damping,
/// no speed. What its loops lose is friction and belongs to the wall; what a push loses beyond
/// it belongs to the solver.

#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"

#include <vector>

namespace scenes {

struct RockingBlock {
    std::vector<double> x, area;   ///< points of its base, from the middle [m], [m2]
    double kn = 0.0, ks = 0.0;     ///< [Pa/m]
    double tan_phi = 0.0;          ///< [-]
    double load = 0.0;             ///< vertical, with its weight, in the middle [N]
    double height = 0.0;           ///< of the drive [m]
    double drive_compliance = 0.0; ///< of what lies between block and drive [m/N]
};

/// A rigid monolith() as it was pushed, with a toe that is free. Its beam is bonded to it.
[[nodiscard]] RockingBlock in_balance(const Scene& monolith,
                                      const dem::WallMaterials& materials,
                                      const dem::Snapshot& pushed);

struct RockingLoop {
    double energy = 0.0, friction = 0.0; ///< of one cycle [J]
    double force = 0.0;                  ///< largest [N]
};

/// The second of two cycles to the right and to the left. Each step solves
///   sum sigma A = -P,   V H = -sum sigma A x,   V = sum tau A,   u + H theta + c V = d
/// with sigma = min(0, kn u_n) and tau = tau + ks du, at most tan_phi |sigma|.
/// @param amplitude of the drive [m]
/// @throws std::runtime_error if a step finds no balance
[[nodiscard]] RockingLoop rocking_loop(const RockingBlock& block, double amplitude);

} // namespace scenes
