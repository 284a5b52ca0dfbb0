#include "dem/solver/brittle_contacts.hpp"

#include "dem/block/model.hpp"
#include "dem/scene/wall.hpp"

#include <cmath>

namespace dem {

int snap_back_contacts(const Model& m, const WallMaterials& w)
{
    int n = 0;
    for (const Contact& c : m.cracks) {
        const int joint = c.material - m.layout.n_cracks;
        const CrackMaterial k = joint < 0 ? w.cracks[c.material] : bond_of(w.joints[joint]);
        n += k.ft > std::sqrt(2.0 * k.fracture_energy * k.kn);
    }
    return n;
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
