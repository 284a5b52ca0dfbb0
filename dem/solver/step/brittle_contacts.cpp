#include "dem/solver/step/brittle_contacts.hpp"

#include "dem/block/model.hpp"
#include "dem/contact/closure.hpp"
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

/// Normal stiffness of a dry joint under a pressure [Pa/m].
double stiffness_under(Closure closure, const JointMaterial& j, double pressure)
{
    if (closure == Closure::linear) return j.kn;
    const ClosureLaw<double> law =
        closure_law(closure, j.closing.initial_stiffness, j.closing.maximum, j.closing.stiffest,
                    j.closing.loss, j.ks / j.kn);
    return closure == Closure::hyperbolic ? tangent_at<Closure::hyperbolic>(law, pressure)
                                          : tangent_at<Closure::exponential>(law, pressure);
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
    const auto add_stiffness = [&n](const Crushing& c, double kn) {
        n += c.energy > 0.0 && c.strength > std::sqrt(2.0 * c.energy * kn);
    };
    const auto add = [&](const auto& material) {
        add_stiffness(material.crushing, material.kn);
    };
    const auto add_joint = [&](const JointMaterial& j) {
        add_stiffness(j.crushing, stiffness_under(m.layout.closure, j, j.crushing.strength));
    };
    for (const Contact& c : m.cracks) {
        const int joint = c.material - m.layout.n_cracks;
        if (joint < 0)
            add(w.cracks[c.material]);
        else
            add(w.joints[joint]);
    }
    for (const Contact& c : m.dry)
        add_joint(c.material == kBaseMaterial   ? w.base_joint
                  : c.material == kBeamMaterial ? w.beam_joint
                                                : w.joints[c.material]);
    return n;
}

} // namespace dem
