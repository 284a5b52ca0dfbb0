/// Every key of a study changes what a push gives, or the program says that it has no effect.

#include "app/input/key_effects.hpp"
#include "app/input/keys/key_values.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/study/pushed/push_walls.hpp"

#include "dem/block/model.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

using app::Key;
using app::Study;

constexpr app::Verb kPush{
    .name = "push",
    .sections = "wall lintel stone joint unit beam base load solver output uq fragility"};

const std::string kWall = R"([wall]
length = 0.60 m
courses = 3
course_height = 0.10 m
unit_length = 0.20 m
thickness = 0.20 m
)";

/// Weak units on weak joints: everything that can crack does.
const std::string kAll = kWall + R"(base = joint
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
wall_modulus = 768, 1057 MPa
friction_angle = normal(mean 40 deg, cov 0.10)
stiffness_factor = normal(mean 1, cov 0.25)
[unit]
tensile_strength = 0.02 MPa
cohesion = 0.2 MPa
residual_cohesion = 0.01 MPa
fracture_energy = 0.002 N/m
friction_angle = 35 deg
residual_friction_angle = 30 deg
[beam]
height = 0.10 m
young_modulus = 30 GPa
density = 2400 kg/m3
interface = joint
friction_angle = 45 deg
[base]
friction_angle = 40 deg
[load]
vertical_stress = 0.50, 1.00 MPa
max_displacement = 2 mm
[solver]
fidelity = rigid
kinematics = small
steps_per_mm = 500
accuracy = 50 %
[output]
record_every = 0.1 mm
snapshot_every = 1 mm
[uq]
samples = 3
)";

const std::string kCorrelated = kAll + "spatial = correlated\nkernel = matern\n"
                                       "correlation_length = 0.3 m\n";

/// Mortar, headers, courses of heights of their own, a window; units do not crack.
const std::string kMortar = [] {
    std::string text = kAll;
    const auto after = [&](std::string_view section, std::string_view keys) {
        text.insert(text.find(section) + section.size(), keys);
    };
    after("[joint]\n", "tensile_strength = 0.005 MPa\ncohesion = 0.3 MPa\n"
                       "fracture_energy = 0.01 N/m\n");
    text.erase(text.find("courses"), text.find("unit_length") - text.find("courses"));
    after("[wall]\n", "unit_cracks = no\nbond = flemish\ncourse_heights = 0.12, 0.08, 0.1 m\n"
                      "openings = 0.2 m, 0.12 m, 0.2 m, 0.08 m\n");
    return text;
}();

/// Blocks that are drawn, one of another stone.
const std::string kDrawn = R"([wall]
outlines = 0 0, 0.3 0, 0.25 0.15, 0 0.15; sill: 0.3 0, 0.6 0, 0.6 0.15, 0.25 0.15; 0 0.15, 0.6 0.15, 0.6 0.3, 0 0.3
layer_stones = sill: 30 GPa, 0.2, 2500 kg/m3
)" + kAll.substr(kAll.find("thickness"));

/// Units in cells at the bottom, in quarters above, whose stiff cracks snap back.
const std::string kCells = [] {
    std::string text = kAll;
    const std::string_view energy = "fracture_energy = 0.002 N/m";
    text.replace(text.find(energy), energy.size(), "fracture_energy = 0.000015 N/m");
    const std::string_view unit = "[unit]\n";
    text.insert(text.find(unit) + unit.size(),
                "cracks = voronoi(70 mm)\ncracks_where = 0 m, 0 m, 0.6 m, 0.1 m\n"
                "cracks_elsewhere = grid(2, 2)\n");
    return text;
}();

/// Joints and units that crush.
const std::string kCrushing = [] {
    std::string text = kAll;
    const auto crush = [&](std::string_view section, const std::string& strength) {
        text.insert(text.find(section) + section.size(),
                    "compressive_strength = " + strength + "\ncrushing_energy = 100 N/m\n");
    };
    crush("[joint]\n", "2 MPa");
    crush("[unit]\n", "2 MPa"); // so that some units break before they crush
    return text;
}();

/// Joints that wear.
const std::string kWear = [] {
    std::string text = kAll;
    text.insert(text.find("[joint]\n") + 8,
                "wear_length = 0.05 mm\nresidual_friction_angle = 5 deg\n");
    const std::string_view friction = "friction_angle = normal(mean 40 deg, cov 0.10)";
    text.replace(text.find(friction), friction.size(), "friction_angle = 12 deg");
    return text;
}();

/// Joints that close, with a loss; cracks of mixed modes.
const std::string kLaws = [] {
    std::string text = kAll;
    const std::string_view modulus = "wall_modulus = 768, 1057 MPa\n";
    text.replace(text.find(modulus), modulus.size(),
                 "closure = hyperbolic\ninitial_stiffness = 4 GPa/m\nmaximum_closure = 0.15 "
                 "mm\nclosure_loss = 0.2\n");
    text.insert(text.find("[unit]\n") + 7,
                "envelope = hyperbolic\nshear_fracture_energy = 5 N/m\n");
    return text;
}();

/// Rigid blocks on a clamped base, no cracks, no distribution, one stress level.
const std::string kLeast = kWall + R"(unit_cracks = no
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
normal_stiffness = 8 GPa/m
shear_stiffness = 3 GPa/m
friction_angle = 30 deg
[beam]
height = 0.10 m
young_modulus = 30 GPa
density = 2400 kg/m3
[load]
vertical_stress = 0.50 MPa
max_displacement = 2 mm
[solver]
fidelity = rigid
kinematics = small
beam_modes = rigid
steps_per_mm = 500
unbalance_limit = 0
[output]
record_every = 0.1 mm
)";

/// The same, whose joints close by a law of two wall moduli.
const std::string kFitted = [] {
    std::string text = kLeast;
    const std::string_view stiffness = "normal_stiffness = 8 GPa/m\n";
    text.replace(text.find(stiffness), stiffness.size(),
                 "closure = exponential\nwall_modulus = 768, 1057 MPa\n"
                 "wall_modulus_stress = 0.50, 1.00 MPa\n");
    return text;
}();

/// Rubble, whose stones do not crack.
const std::string kRubble = [] {
    std::string text = kAll;
    text.insert(text.find("[wall]\n") + 7, "bond = rubble\n");
    return text;
}();

Study read(const std::string& text, const std::vector<std::string>& overrides = {})
{
    return app::prepare(app::read_study(app::with_overrides(
                            app::parse_study_text("study.ini", text), overrides)))
        .study;
}

/// Every number that a push of the first sample gives, under all stress levels, and how the
/// stones of the second lie.
std::vector<double> outputs(const Study& s)
{
    const dem::Model model = app::model_of(app::prepare(s));
    const std::vector<std::uint32_t> sizes = {
        s.random.empty() ? 1u : static_cast<std::uint32_t>(s.uq.samples)};
    const app::SamplePlan plan = app::sample_plan(s, s.load, s.source, model.layout, sizes);
    std::vector<double> all = {static_cast<double>(sizes.back()),
                               static_cast<double>(app::layout_seed(s, 1))};
    std::vector<app::PushedWall> walls(s.load.vertical_stress.size());
    app::PushList list;
    list.size = walls.size();
    list.wall = [&](std::size_t i) -> app::WantedWall {
        return {static_cast<int>(i), app::draw(plan, static_cast<int>(i), 0)};
    };
    list.done = [&](std::size_t i, const app::WallDraw&, app::PushedWall&& wall) {
        walls[i] = std::move(wall);
    };
    app::push_walls(s, model, app::push_plan(s), list, 1);
    for (const app::PushedWall& w : walls) {
        all.push_back(static_cast<double>(w.result.outcome));
        all.push_back(static_cast<double>(w.result.snapshots.size()));
        all.insert(all.end(), w.displacement.begin(), w.displacement.end());
        all.insert(all.end(), w.force.begin(), w.force.end());
        all.insert(all.end(),
                   {w.result.settlement, w.result.energy.elastic, w.result.energy.friction,
                    w.result.energy.fracture, w.result.energy.crushing});
    }
    return all;
}

/// Values that matter where another number would not, or could not stand beside the rest.
const std::map<std::string_view, std::string> kOthers = {
    {"wall.unit_length", "0.30 m"},
    {"wall.geometry", "nothing.dxf"},
    {"wall.outlines", "0 0, 0.6 0, 0.6 0.3, 0 0.3"},
    {"wall.layer_stones", "sill: 3 GPa, 0.2, 2000 kg/m3"},
    {"wall.openings", "0.2 m, 0 m, 0.2 m, 0.1 m"},
    {"wall.course_heights", "0.12, 0.08, 0.11 m"},
    {"wall.unit_length_cov", "0.1"},
    {"unit.cracks", "grid(3, 2)"},
    {"unit.cracks_where", "0 m, 0 m, 0.3 m, 0.2 m"},
    {"unit.cracks_elsewhere", "thirds"},
    {"joint.wall_modulus", "700, 900 MPa"},
    {"joint.normal_stiffness", "7 GPa/m"},
    {"joint.wall_modulus_stress", "0.4, 0.9 MPa"},
    {"joint.initial_stiffness", "5 GPa/m"},
    {"joint.maximum_closure", "0.2 mm"},
    {"joint.largest_stiffness", "5 GPa/m"},
    {"joint.shear_fracture_energy", "100 N/m"},
    {"unit.shear_fracture_energy", "10 N/m"},
    {"joint.shear_stiffness", "2 GPa/m"},
    {"unit.residual_friction_angle", "20 deg"},
    {"joint.residual_friction_angle", "4 deg"},
    {"load.vertical_stress", "0.6 MPa"},
    {"load.height", "0.35 m"},
    {"load.targets", "1 mm"},
    {"load.direction", "left"},
    {"load.amplitudes", "0.5, 1 mm"},
    {"load.stop_below", "0.999999"},
    {"solver.accuracy", "20 %"},
    {"solver.contact_points", "4"},
    {"solver.block_modes", "6"},
    {"solver.preload_steps", "1"},
    {"solver.preload_unbalance", "0.9"},
    {"solver.unbalance_limit", "0.05"},
    {"solver.energy_tolerance", "1e-15"},
    {"solver.most_steps", "10"},
    {"solver.min_speed", "1"},
    {"output.snapshot_every", "0.25 mm"},
    {"uq.correlation_length", "0.6 m"},
    {"uq.pearson", "joint.friction_angle joint.stiffness_factor 0.5"},
};

/// Limits act once they are reached, which no study can tell before its push: they must change
/// one of the scenes, and need not be named where they change nothing.
const std::set<std::string_view> kLimits = {"load.stop_below",          "solver.preload_steps",
                                            "solver.preload_unbalance", "solver.steps_per_mm",
                                            "solver.unbalance_limit",   "solver.min_speed"};

/// Another value for a key, as text.
std::string other_value(const Key& key, const Study& study)
{
    const auto listed = kOthers.find(key.name);
    if (listed != kOthers.end()) return listed->second;
    const std::vector<double> now = key.field.get(study);
    for (const app::Named& n : key.names)
        if (now.empty() || n.value != now.front()) return std::string(n.word);
    if (key.kind == app::Kind::count) return std::to_string(static_cast<int>(now.front()) + 1);
    const double other = now.front() == 0.0 ? 0.001 : 0.9 * now.front();
    return app::format_quantities({&other, 1}, key.unit);
}

bool is_named(const std::string& notes, std::string_view key)
{
    const std::size_t at = notes.find(key);
    const std::size_t end = at + key.size();
    return at != std::string::npos && (notes[end] == ',' || notes[end] == ':');
}

/// @return the keys whose other value changed the outputs
std::set<std::string_view> sweep(const std::string& text)
{
    std::set<std::string_view> effective;
    const Study base = read(text);
    const std::vector<double> before = outputs(base);
    for (const Key& key : app::study_keys()) {
        if (!app::reads(kPush, key) || app::section_of(key.name) == "fragility") continue;
        // which wall is pushed: test_push_command; rows of lists: test_sample_plan
        if (key.name == "uq.drawn" || key.name == "uq.together") continue;
        const std::string value = other_value(key, base);
        INFO(key.name << " = " << value);
        Study changed;
        std::vector<double> after;
        try {
            changed = read(text, {std::string(key.name) + "=" + value});
            after = outputs(changed);
        } catch (const app::ConfigError&) {
            continue; // refused: said clearly enough
        }
        const std::string notes = app::effect_notes(changed, kPush);
        CAPTURE(notes);
        if (after != before) effective.insert(key.name);
        if (!kLimits.contains(key.name)) CHECK((after != before) == !is_named(notes, key.name));
    }
    return effective;
}

} // namespace

TEST_CASE("key effects: every key that is read changes the push, or is named as without effect",
          "[slow][app][key_effects]")
{
    std::set<std::string_view> effective;
    for (const std::string& text : {kAll, kCorrelated, kMortar, kDrawn, kCells, kCrushing,
                                    kWear, kLaws, kFitted, kRubble, kLeast})
        effective.merge(sweep(text));
    for (const std::string_view limit : kLimits) {
        INFO(limit);
        CHECK(effective.contains(limit));
    }
}

TEST_CASE("key effects: keys with the same reason share a line", "[app][key_effects]")
{
    const Study s = read(kLeast, {"uq.samples=7", "uq.seed=2"});
    const std::string notes = app::effect_notes(s, kPush);
    CHECK(notes.find("note: uq.samples, uq.seed: no effect, because no value of the study is a "
                     "distribution\n") != std::string::npos);
}

TEST_CASE("key effects: a default that is written out is not remarked on", "[app][key_effects]")
{
    const std::string defaults = "joint.wear_length=none", other = "joint.wear_length=10 mm";
    CHECK(app::effect_notes(read(kLeast, {defaults}), kPush).empty());
    CHECK(app::effect_notes(read(kLeast, {other}), kPush).find("joint.wear_length") !=
          std::string::npos);
    // One that only a push one way replaces is news where the push goes to and fro.
    const std::string cycles = "load.amplitudes=1 mm", far = "load.max_displacement=8 mm";
    CHECK(app::effect_notes(read(kLeast, {cycles, far}), kPush).find("load.max_displacement") !=
          std::string::npos);
    CHECK(app::effect_notes(read(kLeast, {cycles, "load.max_displacement=30 mm"}), kPush)
              .empty());
    // A default that follows from another value, here joint.friction_angle, is no news either.
    const std::string key = "joint.residual_friction_angle";
    CHECK(app::effect_notes(read(kLeast, {key + "=30 deg"}), kPush).empty());
    CHECK(app::effect_notes(read(kLeast, {key + "=29 deg"}), kPush).find(key) !=
          std::string::npos);
    // This value would be fitted to moduli, which the study does not give.
    const std::string fitted = "joint.initial_stiffness";
    CHECK(app::effect_notes(read(kLeast, {fitted + "=5 GPa/m"}), kPush).find(fitted) !=
          std::string::npos);
}
