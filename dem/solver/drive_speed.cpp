#include "dem/solver/drive_speed.hpp"

#include "dem/block/model.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

constexpr double kStepsPerCourse =
    60.0; // a free choice; docs/theory.md, section 4, Speed, has its effect
constexpr double kMostSlowing = 20.0; // stiffer than stone on stone, no wall needs more

/// Of joints and stone in series over a course [Pa].
double wall_modulus(const Model& m, const WallMaterials& w)
{
    double kn = w.base_joint.kn;
    if (!w.joints.empty()) {
        kn = 0.0;
        for (const JointMaterial& j : w.joints)
            kn += j.kn / static_cast<double>(w.joints.size());
    }
    const double joint = 1.0 / (kn * m.layout.course_height);
    return 1.0 / (joint + 1.0 / w.stone.young_modulus);
}

} // namespace

double vertical_load(const Model& m, const WallMaterials& w)
{
    double force = w.vertical_stress.value_or(m.loads.vertical_stress) * m.layout.length *
                   m.layout.thickness;
    for (int b = 0; b < static_cast<int>(m.layout.blocks.size()); ++b) {
        const double volume = area_of(m.layout.blocks[b]) * m.layout.thickness;
        force += volume * stone_of(m, b, m.stone).density * m.loads.gravity;
    }
    return force;
}

double unbalance_measure(const Model& m, const WallMaterials& w)
{
    return vertical_load(m, w) * std::min(1.0, m.layout.length / (0.9 * m.loads.height));
}

double steps_per_mm_of(const Model& m, const WallMaterials& w, const SolverOptions& options)
{
    const double h = m.loads.height, length = m.layout.length, t = m.layout.thickness;
    const double e = wall_modulus(m, w), g = e / (2.0 * (1.0 + m.stone.poisson_ratio));
    const double force = vertical_load(m, w) * length / (2.0 * h);
    const double bends = h * h * h / (3.0 * e * t * length * length * length / 12.0),
                 shears = 1.2 * h / (g * t * length);
    const double elastic_mm = 1e3 * force * (bends + shears);
    if (!(elastic_mm > 0.0)) return options.steps_per_mm;
    const double wanted =
        kStepsPerCourse * m.layout.courses / elastic_mm; // at the default speed [1/mm]
    const double slower = std::max(1.0, wanted / SolverOptions{}.steps_per_mm);
    return options.steps_per_mm * std::min(kMostSlowing, slower);
}

} // namespace dem
