#include "app/input/wall/joint_laws.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace app {
namespace {

[[noreturn]] void refuse_law(const StudyFile& source, std::string_view key,
                             const std::string& why)
{
    throw error_at(source, key, why);
}

std::string level_text(const LoadInput& load, std::size_t level)
{
    return "stress level " + std::to_string(level + 1) + " (" +
           quantity_text(load.vertical_stress[level], "MPa") + ")";
}

/// A value may be the same under all stress levels.
void check_count(const LoadInput& load, const StudyFile& source, std::string_view key,
                 std::size_t values)
{
    if (values < 2) return;
    const std::size_t levels = load.vertical_stress.size();
    if (values < levels) {
        refuse_law(source, key,
                   level_text(load, values) + " has no value; write " + std::to_string(levels) +
                       " values, one for each of load.vertical_stress");
    }
    if (values > levels) {
        refuse_law(source, key,
                   "has " + std::to_string(values) + " values, load.vertical_stress " +
                       std::to_string(levels) + "; write one for each stress level");
    }
}

void check_levels_differ(const LoadInput& load, const StudyFile& source)
{
    std::vector<double> levels = load.vertical_stress;
    std::ranges::sort(levels);
    const auto twice = std::ranges::adjacent_find(levels);
    if (twice != levels.end()) {
        refuse_law(source, "load.vertical_stress",
                   quantity_text(*twice, "MPa") + " is given twice; keep one of them");
    }
}

constexpr double kSoftest = 1.0, kStiffest = 1e15; // [Pa/m]; 1e15: as for normal_stiffness

void check_not_too_soft(const JointInput& joint, const StudyFile& source, std::string_view key,
                        double kn)
{
    if (kn * joint.stiffness_factor < kSoftest)
        refuse_law(source, key,
                   "times joint.stiffness_factor is below 1 Pa/m; write a larger value");
}

void check_wall_modulus(const dem::WallGeometry& wall, const dem::Elastic& stone,
                        const StudyFile& source, double modulus)
{
    const double e = stone.young_modulus;
    if (modulus >= e) {
        refuse_law(source, "joint.wall_modulus",
                   quantity_text(modulus, "MPa") + " is not below stone.young_modulus, " +
                       quantity_text(e, "GPa") +
                       "; a wall with joints is softer than its stone (Eq. 2)");
    }
    const double kn = dem::joint_stiffness(wall.course_height, modulus, e);
    if (!(kn >= kSoftest && kn <= kStiffest)) {
        refuse_law(source, "joint.wall_modulus",
                   quantity_text(modulus, "MPa") +
                       " gives a joint stiffness by Eq. 2 outside 1 Pa/m to 1e+06 GPa/m");
    }
}

void check_constant_stiffness(const JointInput& joint, const LoadInput& load,
                              const StudyFile& source)
{
    if (joint.wall_modulus.empty() && joint.normal_stiffness.empty()) {
        refuse_law(source, "joint.wall_modulus",
                   "missing; write e.g. \"wall_modulus = 768 MPa\" or \"normal_stiffness = "
                   "8.08 GPa/m\" under [joint]");
    }
    if (!joint.wall_modulus.empty() && !joint.normal_stiffness.empty()) {
        refuse_law(source, "joint.normal_stiffness",
                   "is given although joint.wall_modulus determines it by Eq. 2; keep one "
                   "of them");
    }
    check_levels_differ(load, source);
    check_count(load, source, "joint.wall_modulus", joint.wall_modulus.size());
    check_count(load, source, "joint.normal_stiffness", joint.normal_stiffness.size());
}

constexpr std::string_view kLawInstead =
    "or joint.initial_stiffness and joint.maximum_closure in place of wall_modulus";

/// Wall moduli tell how joints close, or the two numbers of the law do.
void check_closure_given(const JointInput& joint, const StudyFile& source)
{
    if (!joint.normal_stiffness.empty())
        refuse_law(source, "joint.normal_stiffness",
                   "is that of joints whose joint.closure is linear; write "
                   "joint.initial_stiffness and joint.maximum_closure in its place");
    for (const char* key : {"joint.initial_stiffness", "joint.maximum_closure"}) {
        if (!joint.wall_modulus.empty() && is_given(source, key))
            refuse_law(source, key,
                       "is given although joint.wall_modulus determines it; keep one of them");
        if (joint.wall_modulus.empty() && !is_given(source, key))
            refuse_law(
                source, key,
                "missing; write e.g. \"initial_stiffness = 4.87 GPa/m\" and "
                "\"maximum_closure = 0.154 mm\" under [joint], or the wall_modulus of two "
                "stresses or more");
    }
}

/// With the stresses of its wall moduli, before defaults are derived.
Parameters with_modulus_stress(const Parameters& parameters, const LoadInput& load,
                               const StudyFile& source)
{
    Parameters p = parameters;
    if (!is_given(source, "joint.wall_modulus_stress"))
        p.joint.modulus_stress = load.vertical_stress;
    return p;
}

void check_modulus_stress(const StudyFile& source, const JointInput& joint)
{
    const std::vector<double>& stress = joint.modulus_stress;
    const std::string values = "has " + std::to_string(joint.wall_modulus.size()) + " values, ";
    const bool given = is_given(source, "joint.wall_modulus_stress");
    if (joint.wall_modulus.size() < 2)
        refuse_law(source, "joint.wall_modulus",
                   "one modulus does not tell how joints close; write those of two stresses or "
                   "more and joint.wall_modulus_stress, " +
                       std::string(kLawInstead));
    if (joint.wall_modulus.size() != stress.size())
        refuse_law(source, "joint.wall_modulus",
                   values + (given ? "joint.wall_modulus_stress " : "load.vertical_stress ") +
                       std::to_string(stress.size()) +
                       (given ? "; write one for each stress"
                              : "; write joint.wall_modulus_stress, the stress of each"));
    if (std::ranges::all_of(stress, [&](double s) { return s == stress.front(); }))
        refuse_law(source, "joint.wall_modulus_stress",
                   "moduli under one stress do not tell how joints close; write two stresses "
                   "or more, " +
                       std::string(kLawInstead));
}

void check_fit(const Masonry& masonry, const LoadInput& load, const StudyFile& source)
{
    const Parameters p = with_modulus_stress(masonry.parameters, load, source);
    check_modulus_stress(source, p.joint);
    for (const double modulus : p.joint.wall_modulus)
        check_wall_modulus(masonry.wall, masonry.parameters.stone, source, modulus);
    const dem::ClosureFit fit = closure_fit(p, masonry.wall.course_height);
    const bool stiffens = fit.maximum > 0.0 && std::isfinite(fit.maximum);
    if (stiffens && fit.initial_stiffness > 0.0) return;
    refuse_law(source, "joint.wall_modulus",
               std::string("no law of closure has these moduli: k_n by Eq. 2 ") +
                   (stiffens ? "grows by more than in proportion to the stress"
                             : "does not grow with the stress") +
                   "; write other moduli, " + std::string(kLawInstead));
}

std::string closure_note(const Masonry& masonry)
{
    const JointInput& joint = masonry.parameters.joint;
    if (!is_fitted_closure(joint)) return "";
    const dem::Closing& c = joint.closing;
    return "note: joint.closure: k_0 = " + number(1e-9 * c.initial_stiffness, 4) +
           " GPa/m and V_m = " + number(1e3 * c.maximum, 4) +
           " mm, one law fitted to joint.wall_modulus; residuals " + fit_residuals(masonry) +
           "\n";
}

/// Coulomb's line meets no shear strength at a tension of c / tan(phi).
std::string lost_tension(std::string_view section, const std::string& of, double strength,
                         double cohesion, double friction_angle)
{
    const double left = cohesion / std::tan(friction_angle);
    if (!(left < strength)) return "";
    const std::string name(section);
    return "note: " + name + ".envelope: coulomb leaves " + of + " " + number(1e-6 * left, 3) +
           " of " + number(1e-6 * strength, 3) +
           " MPa in tension, because c < f_T tan(phi): friction takes " +
           fixed(100.0 * (1.0 - left / strength), 0) + " % of it; " + name +
           ".envelope = hyperbolic keeps it\n";
}

} // namespace

void check_stiffness(const Masonry& masonry, const LoadInput& load, const StudyFile& source)
{
    const JointInput& joint = masonry.parameters.joint;
    if (closes(joint)) {
        check_levels_differ(load, source);
        check_closure_given(joint, source);
        if (!joint.wall_modulus.empty()) check_fit(masonry, load, source);
    } else {
        check_constant_stiffness(joint, load, source);
        for (const double modulus : joint.wall_modulus)
            check_wall_modulus(masonry.wall, masonry.parameters.stone, source, modulus);
        for (const double kn : joint.normal_stiffness)
            check_not_too_soft(joint, source, "joint.normal_stiffness", kn);
    }
    check_count(load, source, "joint.shear_stiffness", joint.shear_stiffness.size());
}

void check_closed_stiffness(const JointInput& joint, const LoadInput& load,
                            const StudyFile& source)
{
    if (!closes(joint)) return;
    const dem::Closing& c = joint.closing;
    check_not_too_soft(joint, source, "joint.initial_stiffness", c.initial_stiffness);
    for (const double stress : load.vertical_stress)
        if (!(dem::closed_stiffness(c, stress) <= kStiffest))
            refuse_law(source, "joint.maximum_closure",
                       "makes joints stiffer than 1e+06 GPa/m under " +
                           quantity_text(stress, "MPa") + "; write a larger value");
    if (c.stiffest < c.initial_stiffness)
        refuse_law(source, "joint.largest_stiffness",
                   "must be at least joint.initial_stiffness, " +
                       quantity_text(c.initial_stiffness, "GPa/m"));
    const double most = dem::kMostStiffening * c.initial_stiffness;
    if (c.stiffest > most)
        refuse_law(source, "joint.largest_stiffness",
                   "must be at most " + number(dem::kMostStiffening, 4) +
                       " times joint.initial_stiffness, " + quantity_text(most, "GPa/m"));
}

void check_mixed_modes(const Masonry& masonry, const dem::SolverOptions& solver,
                       const StudyFile& source)
{
    const std::string key(mixed_mode_key(masonry.parameters, has_cracks(masonry, source)));
    if (key.empty()) return;
    if (solver.law == dem::ContactLaw::uncoupled)
        refuse_law(source, "unit.contact_law",
                   "tension and shear share one damage where " + key +
                       " is given; write coupled, or remove " + key);
    if (solver.unloading == dem::Unloading::elastic)
        refuse_law(source, "unit.unloading",
                   "open cracks unload to the origin where " + key +
                       " is given; write secant, or remove " + key);
}

bool is_fitted_closure(const JointInput& joint)
{
    return closes(joint) && !joint.wall_modulus.empty();
}

std::string fit_residuals(const Masonry& masonry)
{
    std::string text;
    for (const double r : closure_fit(masonry.parameters, masonry.wall.course_height).residuals)
        text +=
            (text.empty() ? "" : ", ") + std::string(r < 0.0 ? "" : "+") + fixed(100.0 * r, 2);
    return text + " %";
}

std::string joint_law_notes(const Masonry& masonry, const StudyFile& source)
{
    const dem::CrackParameters& unit = masonry.parameters.unit;
    const JointInput& joint = masonry.parameters.joint;
    constexpr auto kCoulomb = dem::Envelope::coulomb;
    std::string notes = closure_note(masonry);
    if (has_cracks(masonry, source) && unit.envelope == kCoulomb && unit.tension_reduces_shear)
        notes += lost_tension("unit", "units", unit.tensile_strength, unit.cohesion,
                              unit.friction_angle);
    if (has_mortar(joint) && joint.envelope == kCoulomb)
        notes += lost_tension("joint", "mortar", joint.tensile_strength, joint.cohesion,
                              joint.friction_angle);
    return notes;
}

} // namespace app
