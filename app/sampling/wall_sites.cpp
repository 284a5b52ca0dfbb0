#include "app/sampling/wall_sites.hpp"

#include <cmath>

namespace app {
namespace {

std::vector<uq::Site> sites(const dem::Layout& layout, bool cracks, int count)
{
    std::vector<uq::Site> all(count);
    std::vector<double> length(all.size(), 0.0);
    for (const dem::Face& f : layout.faces) {
        if (f.id == 0 || (f.kind == dem::FaceKind::unit_crack) != cracks) continue;
        const dem::Block& below = layout.blocks[f.a];
        const int at = f.id - 1;
        const double more = std::hypot(f.to.x - f.from.x, f.to.z - f.from.z);
        const double share = more / (length[at] + more); // 1 where a joint is one face
        uq::Site& site = all[at];
        site.unit = below.unit;
        site.course = below.course;
        site.x += share * (0.5 * (f.from.x + f.to.x) - site.x);
        site.z += share * (0.5 * (f.from.z + f.to.z) - site.z);
        length[at] += more;
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
