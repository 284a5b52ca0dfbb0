#include "app/sampling/wall_sites.hpp"

namespace app {
namespace {

std::vector<uq::Site> sites(const dem::Layout& layout, bool cracks, int count)
{
    std::vector<uq::Site> all(static_cast<std::size_t>(count));
    for (const dem::Face& f : layout.faces) {
        if (f.id == 0 || (f.kind == dem::FaceKind::unit_crack) != cracks) continue;
        const dem::Block& below = layout.blocks[static_cast<std::size_t>(f.a)];
        all[static_cast<std::size_t>(f.id - 1)] = {
            0.5 * (f.from.x + f.to.x), 0.5 * (f.from.z + f.to.z), below.unit, below.course};
    }
    return all;
}

} // namespace

std::vector<uq::Site> joint_sites(const dem::Layout& layout)
{
    return sites(layout, false, layout.n_joints);
}

std::vector<uq::Site> crack_sites(const dem::Layout& layout)
{
    return sites(layout, true, layout.n_cracks);
}

} // namespace app
