#include "dem/solver/step/vertical_load.hpp"

#include "dem/block/model.hpp"

#include <algorithm>

namespace dem {

double vertical_load(const Model& m, const WallMaterials& w)
{
    double force = w.vertical_stress.value_or(m.loads.vertical_stress) * m.layout.length *
                   m.layout.thickness;
    for (int b = 0; b < static_cast<int>(m.layout.blocks.size()); ++b) {
        const double volume = area_of(m.layout.blocks[b]) * m.layout.thickness;
        force += volume * stone_of(m, b, m.stone).density * m.loads.gravity;
    }
    return force;
}

double sideways_force(const Model& m, const WallMaterials& w)
{
    return vertical_load(m, w) * std::min(1.0, m.layout.length / (2.0 * m.loads.height));
}

} // namespace dem
