#include "app/input/wall/slivers.hpp"

#include "app/input/study/study.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

bool has_slivers(const dem::Layout& layout, double smallest)
{
    const auto length = [](const dem::Face& f) {
        return std::hypot(f.to.x - f.from.x, f.to.z - f.from.z);
    };
    return std::ranges::any_of(layout.blocks,
                               [&](const dem::Block& b) { return b.x1 - b.x0 < smallest; }) ||
           std::ranges::any_of(layout.faces,
                               [&](const dem::Face& f) { return length(f) < smallest; });
}

} // namespace

bool openings_make_slivers(Study study, double smallest)
{
    if (study.wall.openings.empty()) return false;
    study.wall.openings.clear();
    return !has_slivers(layout_of(study), smallest);
}

bool cracks_make_slivers(const Study& study, double smallest)
{
    const dem::Layout whole = whole_units(study);
    return std::ranges::none_of(whole.blocks, [&](const dem::Block& b) {
        return std::min(b.x1 - b.x0, b.z1 - b.z0) < smallest;
    });
}

} // namespace app
