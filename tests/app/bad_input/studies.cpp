#include "app/bad_input/cases.hpp"

#include <array>

namespace bad_input {

const std::string_view kGoodStudy = R"([wall]
length = 1.00 m
courses = 10
course_height = 0.10 m
unit_length = 0.20 m
thickness = 0.20 m
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
wall_modulus = 566, 768 MPa
friction_angle = 31.8 deg
[unit]
tensile_strength = 3.7 MPa
fracture_energy = 110 N/m
friction_angle = 35 deg
[beam]
height = 0.10 m
young_modulus = 30 GPa
density = 2400 kg/m3
[load]
vertical_stress = 0.15, 0.50 MPa
)";

namespace {

using namespace std::string_view_literals;

// clang-format off
constexpr std::array kStudies = {
    // the file
    BadStudy{"empty file", "", "",
        "study.ini:1: no key in the file; configs/wall.ini shows a complete study"},
    BadStudy{"only comments", "", "# a wall\n\n  # of stone\n",
        "study.ini:3: no key in the file; configs/wall.ini shows a complete study"},
    BadStudy{"binary file", "", "\x7f""ELF\2\1\1\0\0\0"sv,
        "study.ini: is not UTF-8 text; save the study as plain text in UTF-8"},
    BadStudy{"Latin-1 file", "courses = 10", "courses = 10 # Louren\xe7o",
        "study.ini: is not UTF-8 text; save the study as plain text in UTF-8"},
    BadStudy{"a line of prose", "courses = 10", "ten courses",
        "study.ini:3: \"ten courses\" is neither [section], key = value nor # comment"},
    BadStudy{"a key above all sections", "[wall]", "courses = 10\n[wall]",
        "study.ini:1: courses: outside a section; open one above it, such as [wall]"},
    BadStudy{"an open bracket", "[stone]", "[stone",
        "study.ini:7: malformed section \"[stone\"; write its name alone in brackets, such as [wall]"},
    BadStudy{"a key beside its section", "[stone]", "[stone] density = 1 kg/m3",
        "study.ini:7: malformed section \"[stone] density = 1 kg/m3\"; write its name alone in brackets, such as [wall]"},
    BadStudy{"a key of two words", "courses = 10", "no of courses = 10",
        "study.ini:3: malformed key \"no of courses\"; write letters, digits and _ before the ="},
    BadStudy{"no key before the =", "courses = 10", "= 10",
        "study.ini:3: malformed key \"\"; write letters, digits and _ before the ="},
    BadStudy{"duplicated key", "courses = 10", "courses = 10\ncourses = 12",
        "study.ini:4: wall.courses: given twice, first on line 3; keep one of them"},
    BadStudy{"duplicated key in a section opened twice", "[load]", "[wall]\ncourses = 12\n[load]",
        "study.ini:23: wall.courses: given twice, first on line 3; keep one of them"},
    BadStudy{"empty value", "courses = 10", "courses = # ten",
        "study.ini:3: wall.courses: empty value; write one after the ="},

    // names
    BadStudy{"unknown section", "[stone]", "[stones]",
        "study.ini:7: [stones]: unknown section; did you mean \"stone\"?"},
    BadStudy{"unknown section like no other", "[load]", "[earthquake]\n[load]",
        "study.ini:22: [earthquake]: unknown section; use wall, stone, lintel, joint, unit, beam, base, shaking, load, solver, output, uq, reliability, fragility or calibration"},
    BadStudy{"unknown key", "thickness = 0.20 m", "thicknes = 0.20 m",
        "study.ini:6: wall.thicknes: unknown key; did you mean \"wall.thickness\"?"},
    BadStudy{"a key in capitals", "courses = 10", "Courses = 10",
        "study.ini:3: wall.Courses: unknown key; did you mean \"wall.courses\"?"},
    BadStudy{"unknown key like no other", "[stone]", "[stone]\ncolour = grey",
        "study.ini:8: stone.colour: unknown key; use young_modulus, poisson_ratio or density"},
    BadStudy{"missing key", "friction_angle = 31.8 deg", "",
        "study.ini:11: joint.friction_angle: missing; write e.g. \"friction_angle = 31.8 deg\" under [joint]"},
    BadStudy{"missing section", "[load]\nvertical_stress = 0.15, 0.50 MPa\n", "",
        "study.ini:21: load.vertical_stress: missing; write e.g. \"vertical_stress = 0.50 MPa\" under [load]"},
    BadStudy{"missing strength of units that can crack", "tensile_strength = 3.7 MPa", "",
        "study.ini:14: unit.tensile_strength: missing; write e.g. \"tensile_strength = 3.7 MPa\" under [unit]"},

    // units and numbers
    BadStudy{"missing unit", "thickness = 0.20 m", "thickness = 0.20",
        "study.ini:6: wall.thickness: missing unit; write \"0.20 m\""},
    BadStudy{"wrong unit", "thickness = 0.20 m", "thickness = 0.20 mm2",
        "study.ini:6: wall.thickness: unit \"mm2\" is not a length; use m, cm or mm"},
    BadStudy{"unit of another quantity", "friction_angle = 31.8 deg", "friction_angle = 31.8 MPa",
        "study.ini:13: joint.friction_angle: unit \"MPa\" is not an angle; use rad, deg or \u00b0"},
    BadStudy{"unit in small letters", "young_modulus = 30 GPa", "young_modulus = 30 gpa",
        "study.ini:20: beam.young_modulus: unit \"gpa\" is not a stress; use Pa, kPa, MPa, GPa, N/mm2, kN/m2 or bar"},
    BadStudy{"unit where none belongs", "poisson_ratio = 0.2", "poisson_ratio = 0.2 m",
        "study.ini:9: stone.poisson_ratio: unit \"m\" where none belongs; write \"0.2\""},
    BadStudy{"nan", "density = 2300 kg/m3", "density = nan kg/m3",
        "study.ini:10: stone.density: \"nan kg/m3\" is not a finite number; write a number and its unit, such as \"1 kg/m3\""},
    BadStudy{"inf", "density = 2300 kg/m3", "density = -inf kg/m3",
        "study.ini:10: stone.density: \"-inf kg/m3\" is not a finite number; write a number and its unit, such as \"1 kg/m3\""},
    BadStudy{"more than a double holds", "density = 2300 kg/m3", "density = 1e999 kg/m3",
        "study.ini:10: stone.density: \"1e999 kg/m3\" is beyond the range of a double; write a number and its unit, such as \"1 kg/m3\""},
    BadStudy{"hexadecimal number", "courses = 10", "courses = 0x10",
        "study.ini:3: wall.courses: \"0x10\" is not a decimal number; write a number, such as \"1\""},
    BadStudy{"decimal comma", "thickness = 0.20 m", "thickness = 0,20 m",
        "study.ini:6: wall.thickness: comma inside \"0,20 m\"; write a decimal point, \"0.20 m\", or a list with blanks, \"0, 20 m\""},
    BadStudy{"half a course", "courses = 10", "courses = 7.5",
        "study.ini:3: wall.courses: \"7.5\" is not a whole number; write one, such as \"10\""},
    BadStudy{"half an exponent", "courses = 10", "courses = 1e3.5",
        "study.ini:3: wall.courses: \"1e3.5\" is not one decimal number; write a number, such as \"1\""},
    BadStudy{"a list for one value", "thickness = 0.20 m", "thickness = 0.20, 0.30 m",
        "study.ini:6: wall.thickness: 2 values where one belongs; write one of them"},
    BadStudy{"a hole in a list", "wall_modulus = 566, 768 MPa", "wall_modulus = 566, , 768 MPa",
        "study.ini:12: joint.wall_modulus: empty place in the list \"566, , 768 MPa\"; write a number between two commas"},
    BadStudy{"unit on some values", "wall_modulus = 566, 768 MPa", "wall_modulus = 566 MPa, 768",
        "study.ini:12: joint.wall_modulus: missing unit in \"566 MPa, 768\"; write it once at the end, or on each value"},
    BadStudy{"a list without unit", "wall_modulus = 566, 768 MPa", "wall_modulus = 566, 768",
        "study.ini:12: joint.wall_modulus: missing unit; write \"566, 768 MPa\""},
    BadStudy{"half a distribution", "friction_angle = 31.8 deg", "friction_angle = normal(mean 31.8 deg, cov 0.20",
        "study.ini:13: joint.friction_angle: \"normal(mean 31.8 deg, cov 0.20\" is not a distribution; write one pair of brackets, such as \"normal(mean 31.8 deg, cov 0.20)\""},
    BadStudy{"unknown distribution", "friction_angle = 31.8 deg", "friction_angle = norml(mean 31.8 deg, cov 0.20)",
        "study.ini:13: joint.friction_angle: unknown distribution \"norml\"; did you mean \"normal\"?"},
    BadStudy{"a parameter too few", "friction_angle = 31.8 deg", "friction_angle = normal(mean 31.8 deg)",
        "study.ini:13: joint.friction_angle: \"normal(mean 31.8 deg)\" does not have the parameters of normal; write normal(mean ..., cov ...) or normal(mean ..., sd ...), and from ..., to ... to cut it off"},
    BadStudy{"a parameter without value", "friction_angle = 31.8 deg", "friction_angle = normal(mean, cov 0.20)",
        "study.ini:13: joint.friction_angle: \"mean\" in \"normal(mean, cov 0.20)\" has no value; write a name and a value, such as \"cov 0.30\""},
    BadStudy{"a parameter without unit", "friction_angle = 31.8 deg", "friction_angle = normal(mean 31.8, cov 0.20)",
        "study.ini:13: joint.friction_angle: missing unit; write \"31.8 deg\""},
    BadStudy{"a distribution in the wrong unit", "friction_angle = 31.8 deg", "friction_angle = normal(mean 31.8 rad, cov 0.20)",
        "study.ini:13: joint.friction_angle: \"normal(mean 31.8 rad, cov 0.20)\" lies outside the range of this key, [0, 90) deg; check its unit"},
    BadStudy{"a measured value out of range", "friction_angle = 31.8 deg", "friction_angle = empirical(30, 31, 95 deg)",
        "study.ini:13: joint.friction_angle: \"empirical(30, 31, 95 deg)\" lies outside the range of this key, [0, 90) deg; check its unit"},
    BadStudy{"a beta wider than its ends", "friction_angle = 31.8 deg", "friction_angle = beta(mean 35 deg, cov 0.4, lower 20 deg, upper 40 deg)",
        "study.ini:13: joint.friction_angle: \"beta(mean 35 deg, cov 0.4, lower 20 deg, upper 40 deg)\": beta: coefficient of variation is 0.4; allowed: below sqrt((mean - lower) (upper - mean)) / |mean| (numbers in rad)"},
    BadStudy{"a distribution of what all walls share", "courses = 10", "courses = normal(mean 10, cov 0.20)",
        "study.ini:3: wall.courses: \"normal(mean 10, cov 0.20)\" is a distribution, but wall.courses is the same for all walls; write a number"},
    BadStudy{"unknown word", "[stone]", "base = fixd\n[stone]",
        "study.ini:7: wall.base: \"fixd\" is not one of fixed or joint; did you mean \"fixed\"?"},
    BadStudy{"a number for a word", "[stone]", "base = 1\n[stone]",
        "study.ini:7: wall.base: \"1\" is not one of fixed or joint"},
    BadStudy{"a fraction", "[stone]", "bond = 1/3\n[stone]",
        "study.ini:7: wall.bond: \"1/3\" is a fraction; write it as a decimal number, such as 0.3333"},
    BadStudy{"unknown bond", "[stone]", "bond = dutch\n[stone]",
        "study.ini:7: wall.bond: \"dutch\" is not one of running, stack, english, flemish, header, rubble, [0, 1)"},
    BadStudy{"headers in running bond", "[stone]", "header_length = 0.1 m\n[stone]",
        "study.ini:7: wall.header_length: there are no headers; write wall.bond = english, flemish or header, or remove it"},
    BadStudy{"headers longer than units", "[stone]", "bond = english\nheader_length = 0.25 m\n[stone]",
        "study.ini:8: wall.header_length: must be at most wall.unit_length, 0.2 m"},
    BadStudy{"a number of courses besides their heights", "[stone]", "course_heights = 0.5, 0.5 m\n[stone]",
        "study.ini:3: wall.courses: the wall is drawn, or wall.course_heights has its courses; remove it"},
    BadStudy{"lengths at random in another bond", "[stone]", "bond = flemish\nunit_length_cov = 0.1\n[stone]",
        "study.ini:8: wall.unit_length_cov: the bond is not running, and only its units get random lengths; write wall.bond = running, or remove it"},
    BadStudy{"lengths that lose the bond", "[stone]", "unit_length_cov = 0.3\n[stone]",
        "study.ini:7: wall.unit_length_cov: head joints would pass those of the next course; write at most 0.202"},
    BadStudy{"a seed of nothing", "[stone]", "seed = 7\n[stone]",
        "study.ini:7: wall.seed: no layout is drawn at random; write wall.bond = rubble, or wall.unit_length_cov, or remove it"},
    BadStudy{"a door in rubble", "[stone]", "bond = rubble\nopenings = 0.4 m, 0 m, 0.2 m, 0.5 m\n[stone]",
        "study.ini:8: wall.openings: the wall is drawn or of rubble, not laid in courses; remove it"},
    BadStudy{"an opening that leaves a sliver", "[stone]", "openings = 0.3005 m, 0 m, 0.2 m, 0.5 m\n[stone]",
        "study.ini:7: wall.openings: a unit beside an opening or its lintel would be 0.5 mm long; move or widen the opening, or change lintel.bearing, so that none is below 1 mm"},
    BadStudy{"a window at the edge with a lintel", "[stone]", "openings = 0 m, 0.2 m, 0.2 m, 0.5 m\n[stone]",
        "study.ini:7: wall.openings: a lintel has no bearing beside its opening; leave room, or write lintel.bearing = 0 m for openings without lintels"},
    BadStudy{"an opening as long as the wall", "[stone]", "openings = 0 m, 0.2 m, 1 m, 0.5 m\n[lintel]\nbearing = 0 m\n[stone]",
        "study.ini:7: wall.openings: nothing connects what lies above z = 0.7 m to the floor; leave a pier beside the openings"},
    BadStudy{"cracks at mid-length of rubble", "[unit]", "[wall]\nbond = rubble\n[unit]\ncracks = mid",
        "study.ini:17: unit.cracks: mid needs whole units, and rubble has none; write thirds, grid(2, 2), ..."},
    BadStudy{"rubble of pebbles", "length = 1.00 m\ncourses = 10\ncourse_height = 0.10 m\nunit_length = 0.20 m",
        "length = 3 m\ncourses = 100\ncourse_height = 0.02 m\nunit_length = 0.02 m\nbond = rubble",
        "study.ini:5: wall.unit_length: makes a wall of more than 10000 stones; write larger ones, or draw the wall"},

    BadStudy{"an unknown pattern of cracks", "[unit]", "[unit]\ncracks = grid(4)",
        "study.ini:15: unit.cracks: \"grid(4)\" is not a pattern; write none, mid, thirds, grid(4, 4), diagonals or voronoi(40 mm)"},
    BadStudy{"half a piece", "[unit]", "[unit]\ncracks = grid(4, 1.5)",
        "study.ini:15: unit.cracks: \"1.5\" is not a number of pieces; write a whole number from 1 to 100"},
    BadStudy{"cells in square millimetres", "[unit]", "[unit]\ncracks = grid(4, 100)\ncracks_where = 0 m, 0 m, 1 mm, 1 mm\ncracks_elsewhere = voronoi(2 mm2)",
        "study.ini:17: unit.cracks_elsewhere: unit \"mm2\" is not a length; use m, cm or mm"},
    BadStudy{"a region without size", "[unit]", "[unit]\ncracks = thirds\ncracks_where = 0 m, 0 m, 1 m",
        "study.ini:16: unit.cracks_where: \"0 m, 0 m, 1 m\" is not a region; write toe, needed, or x, z, width and height: \"0.5 m, 0 m, 0.5 m, 0.4 m\""},
    BadStudy{"cracks that are ruled out", "thickness = 0.20 m", "thickness = 0.20 m\nunit_cracks = no\n[unit]\ncracks = mid",
        "study.ini:9: unit.cracks: wall.unit_cracks = no says that units have no cracks; remove one of the two keys"},
    BadStudy{"a region of no pattern", "[unit]", "[unit]\ncracks_where = toe",
        "study.ini:15: unit.cracks_where: unit.cracks is not given; write unit.cracks, or remove this key"},
    BadStudy{"tiny pieces", "[unit]", "[unit]\ncracks = grid(4, 100)\ncracks_where = 0 m, 0 m, 1 m, 0.1 m",
        "study.ini:15: unit.cracks: makes pieces below 1 mm; write fewer pieces, or larger cells"},

    // ranges
    BadStudy{"zero courses", "courses = 10", "courses = 0",
        "study.ini:3: wall.courses: \"0\" is out of range; must be in [1, 1000]"},
    BadStudy{"negative stiffness", "young_modulus = 15.5 GPa", "young_modulus = -15.5 GPa",
        "study.ini:8: stone.young_modulus: \"-15.5 GPa\" is out of range; must be in (0, 1000] GPa"},
    BadStudy{"Poisson's ratio drawn at random", "poisson_ratio = 0.2", "poisson_ratio = normal(mean 0.2, cov 0.1)",
        "study.ini:9: stone.poisson_ratio: \"normal(mean 0.2, cov 0.1)\" is a distribution, but stone.poisson_ratio is the same for all walls, because the walls of a study share the deformation modes of their blocks (through the blocks, 0.1 to 0.3 moves the stiffness of the paper's wall by 0.6 % and its peak by 0.1 %); write a number"},
    BadStudy{"Poisson's ratio of 0.5", "poisson_ratio = 0.2", "poisson_ratio = 0.5",
        "study.ini:9: stone.poisson_ratio: \"0.5\" is out of range; must be in [0, 0.5)"},
    BadStudy{"friction angle of 95 degrees", "friction_angle = 31.8 deg", "friction_angle = 95 deg",
        "study.ini:13: joint.friction_angle: \"95 deg\" is out of range; must be in [0, 90) deg"},
    BadStudy{"more zones than a machine can hold", "[load]", "[solver]\ncontact_points = 100\n[load]",
        "study.ini:23: solver.contact_points: makes 198 zones along a face; (contact_points - 1) x zones_per_interval must be at most 100"},
    BadStudy{"one contact point", "[load]", "[solver]\ncontact_points = 1\n[load]",
        "study.ini:23: solver.contact_points: \"1\" is out of range; must be in [2, 100]"},
    BadStudy{"an accuracy that may be a percentage or a share", "[load]", "[solver]\naccuracy = 1\n[load]",
        "study.ini:23: solver.accuracy: missing unit; write \"1 %\""},
    BadStudy{"no error at all", "[load]", "[solver]\naccuracy = 0 %\n[load]",
        "study.ini:23: solver.accuracy: \"0 %\" is out of range; must be in (0, 50] %"},
    BadStudy{"two block modes", "[load]", "[solver]\nblock_modes = 2\n[load]",
        "study.ini:23: solver.block_modes: \"2\" is out of range; must be in [3, 1000]"},
    BadStudy{"millimetres written as metres", "length = 1.00 m", "length = 1000 m",
        "study.ini:2: wall.length: \"1000 m\" is out of range; must be in [0.001, 100] m"},

    // values at odds with each other
    BadStudy{"a stress level without modulus", "vertical_stress = 0.15, 0.50 MPa", "vertical_stress = 0.15, 0.50, 0.75 MPa",
        "study.ini:12: joint.wall_modulus: stress level 3 (0.75 MPa) has no value; write 3 values, one for each of load.vertical_stress"},
    BadStudy{"a modulus without stress level", "wall_modulus = 566, 768 MPa", "wall_modulus = 566, 768, 1057 MPa",
        "study.ini:12: joint.wall_modulus: has 3 values, load.vertical_stress 2; write one for each stress level"},
    BadStudy{"a level without normal stiffness", "wall_modulus = 566, 768 MPa", "normal_stiffness = 5, 8, 11 GPa/m",
        "study.ini:12: joint.normal_stiffness: has 3 values, load.vertical_stress 2; write one for each stress level"},
    BadStudy{"a level without shear stiffness", "[unit]", "shear_stiffness = 1, 2, 3 GPa/m\n[unit]",
        "study.ini:14: joint.shear_stiffness: has 3 values, load.vertical_stress 2; write one for each stress level"},
    BadStudy{"a stress level twice", "vertical_stress = 0.15, 0.50 MPa", "vertical_stress = 0.5, 0.50 MPa",
        "study.ini:23: load.vertical_stress: 0.5 MPa is given twice; keep one of them"},
    BadStudy{"joints of no stiffness", "wall_modulus = 566, 768 MPa", "normal_stiffness = 1e-300 GPa/m",
        "study.ini:12: joint.normal_stiffness: times joint.stiffness_factor is below 1 Pa/m; write a larger value"},
    BadStudy{"modulus and stiffness", "[unit]", "normal_stiffness = 8 GPa/m\n[unit]",
        "study.ini:14: joint.normal_stiffness: is given although joint.wall_modulus determines it by Eq. 2; keep one of them"},
    BadStudy{"neither modulus nor stiffness", "wall_modulus = 566, 768 MPa", "",
        "study.ini:11: joint.wall_modulus: missing; write e.g. \"wall_modulus = 768 MPa\" or \"normal_stiffness = 8.08 GPa/m\" under [joint]"},
    BadStudy{"a constant stiffness of joints that close", "wall_modulus = 566, 768 MPa", "normal_stiffness = 5 GPa/m\nclosure = hyperbolic",
        "study.ini:12: joint.normal_stiffness: is that of joints whose joint.closure is linear; write joint.initial_stiffness and joint.maximum_closure in its place"},
    BadStudy{"a law and moduli to fit it to", "[unit]", "closure = hyperbolic\nmaximum_closure = 0.1 mm\n[unit]",
        "study.ini:15: joint.maximum_closure: is given although joint.wall_modulus determines it; keep one of them"},
    BadStudy{"half a law of closure", "wall_modulus = 566, 768 MPa", "closure = exponential\ninitial_stiffness = 5 GPa/m",
        "study.ini:11: joint.maximum_closure: missing; write e.g. \"initial_stiffness = 4.87 GPa/m\" and \"maximum_closure = 0.154 mm\" under [joint], or the wall_modulus of two stresses or more"},
    BadStudy{"one modulus for a law of closure", "wall_modulus = 566, 768 MPa", "wall_modulus = 768 MPa\nclosure = hyperbolic",
        "study.ini:12: joint.wall_modulus: one modulus does not tell how joints close; write those of two stresses or more and joint.wall_modulus_stress, or joint.initial_stiffness and joint.maximum_closure in place of wall_modulus"},
    BadStudy{"moduli of no stress", "wall_modulus = 566, 768 MPa", "wall_modulus = 566, 768, 1057 MPa\nclosure = hyperbolic",
        "study.ini:12: joint.wall_modulus: has 3 values, load.vertical_stress 2; write joint.wall_modulus_stress, the stress of each"},
    BadStudy{"a modulus without its stress", "[unit]", "closure = hyperbolic\nwall_modulus_stress = 0.1, 0.2, 0.3 MPa\n[unit]",
        "study.ini:12: joint.wall_modulus: has 2 values, joint.wall_modulus_stress 3; write one for each stress"},
    BadStudy{"two moduli of one stress", "[unit]", "closure = hyperbolic\nwall_modulus_stress = 0.2, 0.2 MPa\n[unit]",
        "study.ini:15: joint.wall_modulus_stress: moduli under one stress do not tell how joints close; write two stresses or more, or joint.initial_stiffness and joint.maximum_closure in place of wall_modulus"},
    BadStudy{"joints that soften as they close", "wall_modulus = 566, 768 MPa", "wall_modulus = 768, 566 MPa\nclosure = hyperbolic",
        "study.ini:12: joint.wall_modulus: no law of closure has these moduli: k_n by Eq. 2 does not grow with the stress; write other moduli, or joint.initial_stiffness and joint.maximum_closure in place of wall_modulus"},
    BadStudy{"joints of no stiffness at first", "wall_modulus = 566, 768 MPa", "wall_modulus = 166, 768 MPa\nclosure = hyperbolic",
        "study.ini:12: joint.wall_modulus: no law of closure has these moduli: k_n by Eq. 2 grows by more than in proportion to the stress; write other moduli, or joint.initial_stiffness and joint.maximum_closure in place of wall_modulus"},
    BadStudy{"a limit below the first stiffness", "wall_modulus = 566, 768 MPa", "closure = hyperbolic\ninitial_stiffness = 5 GPa/m\nmaximum_closure = 0.1 mm\nlargest_stiffness = 4 GPa/m",
        "study.ini:15: joint.largest_stiffness: must be at least joint.initial_stiffness, 5 GPa/m"},
    BadStudy{"a limit far above the first stiffness", "wall_modulus = 566, 768 MPa", "closure = hyperbolic\ninitial_stiffness = 5 GPa/m\nmaximum_closure = 0.1 mm\nlargest_stiffness = 5001 GPa/m",
        "study.ini:15: joint.largest_stiffness: must be at most 1000 times joint.initial_stiffness, 5000 GPa/m"},
    BadStudy{"joints that hardly close", "wall_modulus = 566, 768 MPa", "closure = hyperbolic\ninitial_stiffness = 5 GPa/m\nmaximum_closure = 1e-7 mm",
        "study.ini:14: joint.maximum_closure: makes joints stiffer than 1e+06 GPa/m under 0.15 MPa; write a larger value"},
    BadStudy{"soft joints that close", "wall_modulus = 566, 768 MPa", "closure = hyperbolic\ninitial_stiffness = 1e-300 GPa/m\nmaximum_closure = 0.1 mm",
        "study.ini:13: joint.initial_stiffness: times joint.stiffness_factor is below 1 Pa/m; write a larger value"},
    BadStudy{"all of the work lost", "[unit]", "closure = hyperbolic\nclosure_loss = 1\n[unit]",
        "study.ini:15: joint.closure_loss: \"1\" is out of range; must be in [0, 1)"},
    BadStudy{"mortar that closes further", "[unit]", "closure = hyperbolic\ncohesion = 0.1 MPa\n[unit]",
        "study.ini:14: joint.closure: the joints have mortar and do not close further; write linear, or remove it"},
    BadStudy{"an unknown closure", "[unit]", "closure = hyperbola\n[unit]",
        "study.ini:14: joint.closure: \"hyperbola\" is not one of linear, hyperbolic or exponential; did you mean \"hyperbolic\"?"},
    BadStudy{"an unknown envelope", "[unit]", "[unit]\nenvelope = mohr",
        "study.ini:15: unit.envelope: \"mohr\" is not one of coulomb or hyperbolic"},
    BadStudy{"no energy in shear, as a number", "[unit]", "[unit]\nshear_fracture_energy = 0 N/m",
        "study.ini:15: unit.shear_fracture_energy: \"0 N/m\" is out of range; must be in (0, 1e+06] N/m"},
    BadStudy{"two damages in mixed modes", "[unit]", "[unit]\nenvelope = hyperbolic\ncontact_law = uncoupled",
        "study.ini:16: unit.contact_law: tension and shear share one damage where unit.envelope is given; write coupled, or remove unit.envelope"},
    BadStudy{"elastic unloading in mixed modes", "[unit]", "cohesion = 0.1 MPa\nshear_fracture_energy = 50 N/m\n[unit]\nunloading = elastic",
        "study.ini:17: unit.unloading: open cracks unload to the origin where joint.shear_fracture_energy is given; write secant, or remove joint.shear_fracture_energy"},
    BadStudy{"a wall as stiff as its stone", "wall_modulus = 566, 768 MPa", "wall_modulus = 566, 15500 MPa",
        "study.ini:12: joint.wall_modulus: 15500 MPa is not below stone.young_modulus, 15.5 GPa; a wall with joints is softer than its stone (Eq. 2)"},
    BadStudy{"a wall all but as stiff as its stone", "wall_modulus = 566, 768 MPa", "wall_modulus = 566, 15499.9999999 MPa",
        "study.ini:12: joint.wall_modulus: 15499.9999999 MPa gives a joint stiffness by Eq. 2 outside 1 Pa/m to 1e+06 GPa/m"},
    BadStudy{"residual cohesion above cohesion", "[beam]", "residual_cohesion = 4 MPa\n[beam]",
        "study.ini:18: unit.residual_cohesion: must be at most unit.cohesion, 3.7 MPa"},
    BadStudy{"residual friction above friction", "[beam]", "residual_friction_angle = 36 deg\n[beam]",
        "study.ini:18: unit.residual_friction_angle: must be at most unit.friction_angle, 35 deg"},
    BadStudy{"friction of a joint that is not there", "[load]", "[base]\nfriction_angle = 30 deg\n[load]",
        "study.ini:23: base.friction_angle: there is no base joint; write wall.base = joint, or remove it"},
    BadStudy{"friction under a beam that is glued", "[load]", "friction_angle = 30 deg\n[load]",
        "study.ini:22: beam.friction_angle: there is no beam joint; write beam.interface = joint, or remove it"},
    BadStudy{"a wall shorter than its units", "length = 1.00 m", "length = 0.15 m",
        "study.ini:2: wall.length: must be at least one wall.unit_length, 0.2 m"},
    BadStudy{"a wall of bricks too many", "length = 1.00 m\ncourses = 10\ncourse_height = 0.10 m\nunit_length = 0.20 m",
        "length = 100 m\ncourses = 200\ncourse_height = 0.10 m\nunit_length = 0.1 m",
        "study.ini:5: wall.unit_length: makes a wall of more than 100000 units; write larger ones"},
    BadStudy{"a sliver of a unit", "length = 1.00 m", "length = 1.0004 m",
        "study.ini:5: wall.unit_length: a unit would be 0.4 mm long; choose wall.length, unit_length and bond so that none is below 1 mm"},
    BadStudy{"a sliver of a bed joint", "[stone]", "bond = 0.498\n[stone]",
        "study.ini:7: wall.bond: a piece of joint would be 0.4 mm long; choose wall.length, unit_length and bond so that none is below 1 mm"},
    BadStudy{"load below the beam", "[load]", "[load]\nheight = 0.95 m",
        "study.ini:23: load.height: must lie within the loading beam, from 1 m to 1.1 m; without this key it is the top of the beam"},
    BadStudy{"cells of units too small", "[unit]", "[unit]\ncracks = voronoi(1 mm)",
        "study.ini:15: unit.cracks: makes about 1000000 pieces of units; write larger cells or fewer pieces, or unit.cracks_where for a part of the wall, so that there are at most 100000"},
    BadStudy{"a wall of bricks too many for its bond", "length = 1.00 m\ncourses = 10\ncourse_height = 0.10 m\nunit_length = 0.20 m",
        "length = 100 m\ncourses = 5\ncourse_height = 0.01 m\nunit_length = 1 mm",
        "study.ini:5: wall.unit_length: makes a wall of more than 100000 units; write larger ones"},
    BadStudy{"cycles without end", "[load]", "[load]\namplitudes = 1, 2 mm\nrepeats = 10000",
        "study.ini:24: load.repeats: makes a path with 40000 turns; ask for fewer cycles, so that there are at most 31250"},
    BadStudy{"pieces of a stone that is all but incompressible", "poisson_ratio = 0.2", "poisson_ratio = 0.4999\n[unit]\ncracks = grid(2, 2)\n[stone]",
        "study.ini:9: stone.poisson_ratio: 0.4999 must be below 0.49, 0.5 (1 - 1 / unit.crack_rigidity), where unit.cracks divides units into pieces with cracks on all sides"},
    BadStudy{"a target twice", "[load]", "[load]\ntargets = 5, 5, -5 mm",
        "study.ini:23: load.targets: 5 mm follows 5 mm; each target must differ from the one before, the first from 0 mm"},
    BadStudy{"amplitudes beside targets", "[load]", "[load]\namplitudes = 5, 10 mm\ntargets = 5, -5 mm",
        "study.ini:23: load.amplitudes: load.targets gives the displacements already; remove one of the two keys"},
    BadStudy{"body forces without gravity", "[load]", "[load]\npattern = body\ngravity = 0 m/s2",
        "study.ini:24: load.gravity: body forces are in proportion to weight; write 9.81 m/s2"},
    BadStudy{"an amplitude of nothing", "[load]", "[load]\namplitudes = 5, 0 mm",
        "study.ini:23: load.amplitudes: \"5, 0 mm\" is out of range; must be in (0, 1000] mm"},
    BadStudy{"amplitudes of both signs", "[load]", "[load]\namplitudes = 5, -10 mm",
        "study.ini:23: load.amplitudes: \"5, -10 mm\" is out of range; must be in (0, 1000] mm"},
    BadStudy{"an amplitude that is no number", "[load]", "[load]\namplitudes = 5, nan mm",
        "study.ini:23: load.amplitudes: \"nan mm\" is not a finite number; write a number and its unit, such as \"1 mm\""},
    BadStudy{"amplitudes without unit", "[load]", "[load]\namplitudes = 5, 10",
        "study.ini:23: load.amplitudes: missing unit; write \"5, 10 mm\""},
    BadStudy{"ten thousand cycles", "[load]", "[load]\namplitudes = 10 mm\nrepeats = 10000",
        "study.ini:25: output.record_every: makes more than 1000000 points; record fewer"},
    BadStudy{"ten thousand small cycles", "[load]", "[load]\namplitudes = 1 mm\nrepeats = 10000",
        "study.ini:25: output.record_every: makes more than 1000000 points; record fewer"},
    BadStudy{"more cycles than steps", "[load]", "[load]\namplitudes = 20 mm\nrepeats = 800\n[output]\nrecord_every = 1 mm\nsnapshot_every = 0 mm\n[load]",
        "study.ini:29: solver.most_steps: is less than the 2.56e+07 steps that a path of 64 m needs at least; ask for fewer cycles, or allow more steps"},
    BadStudy{"an amplitude of another unit", "[load]", "[load]\namplitudes = 5, 10 kN",
        "study.ini:23: load.amplitudes: unit \"kN\" is not a length; use m, cm or mm"},
    BadStudy{"a protocol that does not exist", "[load]", "[load]\nprotocol = atc24",
        "study.ini:23: load.protocol: \"atc24\" is not one of none, fema461 or iso16670"},
    BadStudy{"wear of joints with mortar", "[joint]", "[joint]\ncohesion = 0.1 MPa\nwear_length = 5 mm",
        "study.ini:13: joint.wear_length: the joints have mortar and do not wear; remove it"},
    BadStudy{"wear in no time", "[joint]", "[joint]\nwear_length = 0 mm",
        "study.ini:12: joint.wear_length: \"0 mm\" is out of range; must be in (0, 10000] mm"},
    BadStudy{"one stone that the base holds", "", R"([wall]
length = 0.2 m
courses = 1
course_height = 0.1 m
unit_length = 0.2 m
thickness = 0.2 m
base = fixed
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
normal_stiffness = 8 GPa/m
friction_angle = 31.8 deg
[unit]
cracks = none
[beam]
present = no
[load]
pattern = body
vertical_stress = 0 MPa
)",
        "study.ini:7: wall.base: fixed holds the block at (0.1, 0.05), which touches no other, so that nothing of it can move; write joint, or leave the block out"},
    BadStudy{"a stone on its own that the base holds", "", R"([wall]
outlines = 0 0, 1 0, 1 1, 0 1; 2 0, 3 0, 3 1, 2 1; 0 1, 1 1, 0.5 1.6
thickness = 0.2 m
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
normal_stiffness = 8 GPa/m
friction_angle = 31.8 deg
[beam]
present = no
[load]
pattern = body
vertical_stress = 0 MPa
)",
        "study.ini:1: wall.base: fixed holds the block at (2.5, 0.5), which touches no other, so that nothing of it can move; write joint, or leave the block out"},
    BadStudy{"no vertical stress of a wall without a beam", "", R"([wall]
outlines = 0 0, 1 0, 1 1, 0 1
thickness = 0.2 m
base = joint
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
normal_stiffness = 8 GPa/m
friction_angle = 31.8 deg
[beam]
present = no
[load]
pattern = body
)",
        "study.ini:14: load.vertical_stress: missing; write e.g. \"vertical_stress = 0 MPa\" under [load]"},
    BadStudy{"a stone on an edge of 0.05 mm", "", R"([wall]
outlines = 0 0, 1 0, 1 1, 0 1; 0.99995 1, 2 1, 2 2, 0.99995 2
thickness = 0.2 m
base = joint
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
normal_stiffness = 8 GPa/m
friction_angle = 31.8 deg
[beam]
present = no
[load]
pattern = body
vertical_stress = 0 MPa
)",
        "study.ini:2: wall.outlines: the block at (1.5, 1.5) lies against no other over more than 0.1 mm; draw it against its neighbours"},
    BadStudy{"a curve without points", "[load]", "[output]\nrecord_every = 221 mm\n[load]",
        "study.ini:23: output.record_every: must be at most the path of the push, 220 mm"},
    BadStudy{"a curve of too many points", "[load]", "[output]\nrecord_every = 1e-6 mm\n[load]",
        "study.ini:23: output.record_every: makes more than 1000000 points; record fewer"},
};
// clang-format on

} // namespace

std::span<const BadStudy> bad_studies() { return kStudies; }

std::string text_of(const BadStudy& bad)
{
    if (bad.line.empty()) return std::string(bad.instead);
    std::string text(kGoodStudy);
    return text.replace(text.find(bad.line), bad.line.size(), bad.instead);
}

} // namespace bad_input
