#include "app/scene/scene_units.hpp"

#include "app/input/wall_geometry.hpp"
#include "dem/scene/touching.hpp"

#include <cstddef>
#include <string>

namespace app {
namespace {

std::string layer_of(const Study& study, int material)
{
    const auto at = static_cast<std::size_t>(material - 1);
    return material > 0 && at < study.geometry.layers.size() ? study.geometry.layers[at]
                                                             : "wall";
}

} // namespace

dem::Layout whole_units(const Study& study)
{
    Study uncracked = study;
    uncracked.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    uncracked.wall.cracks.where.clear();
    return layout_of(uncracked);
}

std::vector<DrawnBlock> scene_units(const Study& study, const dem::Layout& whole)
{
    std::vector<DrawnBlock> units;
    for (int b = 0; b < whole.beam; ++b) {
        const dem::Block& block = whole.blocks[b];
        units.push_back({dem::corners_of(block), layer_of(study, block.material), ""});
    }
    return units;
}

} // namespace app
