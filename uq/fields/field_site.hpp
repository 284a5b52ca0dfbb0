#pragma once
/// A place that carries one value of a random field: a joint, or a potential crack in a unit.

namespace uq {

struct Site {
    double x = 0.0, z = 0.0; ///< centre [m], finite
    int unit = 0;            ///< the stone it belongs to
    int course = 0;          ///< the course it belongs to
};

} // namespace uq
