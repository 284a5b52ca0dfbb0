#include "dem/solver/brittle_contacts.hpp"

#include "dem/block/model.hpp"
#include "dem/scene/wall.hpp"

#include <cmath>

namespace dem {

namespace {

template <class Breaks> int count_cracks(const Model& m, const WallMaterials& w, Breaks breaks)
{
    int n = 0;
    for (const Contact& c : m.cracks) {
        const int joint = c.material - m.layout.n_cracks;
        n += breaks(joint < 0 ? w.cracks[c.material] : bond_of(w.joints[joint]));
    }
    return n;
}

} // namespace

int snap_back_contacts(const Model& m, const WallMaterials& w)
{
    return count_cracks(m, w, [](const CrackMaterial& c) {
        return c.ft > std::sqrt(2.0 * c.fracture_energy * c.kn);
    });
}

int shear_snap_back_contacts(const Model& m, const WallMaterials& w)
{
    return count_cracks(m, w, [](const CrackMaterial& c) {
        const double g = c.shear_fracture_energy;
        return g > 0.0 && c.cohesion - c.cohesion_res > std::sqrt(2.0 * g * c.ks);
    });
}

int brittle_crushing_contacts(const Model& m, const WallMaterials& w)
{
    if (!m.layout.crushing) return 0;
    int n = 0;
    const auto add = [&n](const auto& material) {
        const Crushing& c = material.crushing;
        n += c.energy > 0.0 && c.strength > std::sqrt(2.0 * c.energy * material.kn);
    };
    for (const Contact& c : m.cracks) {
        const int joint = c.material - m.layout.n_cracks;
        if (joint < 0)
            add(w.cracks[c.material]);
        else
            add(w.joints[joint]);
    }
    for (const Contact& c : m.dry)
        add(c.material == kBaseMaterial   ? w.base_joint
            : c.material == kBeamMaterial ? w.beam_joint
                                          : w.joints[c.material]);
    return n;
}

} // namespace dem
