/// Cracks and crushing of units: keys of the study file.

#include "app/input/keys/study_key_table.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include <array>

namespace app {
namespace {

using dem::CrackParameters;
using dem::SolverOptions;
using dem::WallGeometry;

constexpr std::array kLaws = {named("coupled", dem::ContactLaw::coupled),
                              named("uncoupled", dem::ContactLaw::uncoupled)};
constexpr std::array kSnapBacks = {named("breaks", dem::SnapBack::breaks),
                                   named("weakens", dem::SnapBack::weakens)};
constexpr std::array kUnloadings = {named("secant", dem::Unloading::secant),
                                    named("elastic", dem::Unloading::elastic)};
using Pattern = dem::CrackPattern;
/// A test of the patterns of a study.
template <class Holds> constexpr auto any_crack(Holds)
{
    return +[](const Study& s) { return any_pattern(s, s.source, Holds{}); };
}
constexpr Condition kWithCracks{
    any_crack([](const Pattern& p) { return p.kind != Pattern::Kind::none; }),
    "no unit can crack: unit.cracks is none, or a drawn wall has no wall.unit_length"};
constexpr Condition kWithCrackRegion{
    asks<&Study::cracks>([](auto& c) { return !c.where.empty(); }),
    "unit.cracks holds everywhere; write unit.cracks_where, or remove it", true};
constexpr Condition kWithCrackPattern{
    asks<&Study::cracks>([](auto& c) { return !c.pattern.empty(); }),
    "unit.cracks is not given; write unit.cracks, or remove this key", true};
constexpr Condition kWithVoronoi{
    any_crack([](const Pattern& p) { return p.kind == Pattern::Kind::voronoi; }),
    "no pattern of cracks is voronoi"};
constexpr Condition kSharedStiffness{
    any_crack([](const Pattern& p) { return dem::shares_stiffness(p); }),
    "cracks are parallel vertical lines, whose stiffness follows from unit.stiffness_ratio"};
constexpr Condition kPaperStiffness{
    any_crack([](const Pattern& p) {
        return p.kind != Pattern::Kind::none && !dem::shares_stiffness(p);
    }),
    "all cracks share the stiffness of their units, by unit.crack_rigidity"};
/// Bonded joints follow the law of cracks too.
constexpr Condition kWithCrackLaw{
    [](const Study& s) { return kWithCracks.holds(s) || has_mortar(s.parameters.joint); },
    "no unit can crack and joints have no mortar"};
constexpr Condition kTensileCracks{
    asks<&Study::parameters>([](auto& p) { return p.unit.tensile_strength > 0.0; }),
    "unit.tensile_strength is 0"};
constexpr Condition kCoulombCracks{
    asks<&Study::parameters>([](auto& p) { return p.unit.envelope == dem::Envelope::coulomb; }),
    "unit.envelope is hyperbolic"};
constexpr Condition kUnitsCrush{
    asks<&Study::parameters>([](auto& p) { return p.unit.crushing.strength > 0.0; }),
    "unit.compressive_strength is none"};

// clang-format off
constexpr std::array kUnitKeys = {
    Key{.name = "unit.cracks", .kind = Kind::text,
        .derived = {"mid, or none where wall.unit_cracks is no"},
        .meaning = "where units may crack: none, mid (paper), thirds, grid(4, 4), diagonals, voronoi(40 mm)",
        .field = kAt<&Study::cracks, &CrackInput::pattern>},
    Key{.name = "unit.cracks_where", .kind = Kind::text, .used = kWithCrackPattern,
        .derived = {"everywhere"},
        .meaning = "units whose middle lies in x, z, width, height, or in several such boxes: 0.5 m, 0 m, 0.5 m, 0.4 m; ...; toe: the lower 40 % of the half that the wall is pushed towards; needed: the units that a coarse push brings near their strength; the others get no cracks",
        .field = kAt<&Study::cracks, &CrackInput::where>},
    Key{.name = "unit.cracks_elsewhere", .kind = Kind::text, .used = kWithCrackRegion,
        .derived = {"mid"},
        .meaning = "cracks of the other units",
        .field = kAt<&Study::cracks, &CrackInput::elsewhere>},
    Key{.name = "unit.cracks_seed", .kind = Kind::count, .range = {'[', 0, 1e9, ']'},
        .used = kWithCrackPattern, .effect = kWithVoronoi,
        .meaning = "seed of the cells of voronoi",
        .field = kAt<&Study::wall, &WallGeometry::cracks, &dem::UnitCracks::seed>},
    Key{.name = "unit.crack_rigidity", .range = {'(', 1, 1000, ']'},
        .used = kWithCrackPattern, .effect = kSharedStiffness,
        .meaning = "k_n of a crack over the stiffness of the stone between two cracks, where pieces have cracks on all sides; the stone is made stiffer so that the unit keeps its stiffness",
        .field = kAt<&Study::wall, &WallGeometry::cracks, &dem::UnitCracks::rigidity>},
    Key{.name = "unit.stiffness_ratio", .range = {'(', 0, 1e6, ']'}, .used = kWithCracks,
        .effect = kPaperStiffness,
        .varies = Varies::by_crack,
        .meaning = "xi = k_n of a crack / k_n of a joint (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::stiffness_ratio>},
    Key{.name = "unit.tensile_strength", .unit = "MPa", .range = kStrength,
        .used = kWithCracks, .example = "3.7 MPa",
        .varies = Varies::by_crack,
        .meaning = "f_T of the units (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::tensile_strength>},
    Key{.name = "unit.cohesion", .unit = "MPa", .range = kStrength, .used = kWithCracks,
        .derived = {.rule = "tensile_strength", .follow = [](Parameters& p, double) { p.unit.cohesion = p.unit.tensile_strength; }},
        .varies = Varies::by_crack,
        .meaning = "initial cohesion (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::cohesion>},
    Key{.name = "unit.residual_cohesion", .unit = "MPa", .range = kStrength,
        .used = kWithCracks,
        .varies = Varies::by_crack,
        .meaning = "residual cohesion, at most the initial one",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::residual_cohesion>},
    Key{.name = "unit.fracture_energy", .unit = "N/m", .range = {'[', 0, 1e6, ']'},
        .used = kWithCracks, .effect = kTensileCracks,
        .example = "110 N/m",
        .varies = Varies::by_crack,
        .meaning = "fracture energy, mode I (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::fracture_energy>},
    Key{.name = "unit.friction_angle", .unit = "deg", .range = kAngle, .used = kWithCracks,
        .example = "35 deg",
        .varies = Varies::by_crack,
        .meaning = "initial friction angle of a crack (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::friction_angle>},
    Key{.name = "unit.residual_friction_angle", .unit = "deg", .range = kAngle,
        .used = kWithCracks,
        .derived = {.rule = "friction_angle", .follow = [](Parameters& p, double) { p.unit.residual_friction_angle = p.unit.friction_angle; }},
        .varies = Varies::by_crack,
        .meaning = "residual friction angle, at most the initial one (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::residual_friction_angle>},
    Key{.name = "unit.stiffness_factor", .range = kFactor, .used = kWithCracks,
        .varies = Varies::by_crack,
        .meaning = "factor on k_n and k_s of the cracks (paper, Table 5)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::stiffness_factor>},
    Key{.name = "unit.compressive_strength", .unit = "MPa", .range = {'(', 0, 10000, ']'}, .names = kNone,
        .used = kWithCracks,
        .varies = Varies::by_crack,
        .meaning = "f_c along the cracks of units; a crack that crushes has no bond left; none: they do not crush",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::crushing, &dem::Crushing::strength>},
    Key{.name = "unit.crushing_energy", .unit = "N/m", .range = {'(', 0, 1e9, ']'}, .names = kNone,
        .used = kWithCracks, .effect = kUnitsCrush,
        .varies = Varies::by_crack,
        .meaning = "G_c from f_c to nothing; none: the strength stays",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::crushing, &dem::Crushing::energy>},
    Key{.name = "unit.contact_law", .kind = Kind::word, .names = kLaws, .used = kWithCrackLaw,
        .meaning = "damage of tension and shear together (paper, Table 2) or apart (Fig. 7)",
        .field = kAt<&Study::solver, &SolverOptions::law>},
    Key{.name = "unit.envelope", .kind = Kind::word, .names = kEnvelopes, .used = kWithCracks,
        .meaning = "shear strength in tension: coulomb (paper, Table 2), or hyperbolic, a smooth curve from f_T to c, which keeps the tensile strength",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::envelope>},
    Key{.name = "unit.shear_fracture_energy", .unit = "N/m", .range = kShearEnergy, .names = kNone,
        .used = kWithCracks,
        .varies = Varies::by_crack,
        .meaning = "fracture energy, mode II; none: brittle in shear (paper)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::shear_fracture_energy>},
    Key{.name = "unit.tension_reduces_shear", .kind = Kind::word, .names = kYesNo,
        .used = kWithCracks, .effect = kCoulombCracks,
        .meaning = "tau_max = c - sigma tan(theta) in tension too (paper, Table 2, step 5), or c there",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::tension_reduces_shear>},
    Key{.name = "unit.snap_back", .kind = Kind::word, .names = kSnapBacks,
        .used = kWithCracks,
        .effect = kTensileCracks,
        .meaning = "where f_T > sqrt(2 G k_n) a crack breaks; breaks: at f_T, weakens: at that value",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::snap_back>},
    Key{.name = "unit.unloading", .kind = Kind::word, .names = kUnloadings,
        .used = kWithCrackLaw,
        .meaning = "secant: an open crack unloads to the origin; elastic: with k_n (paper, Table 1), and stays open",
        .field = kAt<&Study::solver, &SolverOptions::unloading>},
};
// clang-format on

} // namespace

std::span<const Key> unit_keys() { return kUnitKeys; }

} // namespace app
