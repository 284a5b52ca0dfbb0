#include "dem/block/mesh.hpp"

#include <stdexcept>

namespace dem {

Mesh triangle_mesh(std::span<const Point>, double)
{
    throw std::invalid_argument(
        "this library has rectangular blocks alone: it was built with DRYSTONE_POLYGONS off");
}

} // namespace dem
