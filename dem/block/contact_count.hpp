#pragma once
/// How many contact points the joints of a scene get.

#include "dem/block/discretisation.hpp"
#include "dem/scene/layout.hpp"

#include <cstddef>

namespace dem {

/// Over all faces, those at the base and at the beam included. Costs nothing: no block is
/// meshed.
[[nodiscard]] std::size_t contact_count(const Layout& layout, const Discretisation& d);

/// Number of contact points on one face, which are as dense as on the face of a half unit.
[[nodiscard]] std::size_t contact_count(const Face& face, const Layout& layout,
                                        const Discretisation& d);

} // namespace dem
