#pragma once
/// Studies that several tests read.

#include "app/bad_input/cases.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include <string>
#include <vector>

namespace study_texts {

/// Two rigid stones under a beam, with random friction, shaken in no time. A test adds load,
/// ground and samples.
inline const char* const kShakenWall = R"([wall]
length = 0.40 m
courses = 2
course_height = 0.20 m
unit_length = 0.40 m
thickness = 0.20 m
bond = stack
toe = free
unit_cracks = no
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
normal_stiffness = 1 GPa/m
friction_angle = normal(mean 25 deg, cov 0.2)
[beam]
height = 0.10 m
young_modulus = 30 GPa
density = 2400 kg/m3
)";

/// A wall that is pushed in no time: rigid stones on a base joint, random friction, one stress.
inline const char* const kSmallWall = R"([wall]
length = 0.60 m
courses = 3
course_height = 0.10 m
unit_length = 0.20 m
thickness = 0.20 m
base = joint
unit_cracks = no
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
wall_modulus = 768 MPa
friction_angle = normal(mean 30 deg, cov 0.1)
[unit]
tensile_strength = 3.7 MPa
fracture_energy = 110 N/m
friction_angle = 35 deg
[beam]
height = 0.10 m
young_modulus = 30 GPa
density = 2400 kg/m3
[load]
vertical_stress = 0.50 MPa
max_displacement = 1 mm
[solver]
fidelity = rigid
steps_per_mm = 100
accuracy = 50 %
)";

/// A value for every key that can stand beside the others; it differs from the default where
/// its law can stand beside theirs.
inline const char* const kEverything = R"([wall]
length = 120 cm
courses = 8
course_height = 150 mm
unit_length = 0.30 m
thickness = 0.25 m
bond = 0.25
unit_length_cov = 0.05
seed = 3
layouts = 1
first_course = shifted
unit_cracks = yes
openings = 0.3 m, 0 m, 0.6 m, 0.6 m
base = joint
toe = free
[lintel]
bearing = 0.2 m
young_modulus = 30 GPa
poisson_ratio = 0.3
density = 2500 kg/m3
[stone]
young_modulus = 20 GPa
poisson_ratio = 0.25
density = 2000 kg/m3
[joint]
normal_stiffness = 5.87, 8.08 GPa/m
shear_stiffness = 2 N/mm3
friction_angle = 30 deg
stiffness_factor = 1.1
closure = linear
tensile_strength = 0.1 MPa
cohesion = 0.2 MPa
fracture_energy = 10 N/m
envelope = coulomb
shear_fracture_energy = none
compressive_strength = 60 MPa
crushing_energy = 20000 N/m
[unit]
compressive_strength = 80 MPa
crushing_energy = 30000 N/m
cracks = voronoi(100 mm)
cracks_where = toe
cracks_elsewhere = thirds
cracks_seed = 4
crack_rigidity = 6
stiffness_ratio = 12
tensile_strength = 3 MPa
cohesion = 4 MPa
residual_cohesion = 0.1 MPa
fracture_energy = 0.1 N/mm
friction_angle = 0.7 rad
residual_friction_angle = 33 deg
stiffness_factor = 0.9
contact_law = uncoupled
envelope = coulomb
shear_fracture_energy = none
tension_reduces_shear = no
snap_back = weakens
unloading = elastic
[beam]
present = yes
height = 0.20 m
young_modulus = 25 GPa
poisson_ratio = 0.15
density = 2500 kg/m3
interface = joint
friction_angle = 40 deg
rotation = fixed
[base]
friction_angle = 25 deg
[load]
vertical_stress = 150 kPa, 0.5 MPa
height = 1.3 m
max_displacement = 2 cm
targets = 5, -5, 10, -10 mm
direction = right
repeats = 1
protocol = none
protocol_scale = given
stop_below = 0
pattern = beam
top = link
link_length = -2 m
gravity = 9.80665 m/s2
[solver]
fidelity = simple
kinematics = finite
accuracy = 2 %
contact_points = 5
face_rule = lobatto
zones_per_interval = 3
block_modes = 6
beam_modes = rigid
damping = local
damping_factor = 0.7
step_fraction = 0.5
steps_per_mm = 2e3
preload = ramped
preload_steps = 4000
preload_unbalance = 1e-5
unbalance_limit = 0.01
min_speed = 0.1
energy_tolerance = 0.02
most_steps = 1000000
[output]
record_every = 0.1 mm
snapshot_every = 0 mm
curves = single
paraview = no
[uq]
design = sobol
samples = 7
seed = 3
shared = yes
spatial = correlated
kernel = exponential_l1
correlation_length = 0.4, 0.2 m
matern_nu = 2.5
group_correlation = 0.3
stop = peak_force
stop_half_width = 0.02
most_samples = 500
audit = 3
pearson = joint.friction_angle joint.stiffness_factor 0.3
[reliability]
method = form
response = ultimate_drift
demand = 1.2
budget = 500
target_cov = 0.05
cheap = simple
[fragility]
limit_states = ec8, user
user_states = slight: 0.7 yield; heavy: 0.5 yield + 0.5 ultimate
crossing = last
ultimate_share = 0.85
bilinear_share = 0.7
backbone = worse
law = weibull
confidence = 0.9
bootstrap = 200
modes = two
rotation_share = 0.4
cracked_units = 2
model_factor = lognormal(median 0.8, sigma_log 0.4)
model_factor_force = none
)";

inline app::Study read(const std::string& text, const std::vector<std::string>& overrides = {})
{
    return app::prepare(app::read_study(app::with_overrides(
                            app::parse_study_text("study.ini", text), overrides)))
        .study;
}

inline app::Study read_good(const std::vector<std::string>& overrides = {})
{
    return read(std::string(bad_input::kGoodStudy), overrides);
}

inline dem::JointMaterial joint_material(const app::Study& s, int level)
{
    return app::joint_material(s.parameters, s.wall.course_height,
                               app::stress_level(s.load, level));
}

inline dem::CrackMaterial crack_material(const app::Study& s, int level)
{
    return app::crack_material(s.parameters, s.wall.course_height,
                               app::stress_level(s.load, level));
}

inline dem::Layout laid(const app::Study& s) { return app::layout_of(s, s.source); }

/// All values as in the study, under its stress level `level`.
inline dem::WallMaterials materials(const app::Study& s, int level)
{
    return app::materials(s.parameters, s.wall.course_height, app::stress_level(s.load, level),
                          laid(s));
}

/// Joints that close by one law, fitted to the four wall moduli of the paper.
inline const std::vector<std::string> kFitted = {
    "joint.closure=hyperbolic", "joint.wall_modulus=566, 768, 1057, 1202 MPa",
    "joint.wall_modulus_stress=0.15, 0.50, 1.00, 1.25 MPa"};

/// The same law as two numbers.
inline const std::vector<std::string> kClosing = {"joint.closure=exponential",
                                                  "joint.initial_stiffness=4.87 GPa/m",
                                                  "joint.maximum_closure=0.154 mm"};

inline std::vector<std::string> with(std::vector<std::string> keys,
                                     const std::vector<std::string>& more)
{
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

} // namespace study_texts
