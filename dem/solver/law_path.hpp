#pragma once
/// One contact that is moved by hand: what its law answers. For pictures of laws.

#include "dem/contact/contact_options.hpp"
#include "dem/scene/wall.hpp"

#include <span>
#include <vector>

namespace dem {

/// A move of a contact [m]; opening is positive.
struct LawMove {
    double du_n = 0.0, du_s = 0.0;
};

/// A contact after a move. Tension is positive.
struct LawPoint {
    double u_n = 0.0, u_s = 0.0;   ///< opening and slip, elastic parts included [m]
    double sigma = 0.0, tau = 0.0; ///< [Pa]
    double damage = 0.0;           ///< D of a crack [-]; 0 of a dry joint
};

/// Laws that the cracks of a wall follow.
struct CrackLaws {
    bool mixed_mode = false; ///< Layout::mixed_mode
    ContactLaw law = ContactLaw::coupled;
    Unloading unloading = Unloading::secant;
};

/// A crack, or the bond of a joint with mortar, from the intact state; without crushing.
/// @return the start and one point per move
[[nodiscard]] std::vector<LawPoint>
crack_path(const CrackMaterial& crack, const CrackLaws& laws, std::span<const LawMove> moves);

/// A dry joint that has not closed yet; without crushing and wear.
/// @return the start and one point per move
[[nodiscard]] std::vector<LawPoint> joint_path(const JointMaterial& joint, Closure closure,
                                               std::span<const LawMove> moves);

} // namespace dem
