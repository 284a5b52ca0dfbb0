#pragma once
/// Rules that tie the keys of joints and cracks to each other, and remarks on the laws that
/// they choose.

#include "dem/scene/wall.hpp"

#include <string>

namespace app {

struct JointInput;
struct LoadInput;
struct Masonry;
struct Parameters;
struct StudyFile;

/// Joint stiffness: where it comes from, and one value per stress level. Before defaults are
/// derived from it.
/// @throws ConfigError at the value to change
void check_stiffness(const Masonry& masonry, const LoadInput& load, const StudyFile& source);

/// The stiffness that joints which close have under the stress of each wall, once every value
/// is known.
/// @throws ConfigError at the value to change
void check_closed_stiffness(const JointInput& joint, const LoadInput& load,
                            const StudyFile& source);

/// In the law of mixed modes tension and shear share one damage, whose contacts unload to the
/// origin.
/// @throws ConfigError at the value to change
void check_mixed_modes(const Masonry& masonry, const dem::SolverOptions& solver,
                       const StudyFile& source);

/// Whether the law of closure is fitted to wall moduli.
[[nodiscard]] bool is_fitted_closure(const JointInput& joint);

/// "-0.55, +0.47 %": stiffness by the fitted law of closure, relative to that of each wall
/// modulus.
[[nodiscard]] std::string fit_residuals(const Masonry& masonry);

/// Lines for people: the fitted law of closure, and the tensile strength that friction takes
/// from Coulomb's envelope at mean values; empty if there is neither.
[[nodiscard]] std::string joint_law_notes(const Masonry& masonry, const StudyFile& source);

} // namespace app
