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

bool openings_make_slivers(Masonry masonry, const StudyFile& source, double smallest)
{
    if (masonry.wall.openings.empty()) return false;
    masonry.wall.openings.clear();
    return !has_slivers(laid_units(masonry, source), smallest);
}

bool cracks_make_slivers(const Masonry& masonry, const StudyFile& source, double smallest)
{
    const dem::Layout whole = whole_units(masonry, source);
    return std::ranges::none_of(whole.blocks, [&](const dem::Block& b) {
        return std::min(b.x1 - b.x0, b.z1 - b.z0) < smallest;
    });
}

} // namespace app
