#pragma once
/// Cost of the blocks of a scene before the first step: a wall of few but finely resolved
/// blocks can take minutes.

#include "dem/block/discretisation.hpp"
#include "dem/scene/layout.hpp"

namespace dem {

/// Cost on one core of about 3 GHz, within a factor of about three
/// (tests/dem/block/test_build_cost.cpp has the measurements).
struct BuildCost {
    double seconds = 0.0;
    double bytes = 0.0; ///< at most at a time
    bool beam = false;  ///< it is the loading beam that takes them
};

/// Estimate of what discretise() takes. Costs next to nothing: no block is meshed.
[[nodiscard]] BuildCost build_cost(const Layout& layout, const Discretisation& d);

} // namespace dem
