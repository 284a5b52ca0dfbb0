/// The wall, its stone and its lintels: keys of the study file.

#include "app/drawing/outlines/drawing.hpp"
#include "app/drawing/outlines/raw_drawing.hpp"
#include "app/input/keys/study_key_table.hpp"
#include "app/input/study/material_presets.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

using dem::Elastic;
using dem::WallGeometry;

/// A shift stands for itself, the other bonds for the numbers from 1 on.
constexpr double kRubble = 5.0;
constexpr double number_of(dem::Bond bond) { return 1.0 + static_cast<double>(bond); }
constexpr std::array kBonds = {named("running", 0.5),
                               named("stack", 0),
                               named("english", number_of(dem::Bond::english)),
                               named("flemish", number_of(dem::Bond::flemish)),
                               named("header", number_of(dem::Bond::header)),
                               named("rubble", kRubble)};
std::vector<double> bond_value(const Study& s)
{
    if (s.geometry.rubble) return {kRubble};
    if (s.wall.bond == dem::Bond::shifted) return {s.wall.bond_offset};
    return {number_of(s.wall.bond)};
}
bool is_built(const GeometryInput& g) { return g.file.empty() && g.outlines.empty(); }
void set_bond(Study& s, const std::vector<double>& values)
{
    const double value = values.front();
    s.geometry.rubble = value == kRubble;
    const bool other = value >= 1.0 && !s.geometry.rubble;
    s.wall.bond = other ? static_cast<dem::Bond>(value - 1.0) : dem::Bond::shifted;
    if (value < 1.0) s.wall.bond_offset = value;
}
constexpr std::array kFirstCourses = {named("whole", dem::FirstCourse::whole),
                                      named("shifted", dem::FirstCourse::shifted)};
constexpr std::array kBases = {named("fixed", dem::Base::fixed),
                               named("joint", dem::Base::joint)};
constexpr std::array kToes = {named("held", dem::Toe::held), named("free", dem::Toe::free)};
constexpr Condition kOfDrawing{
    asks<&Study::geometry>([](auto& g) { return !is_picture(g.file); }),
    "wall.geometry is a picture"};
constexpr Condition kOfPolylines{
    asks<&Study::geometry>([](auto& g) { return has_polylines(g.file); }),
    "wall.geometry is no DXF or SVG: only their polylines can be open"};
constexpr Condition kOfPicture{
    asks<&Study::geometry>([](auto& g) { return is_picture(g.file); }),
    "wall.geometry is no picture"};
constexpr Condition kWhereDrawn{asks<&Study::geometry>([](auto& g) { return !is_built(g); }),
                                "the wall is not drawn; write wall.geometry, or remove it",
                                true};
constexpr Condition kBuilt{asks<&Study::geometry>([](auto& g) { return is_built(g); }),
                           "the wall is drawn, not laid in courses; remove it", true};
constexpr Condition kInCourses{asks<&Study::geometry>([](auto& g) { return in_courses(g); }),
                               "the wall is drawn or of rubble, not laid in courses; remove it",
                               true};
constexpr Condition kEqualCourses{
    asks<&Study::geometry, &Study::wall>(
        [](auto& g, auto& w) { return is_built(g) && w.course_heights.empty(); }),
    "the wall is drawn, or wall.course_heights has its courses; remove it", true};
/// Condition of keys that are of use to a drawing, but not needed: h of Eq. 2, and the length
/// of whole units.
constexpr Condition kEqualCoursesOrGiven{
    asks<&Study::geometry, &Study::wall, &Study::source>([](auto& g, auto& w, auto& source) {
        return w.course_heights.empty() &&
               (is_built(g) || find_entry(source, "wall.course_height") != nullptr);
    }),
    "wall.course_heights has the heights of the courses; remove it", true};
constexpr Condition kBuiltOrGiven{
    asks<&Study::geometry, &Study::source>([](auto& g, auto& source) {
        return is_built(g) || find_entry(source, "wall.unit_length") != nullptr;
    })};
constexpr Condition kWithWholeUnits{
    asks<&Study::geometry, &Study::source>([](auto& g, auto& source) {
        return !g.rubble && (is_built(g) || find_entry(source, "wall.unit_length") != nullptr);
    }),
    "no unit is known to be whole: the wall is of rubble, or drawn without wall.unit_length"};
constexpr Condition kWithHeaders{
    asks<&Study::geometry, &Study::wall>(
        [](auto& g, auto& w) { return in_courses(g) && w.bond != dem::Bond::shifted; }),
    "there are no headers; write wall.bond = english, flemish or header, or remove it", true};
constexpr Condition kWithShiftedCourses{
    asks<&Study::geometry, &Study::wall>(
        [](auto& g, auto& w) { return in_courses(g) && w.bond == dem::Bond::shifted; }),
    "the bond is not running, and only its units get random lengths; write wall.bond = "
    "running, or remove it",
    true};
constexpr Condition kRandomLayout{
    asks<&Study::geometry, &Study::wall>(
        [](auto& g, auto& w) { return is_built(g) && (g.rubble || w.length_cov > 0.0); }),
    "no layout is drawn at random; write wall.bond = rubble, or wall.unit_length_cov, or "
    "remove it",
    true};
constexpr auto kUnitNames = [] {
    std::array<Named, kLengthUnits.size()> names;
    std::ranges::transform(kLengthUnits, names.begin(),
                           [](const LengthUnit& u) { return named(u.name, u.metres); });
    return names;
}();
constexpr Condition kWithOpenings{
    asks<&Study::geometry>([](auto& g) { return !g.openings.empty(); }),
    "the wall has no openings; write wall.openings, or remove it", true};
constexpr Condition kWithLintels{
    asks<&Study::wall>([](auto& w) { return w.lintel_bearing > 0.0; }), "lintel.bearing is 0"};
constexpr Condition kSeveralCourses{asks<&Study::wall, &Study::geometry>([](auto& w, auto& g) {
                                        return w.courses > 1 || g.rubble ||
                                               w.bond != dem::Bond::shifted ||
                                               w.first_course == dem::FirstCourse::shifted;
                                    }),
                                    "the wall has one course, which is not shifted"};
constexpr Condition kShiftedCourses{asks<&Study::wall>([](auto& w) {
                                        return w.bond != dem::Bond::shifted ||
                                               w.bond_offset > 0.0;
                                    }),
                                    "wall.bond is stack"};
constexpr Condition kMovingFirstCourse{
    asks<&Study::wall, &Study::discretisation>(
        [](auto& w, auto& d) { return w.base == dem::Base::joint || d.block_modes != 3; }),
    "the first course is rigid and clamped"};
constexpr auto kMaterials = [] {
    std::array<Named, kMaterialNames.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = named(kMaterialNames[i], i);
    return names;
}();
constexpr Condition kWithMaterial{
    asks<&Study::geometry>([](auto& g) { return g.material != 0; }), "wall.material is none"};
constexpr Condition kGivesValues{asks<&Study::source>([](auto& f) {
                                     return std::ranges::any_of(f.entries, &Entry::preset);
                                 }),
                                 "the study writes all values of the material itself"};
// The ends of the ranges are beyond any wall: they catch a wrong power of ten.
constexpr Range kLength{'[', 0.001, 100, ']'}; // [m]

// clang-format off
constexpr std::array kWallKeys = {
    Key{.name = "wall.geometry", .kind = Kind::text,
        .meaning = "a drawing of the blocks (.dxf, .json, .svg) or a picture of the stones (.png), in place of courses; from the folder of the study, with --set from the current folder",
        .field = kAt<&Study::geometry, &GeometryInput::file>},
    Key{.name = "wall.outlines", .kind = Kind::text,
        .meaning = "outlines as text: \"x z\" corners in metres, counter-clockwise, separated by commas; stones separated by semicolons",
        .field = kAt<&Study::geometry, &GeometryInput::outlines>},
    Key{.name = "wall.length_unit", .kind = Kind::word, .names = kUnitNames, .used = kOfFile,
        .effect = kOfDrawing,
        .meaning = "length of one unit of the drawing; not written: what the drawing itself states, or else mm",
        .field = kAt<&Study::geometry, &GeometryInput::length_unit>},
    Key{.name = "wall.snap", .unit = "mm", .range = {'[', 0, 100, ']'}, .used = kOfFile,
        .effect = kOfDrawing,
        .meaning = "gaps and overlaps of a drawing up to this are closed",
        .field = kAt<&Study::geometry, &GeometryInput::snap>},
    Key{.name = "wall.close_outlines", .kind = Kind::word, .names = kYesNo, .used = kOfFile,
        .effect = kOfPolylines,
        .meaning = "open outlines of four corners or more are closed by a straight side",
        .field = kAt<&Study::geometry, &GeometryInput::close_outlines>},
    Key{.name = "wall.picture_width", .unit = "m", .range = {'[', 0, 100, ']'}, .used = kOfFile,
        .effect = kOfPicture,
        .meaning = "width of the picture from edge to edge; must be given",
        .field = kAt<&Study::geometry, &GeometryInput::picture_width>},
    Key{.name = "wall.picture_height", .unit = "m", .range = {'[', 0, 100, ']'}, .used = kOfFile,
        .effect = kOfPicture,
        .meaning = "height of the picture from edge to edge; must be given",
        .field = kAt<&Study::geometry, &GeometryInput::picture_height>},
    Key{.name = "wall.simplify", .unit = "mm", .range = {'[', 0, 1000, ']'}, .used = kOfFile,
        .effect = kOfPicture,
        .meaning = "largest distance of an outline from the edge of its stone in the picture",
        .field = kAt<&Study::geometry, &GeometryInput::simplify>},
    Key{.name = "wall.layer_stones", .kind = Kind::text, .used = kWhereDrawn,
        .meaning = "materials of layers of another stone, as NAME: E, Poisson's ratio, density: lintel: 30 GPa, 0.2, 2500 kg/m3; ...",
        .field = kAt<&Study::geometry, &GeometryInput::layer_stones>},
    Key{.name = "wall.length", .unit = "m", .range = kLength, .used = kBuilt, .example = "1.00 m",
        .meaning = "length of the wall, along the push",
        .field = kAt<&Study::wall, &WallGeometry::length>},
    Key{.name = "wall.course_heights", .kind = Kind::list, .unit = "m", .range = kHeight, .used = kInCourses,
        .derived = {"all wall.course_height"},
        .meaning = "height of each course, from the bottom, in place of courses and course_height; h of Eq. 2 is their mean",
        .field = kAt<&Study::wall, &WallGeometry::course_heights>},
    Key{.name = "wall.courses", .kind = Kind::count, .range = {'[', 1, 1000, ']'}, .used = kEqualCourses, .example = "10",
        .meaning = "number of courses; of rubble: mean number of stones over the height",
        .field = kAt<&Study::wall, &WallGeometry::courses>},
    Key{.name = "wall.course_height", .unit = "m", .range = kHeight, .used = kEqualCoursesOrGiven, .example = "0.10 m",
        .meaning = "height of a course, h of Eq. 2; of rubble: of a mean stone",
        .field = kAt<&Study::wall, &WallGeometry::course_height>},
    Key{.name = "wall.unit_length", .unit = "m", .range = kLength, .used = kBuiltOrGiven, .example = "0.20 m",
        .meaning = "length of a whole unit; of rubble: of a mean stone",
        .field = kAt<&Study::wall, &WallGeometry::unit_length>},
    Key{.name = "wall.thickness", .unit = "m", .range = kLength, .example = "0.20 m",
        .meaning = "thickness of the wall, out of plane",
        .field = kAt<&Study::wall, &WallGeometry::thickness>},
    Key{.name = "wall.bond", .range = {'[', 0, 1, ')'}, .names = kBonds,
        .used = kBuilt, .effect = kSeveralCourses,
        .meaning = "shift of every second course in unit lengths (running 0.5, stack 0); english, flemish, header; or random stones: rubble",
        .field = {bond_value, set_bond}},
    Key{.name = "wall.header_length", .unit = "m", .range = kLength, .used = kWithHeaders,
        .derived = {"half of wall.unit_length", [](Study& s) { s.wall.header_length = 0.5 * s.wall.unit_length; }},
        .meaning = "length along the wall of units that lie across it",
        .field = kAt<&Study::wall, &WallGeometry::header_length>},
    Key{.name = "wall.unit_length_cov", .range = {'[', 0, 1, ')'}, .used = kWithShiftedCourses,
        .meaning = "coefficient of variation of the lengths of whole units, whose head joints move to either side",
        .field = kAt<&Study::wall, &WallGeometry::length_cov>},
    Key{.name = "wall.seed", .kind = Kind::count, .range = {'[', 0, 1e9, ']'}, .used = kRandomLayout,
        .meaning = "seed of random lengths of units, or of rubble",
        .field = kAt<&Study::wall, &WallGeometry::seed>},
    Key{.name = "wall.layouts", .kind = Kind::count, .range = {'[', 1, 1e6, ']'}, .used = kRandomLayout,
        .verbs = "push study sample",
        .meaning = "number of random layouts, of the seeds wall.seed, wall.seed + 1, ...: the samples of a study take them in turn",
        .field = kAt<&Study::geometry, &GeometryInput::layouts>},
    Key{.name = "wall.first_course", .kind = Kind::word, .names = kFirstCourses,
        .used = kInCourses, .effect = kShiftedCourses,
        .meaning = "bottom course starts with a whole unit or with the shifted piece",
        .field = kAt<&Study::wall, &WallGeometry::first_course>},
    Key{.name = "wall.unit_cracks", .kind = Kind::word, .names = kYesNo,
        .used = kWithWholeUnits,
        .meaning = "a potential crack at mid-length of each whole unit (paper, Fig. 2)",
        .field = kAt<&Study::cracks, &CrackInput::in_units>},
    Key{.name = "wall.openings", .kind = Kind::text, .used = kInCourses,
        .meaning = "doors and windows as x, z, width, height between courses: 0.4 m, 0 m, 0.6 m, 1.2 m; ...",
        .field = kAt<&Study::geometry, &GeometryInput::openings>},
    Key{.name = "wall.base", .kind = Kind::word, .names = kBases,
        .meaning = "bottom face clamped (paper, section 3), or on a dry joint",
        .field = kAt<&Study::wall, &WallGeometry::base>},
    Key{.name = "wall.toe", .kind = Kind::word, .names = kToes,
        .used = kInCourses, .effect = kMovingFirstCourse,
        .meaning = "toe side of the first course held sideways (paper, section 3)",
        .field = kAt<&Study::wall, &WallGeometry::toe>},
    Key{.name = "wall.material", .kind = Kind::word, .names = kMaterials, .used = kWithMaterial, .effect = kGivesValues,
        .meaning = "values and scatter of stone, joint and unit by type; keys that the study writes itself win; listed in docs/materials.md",
        .field = kAt<&Study::geometry, &GeometryInput::material>},

    Key{.name = "stone.young_modulus", .unit = "GPa", .range = kModulus,        .example = "15.5 GPa",
        .varies = Varies::by_wall,
        .meaning = "E_stone of Eq. 2",
        .field = kAt<&Study::parameters, &Parameters::stone, &Elastic::young_modulus>},
    Key{.name = "stone.poisson_ratio", .range = kPoisson,        .example = "0.2",
        .fixed_because = "because the walls of a study share the deformation modes of their blocks (through the "
                         "blocks, 0.1 to 0.3 moves the stiffness of the paper's wall by 0.6 % and its peak by 0.1 %)",
        .meaning = "Poisson's ratio, which also enters k_s = k_n / (2 (1 + nu)) (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::stone, &Elastic::poisson_ratio>},
    Key{.name = "stone.density", .unit = "kg/m3", .range = kDensity, .effect = kWithGravity,
        .example = "2300 kg/m3",
        .varies = Varies::by_wall,
        .meaning = "self-weight of the wall",
        .field = kAt<&Study::parameters, &Parameters::stone, &Elastic::density>},

    Key{.name = "lintel.bearing", .unit = "m", .range = {'[', 0, 10, ']'}, .used = kWithOpenings,
        .derived = {"half of wall.unit_length", [](Study& s) { s.wall.lintel_bearing = 0.5 * s.wall.unit_length; }},
        .meaning = "how far a lintel, one course high, reaches over either side of its opening; 0: no lintels",
        .field = kAt<&Study::wall, &WallGeometry::lintel_bearing>},
    Key{.name = "lintel.young_modulus", .unit = "GPa", .range = kModulus, .used = kWithOpenings,
        .effect = kWithLintels,
        .derived = {"stone.young_modulus", [](Study& s) { s.wall.lintel.young_modulus = s.parameters.stone.young_modulus; }},
        .meaning = "Young's modulus of the lintels",
        .field = kAt<&Study::wall, &WallGeometry::lintel, &Elastic::young_modulus>},
    Key{.name = "lintel.poisson_ratio", .range = kPoisson, .used = kWithOpenings,
        .effect = kWithLintels,
        .derived = {"stone.poisson_ratio", [](Study& s) { s.wall.lintel.poisson_ratio = s.parameters.stone.poisson_ratio; }},
        .meaning = "Poisson's ratio of the lintels",
        .field = kAt<&Study::wall, &WallGeometry::lintel, &Elastic::poisson_ratio>},
    Key{.name = "lintel.density", .unit = "kg/m3", .range = kDensity, .used = kWithOpenings,
        .effect = kWithLintels,
        .derived = {"stone.density", [](Study& s) { s.wall.lintel.density = s.parameters.stone.density; }},
        .meaning = "density of the lintels",
        .field = kAt<&Study::wall, &WallGeometry::lintel, &Elastic::density>},
};
// clang-format on

} // namespace

std::span<const Key> wall_keys() { return kWallKeys; }

} // namespace app
