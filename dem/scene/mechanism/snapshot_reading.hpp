#pragma once
/// Numbers read off a snapshot: what a face carries, how far its joints have moved, what its
/// contacts have lost.

#include "dem/scene/geometry/snapshot.hpp"
#include "dem/scene/wall.hpp"

#include <optional>

namespace dem {

/// Compressive force over a face [N], >= 0, and the largest of all faces.
[[nodiscard]] double compression_of(const FaceState& face);
[[nodiscard]] double largest_compression(const Snapshot& wall);

/// Largest length of a displacement of the outlines [m].
[[nodiscard]] double largest_displacement(const Snapshot& wall);

/// Largest opening or slip of a contact [m].
[[nodiscard]] double largest_movement(const Snapshot& wall);

/// Whether a contact is closed and has slid. @param threshold of the opening and of the slip
/// [m]
[[nodiscard]] bool slides(const ContactState& contact, double threshold);

/// Largest slip of the contacts of joints that slide [m]; 0 if none does.
[[nodiscard]] double largest_slip(const Snapshot& wall, double threshold);

/// Whether all contacts of a face have D = 1; false without contacts.
[[nodiscard]] bool is_cracked_through(const FaceState& face);

/// Whether a contact has begun to crush.
[[nodiscard]] bool any_crushed(const Snapshot& wall);

/// Largest compression in the lowest joints that can open [Pa]: those on the ground, or above a
/// first course that is fixed. Nothing without such a joint.
[[nodiscard]] std::optional<double> toe_stress(const Snapshot& wall, Base base);

/// A joint whose contacts have slid far. Small displacements leave it the contact that it was
/// built with.
struct SlidJoint {
    double length = 0.0, slip = 0.0; ///< [m]
};
/// The joint that slid furthest among the compressed joints that have slid further than this
/// share of their length.
[[nodiscard]] std::optional<SlidJoint> slid_joint(const Snapshot& wall, double share);

/// Largest slip of the loading beam on the wall [m]; 0 where it does not lie on a joint.
[[nodiscard]] double beam_slip(const Snapshot& wall);

/// Share of the strength of a potential crack that a contact uses, in tension or in shear [-],
/// >= 0.
[[nodiscard]] double strength_used(const ContactState& contact, const CrackMaterial& strength);

} // namespace dem
