#pragma once
/// A study: everything one run needs, in SI, each value checked against its range and its
/// fellows.

#include "app/input/study/parameters.hpp"
#include "app/input/study/study_file.hpp"
#include "dem/block/discretisation.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "dem/scene/paper_materials.hpp"
#include "dem/scene/wall.hpp"
#include "dem/shaking/load_mass.hpp"
#include "dem/solver/cyclic_protocol.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/state/solver_options.hpp"
#include "fragility/codes/code.hpp"
#include "fragility/curve/bilinear.hpp"
#include "fragility/curve/curve_reading.hpp"
#include "fragility/curve/cyclic_curve.hpp"
#include "fragility/laws/law.hpp"
#include "uq/designs/design_kind.hpp"
#include "uq/marginals/marginal.hpp"
#include "uq/reliability/reliability_method.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// A wall that is drawn, or of rubble, in place of courses.
struct GeometryInput {
    bool rubble = false;              ///< random stones fill the wall
    int layouts = 1;                  ///< random ones, which the samples take in turn
    int material = 0;                 ///< index in kMaterialNames; 0: none
    std::string file;                 ///< drawing or picture; empty: none
    std::string outlines;             ///< in place of a file, as outlines_text() writes them
    double length_unit = 1e-3;        ///< of the drawing [m]
    double snap = 5e-4;               ///< gaps and overlaps that are closed [m], >= 0
    bool close_outlines = false;      ///< open outlines of four corners or more
    double picture_width = 0.0;       ///< [m]; 0: not given
    double picture_height = 0.0;      ///< [m]; 0: not given
    double simplify = 5e-3;           ///< tolerance of outlines traced from a picture [m], >= 0
    std::string openings;             ///< in courses: "x, z, width, height; ..."
    std::string layer_stones;         ///< "NAME: E, Poisson's ratio, density; ..."
    std::vector<std::string> layers;  ///< whose stone is not the wall's
    std::vector<dem::Elastic> stones; ///< of these layers
    std::vector<dem::DrawnUnit> units; ///< what was read, or the stones of rubble once grown
    std::vector<std::string>
        drawn_layers;               ///< all of a drawing; the layers of units count from 1
    std::vector<std::string> notes; ///< what was closed, simplified or ignored on the way
};

/// Where units may crack, as text (unit_cracks.hpp).
struct CrackInput {
    bool in_units = true;
    std::string pattern;      ///< "grid(4, 4)"; empty: mid, or none where not in_units
    std::string where;        ///< "toe", or "x, z, width, height"; empty: everywhere
    std::string elsewhere;    ///< a pattern; empty: mid
    bool cut_nothing = false; ///< a drawn wall has no unit that the patterns cut
};

/// Where a wall is pushed; `left` mirrors all displacements of the push.
enum class Direction {
    right,
    left,
    both ///< each wall once to either side where the mirrored wall is another one, else right
};

struct LoadInput {
    std::vector<double> vertical_stress; ///< stress levels [Pa], >= 0, at least one
    double height =
        0.0; ///< of the horizontal load, or of the resultant of body forces, above the floor [m]
    /// Why the height that was given cannot be, in a study read to be drawn: `height` is its
    /// default then.
    std::string unfit_height;
    double max_displacement = dem::PushPlan{}.targets.front(); ///< of the load line [m], > 0
    std::vector<double>
        targets; ///< displacements visited in order [m]; empty: max_displacement
    std::vector<double> amplitudes; ///< of cycles, in order [m], > 0; empty: no cycles
    int repeats = 1;                ///< cycles of each amplitude, >= 1
    dem::Protocol protocol =
        dem::Protocol::none;    ///< none: one way, or as amplitudes or targets say
    bool scale_one_way = false; ///< of the protocol, see app/input/protocol_scale.hpp
    std::string
        scaled; ///< the ultimate displacements behind the scaled protocol, as text; empty: not scaled
    double gravity = dem::Loads{}.gravity; ///< [m/s2], >= 0
    /// Share of the peak that ends the push [-], in [0, 1); 0: zero force with finite
    /// displacements, never with small ones. See app/input/keys/push_end.hpp.
    double stop_below = 0.0;
    dem::TopLoad top = dem::Loads{}.top;
    double link_length = dem::Loads{}.link_length; ///< [m], of TopLoad::link
    dem::LoadPattern pattern = dem::Loads{}.pattern;
    dem::LoadMass mass = dem::LoadMass::none; ///< of a wall that is shaken
    Direction direction = Direction::both;
};

struct OutputInput {
    double record_every = dem::PushPlan{}.record_every; ///< [m], > 0
    double snapshot_every = 5e-4;         ///< [m], >= 0; 0: only the peak and the end
    bool paraview = true;                 ///< whether `push` writes a series
    bool single_precision_curves = false; ///< of a study's file: half the size, 7 digits
};

/// A key whose value is a distribution.
struct RandomInput {
    std::string key;                ///< "joint.friction_angle"
    std::string_view unit;          ///< in which people read it: "deg"; empty: none
    ParameterPlace place = nullptr; ///< nullptr: a variable of another program
    uq::Marginal marginal;          ///< in SI, cut off at the range of the key
    double mean = 0.0;              ///< of the distribution as given, before that cut
    double cut = 0.0;               ///< probability outside that range before the cut [-]
    Varies varies = Varies::by_wall;
};

enum class Spatial {
    none,        ///< one value per wall
    independent, ///< one per joint, from a design over walls and joints
    stratified,  ///< one per joint, a Latin hypercube over the joints inside each wall
    correlated   ///< one per joint, a random field over the joints
};

enum class FieldKernel {
    exponential,
    squared_exponential,
    exponential_l1,
    matern,
    same_course, ///< uq.group_correlation between joints of one course, 0 between courses
    same_unit,   ///< the same of one unit
    all          ///< the same of the whole wall
};

/// Quantity that a stopping rule looks at: uq.samples alone, or a row of kWallNumbers, or the
/// share of mixed walls.
constexpr int kNoStop = -1, kStopAtMixedShare = -2;

struct UqInput {
    uq::DesignKind design = uq::DesignKind::latin_random;
    int samples = 50;       ///< walls per stress level, >= 1
    std::uint64_t seed = 1; ///< of the design
    bool shared = false;    ///< the same samples under every stress level
    Spatial spatial = Spatial::none;
    FieldKernel kernel = FieldKernel::exponential;
    std::vector<double> correlation_length; ///< [m]; two for exponential_l1: along x and z
    double matern_nu = 1.5;                 ///< smoothness [-]
    double group_correlation = 0.5;         ///< [-], in [0, 1]
    int stop = kNoStop;            ///< kNoStop, kStopAtMixedShare or a row of kWallNumbers
    double stop_half_width = 0.05; ///< of the 95 % interval [-], > 0
    int most_samples = 1000;       ///< upper limit of the stopping rule
    int audit = 0;        ///< walls of each stress that are pushed again more slowly, >= 0
    std::string pearson;  ///< "joint.friction_angle joint.stiffness_factor 0.3, ..."
    std::string together; ///< keys whose empirical values are read row by row; empty: none
    std::string drawn;    ///< one wall alone (app/study/pushed/drawn_wall.hpp); empty: all
};

using uq::ReliabilityMethod;

/// For the verb reliability: the probability that a response falls to a demand or below.
struct ReliabilityInput {
    ReliabilityMethod method = ReliabilityMethod::monte_carlo;
    int response = 0;         ///< row of kWallNumbers (app/reading/wall_numbers.hpp)
    std::string demand;       ///< "40 kN", "15 mm", or a drift in percent: "1.2"
    double quantile = 0.0;    ///< asked for in place of a demand [-]; 0: none
    int budget = 1000;        ///< evaluations at most, >= 10
    double target_cov = 0.10; ///< stop once the probability is known as well [-]
    dem::Fidelity cheap = dem::Fidelity::rigid; ///< of the cheap model
};

enum class KeepRuns { none, failed, all };

/// For the verb reliability: another program in place of a wall (docs/external_program.md).
struct ProgramInput {
    std::string command;            ///< program and arguments
    std::string responses;          ///< names of what it answers, between commas
    int concurrent = 0;             ///< runs at a time; 0: as many as threads
    double time_limit = 0.0;        ///< of one run [s]; 0: none
    double grace = 2.0;             ///< from SIGTERM to SIGKILL [s]
    int retries = 0;                ///< of a run that failed
    KeepRuns keep = KeepRuns::none; ///< directories of runs
    std::string response;           ///< one of `responses`; empty: the first
    double demand = 0.0;            ///< in the unit of the program
    bool above = false;             ///< the event is to reach the demand, else to fall to it
};

/// Which walls of a study are shaken by which records.
enum class ShakingDesign {
    crossed, ///< each wall by each record
    paired   ///< wall k by record k, and by the first ones again after the last
};

/// Motions of the ground, as text: the verbs shake and study read them
/// (app/shake/shaking_motions.hpp).
struct ShakingInput {
    std::string records;         ///< files and pulses, with commas between; empty: none
    std::string intensities;     ///< of `measure`, with commas between; empty: motions as given
    std::string measure = "pga"; ///< or pgv, sa(T)
    std::string vertical = "none"; ///< a file or a pulse
    double scale = 1.0;            ///< on all motions [-], > 0
    double contact_damping = 0.0;  ///< zeta of dry joints [-], >= 0
    bool push = false;             ///< each wall is pushed as well, for its drift limit
    ShakingDesign design = ShakingDesign::crossed;
};

/// For the verb calibrate: which inputs tests shall teach, and how far the model may be wrong.
struct CalibrationInput {
    std::string inputs;      ///< keys between commas, or "all"; empty: a factor alone
    bool discrepancy = true; ///< of the model under each stress
    double scatter = 0.25;   ///< scale of half-normal priors, of ln [-], > 0
};

/// How walls are read, by every verb. Moves no wall.
struct FragilityInput {
    std::string limit_states = "paper, ntc"; ///< sets: codes, user
    std::string codes;                       ///< a file of codes, or its text; empty: none
    std::vector<fragility::Code> own_codes;  ///< read from `codes`
    std::string user_states;                 ///< "slight: 0.7 yield; severe: drop 0.5; ..."
    fragility::Crossing crossing = fragility::Crossing::first; ///< of the ultimate share
    double ultimate_share = fragility::kUltimateShare;         ///< of the peak [-], in (0, 1)
    double bilinear_share = fragility::kBilinearShare;         ///< of the peak [-], in (0, 1]
    fragility::Side backbone = fragility::Side::mean;          ///< of a push that turns back
    fragility::Law law = fragility::Law::lognormal;
    double confidence = 0.95; ///< of intervals [-], in (0, 1)
    int bootstrap = 1000;     ///< samples behind p-values, >= 0; 0: none
    dem::ModeThresholds mode;
    std::string model_factor =
        "tests"; ///< of limit drifts (app/input/study/model_factor_text.hpp)
    std::string model_factor_force = "tests"; ///< of peak forces
    // Damage states of walls that were shaken, as drifts [-], > 0.
    std::vector<double> shaken_drifts = {0.005, 0.01};
    std::vector<double> shaken_residuals = {0.002}; ///< after the shaking
    double shaken_uplift = 0.5; ///< share of the lowest joint that opens, in [0, 1)
    double pushed_limit = 0.0;  ///< drift limit of a push: 80 % of it is a state; 0: none
};

struct Study {
    dem::WallGeometry wall;
    GeometryInput geometry;
    CrackInput cracks;
    Parameters parameters;
    dem::Beam beam{.material = {.poisson_ratio = 0.2}}; // choice: concrete
    LoadInput load;
    dem::Fidelity fidelity = dem::Fidelity::standard;
    dem::Discretisation discretisation;
    dem::SolverOptions solver{.kinematics = dem::Kinematics::finite}; // a study asks for limits
    OutputInput output;
    UqInput uq;
    ReliabilityInput reliability;
    ProgramInput program;
    CalibrationInput calibration;
    FragilityInput fragility;
    std::vector<RandomInput> random;  ///< in the order of the keys; the fields hold their means
    std::vector<ParameterRule> rules; ///< for parameters that were not given and follow others
    ShakingInput shaking;
    StudyFile source; ///< what was given
};

/// @param level index in study.load.vertical_stress
[[nodiscard]] StressLevel stress_level(const Study& study, int level);

/// @param level index in study.load.vertical_stress
[[nodiscard]] dem::Loads loads(const Study& study, int level);

/// Without progress.
[[nodiscard]] dem::PushPlan push_plan(const Study& study);

/// Where a push goes.
struct PushWay {
    int direction = 1;     ///< 1: to the right, -1: to the left, 0: it turns back
    double farthest = 0.0; ///< largest distance from the start [m]
    double length = 0.0;   ///< of the whole way [m]
    int turns = 0;
};
[[nodiscard]] PushWay push_way(const Study& study);

/// The same study with every displacement of its push to the other side; a toe that is held
/// changes sides with a push that goes one way.
[[nodiscard]] Study turned_round(Study study);

} // namespace app
