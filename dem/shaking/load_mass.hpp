#pragma once

namespace dem {

/// Nature of the vertical load on the beam when the ground moves.
enum class LoadMass {
    none, ///< a force: a jack, a tendon, a strut
    floor ///< the weight of a mass that moves with the beam, at the point on which the load acts
};

} // namespace dem
