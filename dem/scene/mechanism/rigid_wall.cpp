#include "dem/scene/mechanism/rigid_wall.hpp"

#include "dem/scene/bond.hpp"

#include <algorithm>
#include <limits>

namespace dem {

Weights weights_of(const Layout& layout, const Elastic& stone, const Elastic& beam,
                   double gravity)
{
    Weights w;
    for (int k = 0; k < static_cast<int>(layout.blocks.size()); ++k) {
        const Block& block = layout.blocks[k];
        const double area = area_of(block);
        const double weight =
            stone_of(layout, k, stone, beam).density * gravity * area * layout.thickness;
        if (k == layout.beam) {
            w.beam += weight;
            continue;
        }
        w.area += area;
        w.masonry += weight;
        if (block.motion == Motion::free) w.free += weight;
    }
    return w;
}

double gravity_height(const Layout& layout, const Elastic& stone, const Elastic& beam)
{
    double mass = 0.0, moment = 0.0; // per thickness [kg/m] [kg]
    for (int k = 0; k < static_cast<int>(layout.blocks.size()); ++k) {
        const Block& block = layout.blocks[k];
        const double own = stone_of(layout, k, stone, beam).density * area_of(block);
        mass += own;
        moment += own * centre_of(block).z;
    }
    return mass > 0.0 ? moment / mass : 0.0;
}

RigidWall rigid_wall(const WallGeometry& g, const Beam& b, const Elastic& stone,
                     const Loads& loads, const WallFriction& tan_phi, double weight)
{
    const bool fixed_base = g.base == Base::fixed;
    const double floor = fixed_base ? top_of_course(g, 1) : 0.0; // of what may move [m]
    const double top = top_of_course(g, g.courses), height = top - floor;
    const double per_height = stone.density * loads.gravity * g.length * g.thickness; // [N/m]
    const double top_course = per_height * (top - top_of_course(g, g.courses - 1));
    const double beam =
        b.present ? b.material.density * loads.gravity * g.length * g.thickness * b.height
                  : 0.0;
    RigidWall w;
    w.turning = g.courses - (fixed_base ? 1 : 0);
    w.vertical_load = loads.vertical_stress * g.length * g.thickness + beam;
    w.weight = per_height * height;
    const double restoring = (w.vertical_load + w.weight) * 0.5 * g.length; // [N m]
    const double moving = w.weight + beam; // what body forces push above the floor
    if (loads.pattern == LoadPattern::body && moving > 0.0) {
        const double turned = 0.5 * w.weight * height + beam * (height + 0.5 * b.height);
        w.rocking_limit = restoring / turned * weight;
        w.sliding_limit = (fixed_base ? tan_phi.joints : tan_phi.base) *
                          (w.vertical_load + w.weight) / moving * weight;
    } else {
        w.rocking_limit = restoring / (loads.height - floor);
        w.sliding_limit = std::numeric_limits<double>::infinity();
        if (g.courses > 1) w.sliding_limit = tan_phi.joints * (w.vertical_load + top_course);
        if (!fixed_base && g.toe == Toe::free)
            w.sliding_limit =
                std::min(w.sliding_limit, tan_phi.base * (w.vertical_load + w.weight));
        if (b.interface == BeamInterface::joint)
            w.sliding_limit = std::min(w.sliding_limit, tan_phi.beam * w.vertical_load);
    }
    return w;
}

} // namespace dem
