#pragma once
/// Protocols are scaled to what the wall can take: ISO 16670 by the mean ultimate displacement
/// of walls pushed one way.

#include "app/input/prepared_study.hpp"

namespace app {

/// Carries out `load.protocol_scale = one_way`: pushes the wall with mean values one way to
/// load.max_displacement, under each stress level, and puts the largest of the ultimate
/// displacements, to 0.01 mm, in the place of load.max_displacement: a study has one protocol,
/// and the wall under every stress is to come to its end in it. Where the force does not fall,
/// load.max_displacement counts. What it found stands in LoadInput::scaled.
/// @throws ConfigError if a push fails
void scale_protocol(PreparedStudy& ready);

} // namespace app
