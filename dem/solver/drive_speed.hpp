#pragma once
/// How fast a wall may be pushed so that it can follow.

#include "dem/solver/solver_options.hpp"

namespace dem {

struct Model;         // dem/block/model.hpp
struct WallMaterials; // dem/scene/wall.hpp

/// Steps per displacement of the drive at full speed [1/mm]: those of the options, or in proportion more for a
/// wall that is stiff for the force that it can carry. A wave passes about one course in a step, and a wall that reaches
/// its strength within few such passages carries inertia and damping besides: the explicit solver then gives
/// forces above the rigid limit. So the elastic displacement
///   u = F (h^3 / (3 E I) + 1.2 h / (G A)),   F = (N + W) l / (2 h)
/// takes at least 60 steps for each course at the default speed. The walls of the paper take 1000 and more in all and are not
/// slowed.
[[nodiscard]] double steps_per_mm_of(const Model& model, const WallMaterials& wall,
                                     const SolverOptions& options);

/// On the base [N]: vertical load and self-weight, of the stone with the model's density.
[[nodiscard]] double vertical_load(const Model& model, const WallMaterials& wall);

/// By which the unbalance of a push is measured [N]: the vertical load, or as much less as a wall more
/// slender than 0.9 carries sideways, since its error is a larger share of what it carries.
[[nodiscard]] double unbalance_measure(const Model& model, const WallMaterials& wall);

} // namespace dem
