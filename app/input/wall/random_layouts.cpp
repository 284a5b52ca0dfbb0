#include "app/input/wall/random_layouts.hpp"

#include "app/input/study/study.hpp"

#include <algorithm>

namespace app {
namespace {

constexpr double kMostSeed = 1e9; // of the range of wall.seed

} // namespace

bool has_layouts(const GeometryInput& geometry) { return geometry.layouts > 1; }

bool is_random(const GeometryInput& geometry, const std::vector<RandomInput>& random)
{
    return !random.empty() || has_layouts(geometry);
}

std::uint32_t layout_seed(const Masonry& masonry, std::uint32_t sample)
{
    return masonry.wall.seed + sample % static_cast<std::uint32_t>(masonry.geometry.layouts);
}

void check_layouts(const Masonry& masonry, const UqInput& uq, const StudyFile& source)
{
    if (!has_layouts(masonry.geometry)) return;
    const GeometryInput& g = masonry.geometry;
    if (masonry.wall.seed + static_cast<double>(g.layouts) - 1.0 > kMostSeed)
        throw error_at(source, "wall.layouts",
                       "wall.seed + wall.layouts would pass 1e9; write a smaller wall.seed");
    if (uq.spatial != Spatial::none)
        throw error_at(source, "uq.spatial",
                       "joints of two layouts have nothing in common; write none, or "
                       "wall.layouts = 1");
    if (masonry.cracks.where == "needed")
        throw error_at(source, "unit.cracks_where",
                       "needed is found for one layout; write toe or a region, or "
                       "wall.layouts = 1");
}

void refuse_layouts(const GeometryInput& geometry, const StudyFile& source)
{
    if (has_layouts(geometry))
        throw error_at(source, "wall.layouts", "only the verb study draws layouts; write 1");
}

} // namespace app
