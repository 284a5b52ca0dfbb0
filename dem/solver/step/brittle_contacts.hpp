#pragma once
/// Contacts whose law cannot lose its energy gradually: the fracture energy is less than what
/// they store when their strength is reached, so that they break at once and release more than
/// they should.

namespace dem {

struct Model;
struct WallMaterials;

/// Cracks and mortar with f_T > sqrt(2 G k_n).
[[nodiscard]] int snap_back_contacts(const Model& model, const WallMaterials& wall);

/// Cracks and mortar that would soften in shear, with c - c_res > sqrt(2 G_II k_s): without
/// pressure they break at their first slip.
[[nodiscard]] int shear_snap_back_contacts(const Model& model, const WallMaterials& wall);

/// The same under compression, of all contacts that can crush.
[[nodiscard]] int brittle_crushing_contacts(const Model& model, const WallMaterials& wall);

} // namespace dem
