#include "app/sampling/wall_sites.hpp"

#include <cmath>

namespace app {
namespace {

std::vector<JointPlace> face_places(const dem::Layout& layout, bool cracks, int count)
{
    std::vector<JointPlace> all(count);
    for (const dem::Face& f : layout.faces) {
        if (f.id == 0 || (f.kind == dem::FaceKind::unit_crack) != cracks) continue;
        const dem::Block& below = layout.blocks[f.a];
        JointPlace& place = all[f.id - 1];
        const double more = std::hypot(f.to.x - f.from.x, f.to.z - f.from.z);
        const double share = more / (place.length + more); // 1 where a joint is one face
        place.kind = f.kind;
        place.site.unit = below.unit;
        place.site.course = below.course;
        place.site.x += share * (0.5 * (f.from.x + f.to.x) - place.site.x);
        place.site.z += share * (0.5 * (f.from.z + f.to.z) - place.site.z);
        place.length += more;
    }
    return all;
}

std::vector<uq::Site> sites_alone(const std::vector<JointPlace>& places)
{
    std::vector<uq::Site> sites;
    for (const JointPlace& place : places) sites.push_back(place.site);
    return sites;
}

} // namespace

std::vector<JointPlace> joint_places(const dem::Layout& layout)
{
    return face_places(layout, false, layout.n_joints);
}

std::vector<JointPlace> crack_places(const dem::Layout& layout)
{
    return face_places(layout, true, layout.n_cracks);
}

std::vector<uq::Site> joint_sites(const dem::Layout& layout)
{
    return sites_alone(joint_places(layout));
}

std::vector<uq::Site> crack_sites(const dem::Layout& layout)
{
    return sites_alone(crack_places(layout));
}

std::string_view kind_name(dem::FaceKind kind)
{
    return kind == dem::FaceKind::unit_crack   ? "crack"
           : kind == dem::FaceKind::head_joint ? "head joint"
                                               : "bed joint";
}

} // namespace app
