#pragma once
/// Loads that press on the base of a wall.

namespace dem {

struct Model;         // dem/block/model.hpp
struct WallMaterials; // dem/scene/wall.hpp

/// On the base [N]: vertical load and self-weight, of the stone with the model's density.
[[nodiscard]] double vertical_load(const Model& model, const WallMaterials& wall);

/// Size of the force that a wall can carry sideways [N]: N l / (2 h), which is that of a rigid
/// block, and N at most.
[[nodiscard]] double sideways_force(const Model& model, const WallMaterials& wall);

} // namespace dem
