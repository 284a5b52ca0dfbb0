#pragma once
/// uq.drawn: one wall of a study, written down so that it can be pushed again with the same
/// bits.

#include "app/input/prepared_study.hpp"
#include "app/sampling/wall_draw.hpp"

#include <string>

namespace app {

struct LoadInput;
struct RandomInput;

/// Index of the level of this stress: "0.4 MPa".
/// @throws BadValue (app/input/study/units.hpp)
[[nodiscard]] int level_at(const LoadInput& load, std::string_view text);

/// "0.4 MPa; joint.friction_angle = 25.82 deg; ...": the stress and every value drawn, one for
/// the wall or one for each joint or crack. A wall without values is that of the means: "0.4
/// MPa; mean".
[[nodiscard]] std::string drawn_text(const LoadInput& load,
                                     const std::vector<RandomInput>& random,
                                     const WantedWall& wall);

/// The wall that study.uq.drawn names.
/// @throws ConfigError about uq.drawn
[[nodiscard]] WantedWall drawn_wall(const PreparedStudy& ready);

/// The study with this wall written into it.
[[nodiscard]] Study with_drawn(Study study, const WantedWall& wall);

} // namespace app
