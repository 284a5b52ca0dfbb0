#include "app/scene/scene_units.hpp"

#include "app/input/study/study.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace app {
namespace {

/// Name of the layer of blocks without a layer: "wall", unless the drawing means another stone
/// by that.
std::string own_layer(const GeometryInput& geometry)
{
    const bool taken = std::ranges::find(geometry.layers, "wall") != geometry.layers.end();
    return taken ? "" : "wall";
}

std::string layer_of(const GeometryInput& g, const dem::Block& block)
{
    const auto layer = static_cast<std::size_t>(block.layer - 1),
               material = static_cast<std::size_t>(block.material - 1);
    if (block.layer > 0) return g.drawn_layers.at(layer);
    return block.material > 0 ? g.layers.at(material) : own_layer(g);
}

} // namespace

std::vector<DrawnBlock> scene_units(const GeometryInput& geometry, const dem::Layout& whole)
{
    std::vector<DrawnBlock> units;
    for (int b = 0; b < whole.beam; ++b) {
        const dem::Block& block = whole.blocks[b];
        units.push_back({dem::corners_of(block), layer_of(geometry, block)});
    }
    return units;
}

} // namespace app
