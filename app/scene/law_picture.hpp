#pragma once
/// Picture of the laws that the contacts of a wall follow, each drawn by moving one contact.

#include "app/input/study/parameters.hpp"
#include "dem/scene/layout.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <string>

namespace app {

/// SVG: for the cracks in units, and for the joints between units, normal stress over opening,
/// shear stress over slip under some pressures, and the strength before and after; without
/// crushing and wear. Counterpart of Figures 3 and 4 of the paper.
/// @param p mean values
/// @param course_height h of Eq. 2 [m]
/// @param level whose joints are drawn
[[nodiscard]] std::string law_picture(const Parameters& p, double course_height,
                                      StressLevel level, const dem::Layout& layout,
                                      const dem::SolverOptions& solver);

} // namespace app
