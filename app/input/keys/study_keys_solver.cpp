/// Load, solver and output: keys of the study file.

#include "app/input/keys/push_end.hpp"
#include "app/input/keys/study_key_table.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "dem/scene/mechanism/rigid_wall.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

using dem::Discretisation;
using dem::SolverOptions;

constexpr std::array kPrecisions = {named("double", false), named("single", true)};
constexpr std::array kFaceRules = {named("even", dem::FaceRule::even),
                                   named("lobatto", dem::FaceRule::lobatto)};
constexpr std::array kDampings = {named("local", dem::Damping::local),
                                  named("combined", dem::Damping::combined)};
constexpr std::array kKinematics = {named("small", dem::Kinematics::small),
                                    named("finite", dem::Kinematics::finite)};
constexpr std::array kTopLoads = {
    named("dead", dem::TopLoad::dead), named("fixed_line", dem::TopLoad::fixed_line),
    named("follower", dem::TopLoad::follower), named("link", dem::TopLoad::link)};
constexpr std::array kProtocols = {named("none", dem::Protocol::none),
                                   named("fema461", dem::Protocol::fema461),
                                   named("iso16670", dem::Protocol::iso16670)};
constexpr std::array kScales = {named("given", false), named("one_way", true)};
constexpr std::array kPatterns = {named("beam", dem::LoadPattern::beam),
                                  named("body", dem::LoadPattern::body)};
constexpr std::array kPreloads = {named("solved", dem::Preload::solved),
                                  named("ramped", dem::Preload::ramped)};
constexpr std::array kModes = {named("all", 0), named("rigid", 3)};

/// Top of the beam, or the centre of gravity of what body forces push.
void derive_load_height(Study& s)
{
    const double wall = wall_height(s);
    const double beam = s.beam.present ? s.beam.height : 0.0;
    s.load.height = wall + beam;
    if (s.load.pattern == dem::LoadPattern::beam) return;
    if (!is_full_rectangle(s)) {
        s.load.height =
            dem::gravity_height(whole_units(s, s.source), s.parameters.stone, s.beam.material);
        return;
    }
    const double stone = s.parameters.stone.density * wall,
                 top = s.beam.material.density * beam;
    s.load.height = (0.5 * wall * stone + (wall + 0.5 * beam) * top) / (stone + top);
}

void derive_contact_points(Study& s)
{
    s.discretisation.contact_points = dem::discretisation_of(s.fidelity).contact_points;
}

void derive_block_modes(Study& s)
{
    s.discretisation.block_modes = dem::discretisation_of(s.fidelity).block_modes;
}

constexpr Condition kAlone{
    asks<&Study::load>([](auto& l) { return l.targets.empty() && l.amplitudes.empty(); }),
    "load.targets or load.amplitudes is given"};
constexpr Condition kWithAmplitudes{
    asks<&Study::load>([](auto& l) { return !l.amplitudes.empty(); }),
    "no load.amplitudes are given"};
constexpr Condition kWithProtocol{asks<&Study::load>([](auto& l) {
                                      return l.targets.empty() && l.amplitudes.empty() &&
                                             l.protocol != dem::Protocol::none;
                                  }),
                                  "no load.protocol is followed"};
constexpr Condition kWithWeight{asks<&Study::parameters, &Study::beam>([](auto& p, auto& b) {
                                    return p.stone.density > 0.0 || b.material.density > 0.0;
                                }),
                                "stone and beam have no weight"};
constexpr Condition kWithSeries{asks<&Study::output>([](auto& o) { return o.paraview; }),
                                "output.paraview is no"};
constexpr Condition kByFidelity{asks<&Study::source>([](auto& f) {
                                    return !is_given(f, "solver.contact_points") ||
                                           !is_given(f, "solver.block_modes");
                                }),
                                "solver.contact_points and solver.block_modes are given"};
constexpr Condition kSlowingDrive{
    asks<&Study::solver>([](auto& o) { return o.unbalance_limit > 0.0; }),
    "solver.unbalance_limit is 0"};

constexpr Range kModeCount{'[', 3, 1000, ']'}; // [-]

constexpr std::array kLoadMasses = {named("none", dem::LoadMass::none),
                                    named("floor", dem::LoadMass::floor)};
constexpr Condition kWithShakenLoad{
    asks<&Study::shaking, &Study::load>([](auto& k, auto& l) {
        return !k.records.empty() &&
               std::ranges::any_of(l.vertical_stress, [](double x) { return x > 0.0; });
    }),
    "no ground moves, or there is no vertical load"};

constexpr std::array kDirections = {named("right", Direction::right),
                                    named("left", Direction::left),
                                    named("both", Direction::both)};
/// Right and both are left out of configurations and of the identity: they move no wall of a
/// study.
constexpr Condition kToTheLeft{
    asks<&Study::load>([](auto& l) { return l.direction == Direction::left; }), ""};

// clang-format off
constexpr std::array kSolverKeys = {
    Key{.name = "load.vertical_stress", .kind = Kind::list, .unit = "MPa", .range = kStrength,
        .example = "0.50 MPa",
        .meaning = "stress levels, through the beam on length x thickness",
        .field = kAt<&Study::load, &LoadInput::vertical_stress>},
    Key{.name = "load.height", .unit = "m", .range = {'(', 0, 10010, ']'},
        .derived = {"top of the beam; of body forces the centre of gravity", derive_load_height},
        .meaning = "height of the horizontal load above the floor, within the beam; drifts are displacements over it",
        .field = kAt<&Study::load, &LoadInput::height>},
    Key{.name = "load.mass", .kind = Kind::word, .names = kLoadMasses, .used = kWithShakenLoad,
        .verbs = "study shake", .example = "floor",
        .meaning = "of a wall that is shaken, the vertical load: floor, the weight of a mass that moves with the top; none, a force, as of a jack or a tendon",
        .field = kAt<&Study::load, &LoadInput::mass>},
    Key{.name = "load.max_displacement", .unit = "mm", .range = {'(', 0, 1000, ']'},
        .effect = kAlone,
        .derived = {"a fifth of height; small or in cycles 30 mm", derive_push_end},
        .meaning = "largest displacement of the load line; targets and amplitudes replace it",
        .field = kAt<&Study::load, &LoadInput::max_displacement>},
    Key{.name = "load.targets", .kind = Kind::list, .unit = "mm", .range = {'[', -1000, 1000, ']'},
        .derived = {"max_displacement"},
        .meaning = "displacements visited in order; cyclic pushes change sign",
        .field = kAt<&Study::load, &LoadInput::targets>},
    Key{.name = "load.direction", .kind = Kind::word, .names = kDirections, .used = kToTheLeft,
        .meaning = "side to which the wall is pushed; left: the mirror image of a push to the right; both: a wall that is not symmetric is"
                   " pushed to either side, a symmetric one to the right; without this key a study pushes right, and so does a push"
                   " that takes half a minute of a core or more",
        .field = kAt<&Study::load, &LoadInput::direction>},
    Key{.name = "load.amplitudes", .kind = Kind::list, .unit = "mm", .range = {'(', 0, 1000, ']'},
        .derived = {"no cycles"},
        .meaning = "amplitudes of cycles, each to the right and to the left, in order; the push ends at zero",
        .field = kAt<&Study::load, &LoadInput::amplitudes>},
    Key{.name = "load.repeats", .kind = Kind::count, .range = {'[', 1, 10000, ']'},
        .effect = kWithAmplitudes,
        .meaning = "cycles of each amplitude",
        .field = kAt<&Study::load, &LoadInput::repeats>},
    Key{.name = "load.protocol", .kind = Kind::word, .names = kProtocols,
        .effect = kAlone,
        .meaning = "cycles as a standard has them, up to load.max_displacement: fema461 (ten"
                   " amplitudes of two cycles) or iso16670 (five of one cycle, five of three)",
        .field = kAt<&Study::load, &LoadInput::protocol>},
    Key{.name = "load.protocol_scale", .kind = Kind::word, .names = kScales,
        .effect = kWithProtocol,
        .meaning = "largest amplitude of the protocol; given: load.max_displacement; one_way: the ultimate displacement"
                   " of the mean wall pushed one way, the largest over the stress levels",
        .field = kAt<&Study::load, &LoadInput::scale_one_way>},
    Key{.name = "load.stop_below", .range = {'[', 0, 1, ')'},
        .derived = {"once all limits are known, or 0", derive_stop_below},
        .meaning = "ends the push once the force is below this share of the peak; 0: at zero force"
                   " with finite displacements, else never; not given, of a finite push one way: 0.02"
                   " below the least share that a limit state asks for",
        .field = kAt<&Study::load, &LoadInput::stop_below>},
    Key{.name = "load.pattern", .kind = Kind::word, .names = kPatterns,
        .meaning = "what pushes: the beam at its load line, or body: forces on all blocks in proportion to"
                   " their weight; displacements are then the mean of the wall by weight",
        .field = kAt<&Study::load, &LoadInput::pattern>},
    Key{.name = "load.top", .kind = Kind::word, .names = kTopLoads,
        .meaning = "how the vertical load follows the beam: dead (moves with it), fixed_line (in"
                   " space), follower (normal to it), link (docs/theory.md)",
        .field = kAt<&Study::load, &LoadInput::top>},
    Key{.name = "load.link_length", .unit = "m", .range = {'[', -1000, 1000, ']'},
        .meaning = "length of the link of load.top = link: positive for a strut to a hinge above, negative for a tendon to one"
                   " below",
        .field = kAt<&Study::load, &LoadInput::link_length>},
    Key{.name = "load.gravity", .unit = "m/s2", .range = {'[', 0, 100, ']'},
        .effect = kWithWeight,
        .meaning = "acceleration of free fall",
        .field = kAt<&Study::load, &LoadInput::gravity>},

    Key{.name = "solver.fidelity", .kind = Kind::word, .names = kFidelities,
        .effect = kByFidelity,
        .meaning = "how finely blocks deform, from rigid blocks to fine zones (docs/bench/accuracy/paper_walls.md)",
        .field = kAt<&Study::fidelity>},
    Key{.name = "solver.kinematics", .kind = Kind::word, .names = kKinematics,
        .meaning = "small displacements (paper, section 2.1), or finite: blocks turn and slide by any"
                   " amount",
        .field = kAt<&Study::solver, &SolverOptions::kinematics>},
    Key{.name = "solver.accuracy", .unit = "%", .range = {'(', 0, 50, ']'},
        .meaning = "accepted error of forces and limit displacements; the program chooses the speed of the push by it",
        .field = kAt<&Study::solver, &SolverOptions::accuracy>},
    Key{.name = "solver.contact_points", .kind = Kind::count, .range = {'[', 2, 100, ']'},
        .derived = {"of fidelity", derive_contact_points},
        .meaning = "number of contact points per face of a half unit",
        .field = kAt<&Study::discretisation, &Discretisation::contact_points>},
    Key{.name = "solver.face_rule", .kind = Kind::word, .names = kFaceRules,
        .meaning = "contact points evenly spaced, or Gauss-Lobatto",
        .field = kAt<&Study::discretisation, &Discretisation::face_rule>},
    Key{.name = "solver.zones_per_interval", .kind = Kind::count, .range = {'[', 1, 100, ']'},
        .meaning = "block zones between two contact points",
        .field = kAt<&Study::discretisation, &Discretisation::zones_per_interval>},
    Key{.name = "solver.block_modes", .kind = Kind::count, .range = kModeCount, .names = kModes,
        .derived = {"of fidelity", derive_block_modes},
        .meaning = "deformation modes of a block: rigid 3, simply deformable 6, ... all",
        .field = kAt<&Study::discretisation, &Discretisation::block_modes>},
    Key{.name = "solver.beam_modes", .kind = Kind::count, .range = kModeCount, .names = kModes,
        .meaning = "deformation modes of the loading beam",
        .field = kAt<&Study::discretisation, &Discretisation::beam_modes>},
    Key{.name = "solver.damping", .kind = Kind::word, .names = kDampings,
        .meaning = "local (paper, Eq. 1), or combined: no drag on steady motion",
        .field = kAt<&Study::solver, &SolverOptions::damping>},
    Key{.name = "solver.damping_factor", .range = {'(', 0, 1, ')'},
        .meaning = "gamma of Eq. 1",
        .field = kAt<&Study::solver, &SolverOptions::damping_factor>},
    Key{.name = "solver.step_fraction", .range = {'(', 0, 1, ']'},
        .meaning = "time step as a share of the largest stable step",
        .field = kAt<&Study::solver, &SolverOptions::step_fraction>},
    Key{.name = "solver.steps_per_mm", .range = {'[', 1, 1e9, ']'},
        .meaning = "fewest explicit steps per millimetre of the load line: the fastest speed of the push",
        .field = kAt<&Study::solver, &SolverOptions::steps_per_mm>},
    Key{.name = "solver.preload", .kind = Kind::word, .names = kPreloads,
        .meaning = "solved: the vertical load comes from the static solution; ramped: by a ramp",
        .field = kAt<&Study::solver, &SolverOptions::preload>},
    Key{.name = "solver.preload_steps", .kind = Kind::count, .range = {'[', 1, 1e12, ']'},
        .meaning = "largest number of steps to come to rest under the vertical load",
        .field = kAt<&Study::solver, &SolverOptions::preload_steps>},
    Key{.name = "solver.preload_unbalance", .range = {'(', 0, 1, ')'},
        .meaning = "unbalanced / applied load at which the vertical load counts as carried",
        .field = kAt<&Study::solver, &SolverOptions::preload_unbalance>},
    Key{.name = "solver.unbalance_limit", .range = {'[', 0, 1, ']'},
        .meaning = "|top - base shear| above which the push slows down,"
                   " as a share of the accepted error (accuracy x the largest force so far); 0: a constant speed, by steps_per_mm",
        .field = kAt<&Study::solver, &SolverOptions::unbalance_limit>},
    Key{.name = "solver.min_speed", .range = {'(', 0, 1, ']'},
        .effect = kSlowingDrive,
        .meaning = "slowest speed of a wall out of balance, as a share of its speed in balance",
        .field = kAt<&Study::solver, &SolverOptions::min_speed>},
    Key{.name = "solver.energy_tolerance", .range = {'(', 0, 1, ')'},
        .meaning = "largest energy residual; above it the step is halved; if that does not help, the wall has failed",
        .field = kAt<&Study::solver, &SolverOptions::energy_tolerance>},
    Key{.name = "solver.most_steps", .kind = Kind::count, .range = {'[', 1, 1e12, ']'},
        .meaning = "largest number of steps of one wall; a wall that needs more has failed",
        .field = kAt<&Study::solver, &SolverOptions::most_steps>},

    Key{.name = "output.record_every", .unit = "mm", .range = {'(', 0, 1000, ']'},
        .meaning = "spacing of the points of the capacity curve",
        .field = kAt<&Study::output, &OutputInput::record_every>},
    Key{.name = "output.snapshot_every", .unit = "mm", .range = {'[', 0, 1000, ']'},
        .effect = kWithSeries,
        .verbs = "push",
        .derived = {"0.5 mm, or 100 on the way", derive_snapshots},
        .meaning = "spacing of the ParaView series, at most one for each point of the curve; 0: only the peak and the end",
        .field = kAt<&Study::output, &OutputInput::snapshot_every>},
    Key{.name = "output.paraview", .kind = Kind::word, .names = kYesNo,
        .verbs = "push shake",
        .meaning = "a series for ParaView in the folder series; of a wall that is shaken 20 in a second, and only where a study says yes",
        .field = kAt<&Study::output, &OutputInput::paraview>},
    Key{.name = "output.curves", .kind = Kind::word, .names = kPrecisions,
        .verbs = "study",
        .meaning = "precision of the curves in the file of a study; single: half the size",
        .field = kAt<&Study::output, &OutputInput::single_precision_curves>},
};
// clang-format on

} // namespace

std::span<const Key> solver_keys() { return kSolverKeys; }

} // namespace app
