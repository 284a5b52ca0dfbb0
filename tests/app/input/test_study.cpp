#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/unit_cracks.hpp"

#include "app/input/keys/study_keys.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <numbers>
#include <string>

using study_texts::read;
using study_texts::read_good;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// The good study without courses and course_height.
std::string without_courses()
{
    std::string text(bad_input::kGoodStudy);
    for (const char* key : {"courses", "course_height"}) {
        const std::size_t at = text.find(std::string(key) + " =");
        text.erase(at, text.find('\n', at) + 1 - at);
    }
    return text;
}

app::Study shipped(const std::string& name)
{
    return app::prepare(
               app::read_study(app::read_study_file(DRYSTONE_SOURCE_DIR "/configs/" + name)))
        .study;
}

} // namespace

TEST_CASE("study: the effective configuration reads back to the same study", "[app][study]")
{
    const app::Study study = GENERATE(
        read_good(), read(study_texts::kEverything), shipped("wall.ini"), shipped("levels.ini"),
        shipped("uncoupled.ini"), read_good({"wall.bond=english", "wall.header_length=9 cm"}),
        read_good({"wall.bond=rubble", "wall.seed=5"}),
        read(without_courses(), {"wall.course_heights=0.2, 0.3, 0.5 m"}),
        read_good(study_texts::kFitted), read_good(study_texts::kClosing),
        read_good({"unit.envelope=hyperbolic", "unit.shear_fracture_energy=900 N/m"}),
        read_good({"load.pattern=body", "wall.openings=0.4 m, 0 m, 0.2 m, 0.6 m"}),
        read_good({"wall.unit_cracks=no", "beam.interface=joint", "wall.base=joint"}),
        read_good({"joint.friction_angle=0.1234567890123 rad", "wall.courses=7"}));
    const std::string text = app::effective_configuration(study);
    INFO(text);
    const app::Study again = read(text);
    for (const app::Key& key : app::study_keys()) {
        INFO(key.name);
        CHECK(key.field.get(again) == key.field.get(study));
    }
}

TEST_CASE("study: the effective configuration has every key in use, defaults and --set marked",
          "[app][study]")
{
    const std::string text = app::effective_configuration(read_good({"wall.courses=12"}));
    CHECK(text.find("courses                 = 12                            # --set\n") !=
          std::string::npos);
    CHECK(text.find("toe                     = held                          # default\n") !=
          std::string::npos);
    CHECK(text.find("length                  = 1.00 m\n") != std::string::npos);
    CHECK(text.find("normal_stiffness") == std::string::npos); // wall_modulus gives it
    CHECK(text.find("[base]") == std::string::npos);           // the base is fixed
    const std::string everything = app::effective_configuration(read(study_texts::kEverything));
    CHECK(everything.find("# default") == std::string::npos);
}

TEST_CASE("study: settings of the reading are kept as comments unless given, cuts are told",
          "[app][study]")
{
    const std::string text = app::effective_configuration(read_good(
        {"fragility.confidence=0.9", "joint.friction_angle=normal(mean 31.8 deg, cov 0.6)"}));
    CHECK(text.find("\n# crossing              = first") != std::string::npos);
    CHECK(text.find("\nconfidence              = 0.9") != std::string::npos);
    // P(angle < 0 or > 90 deg) = Phi(-1 / 0.6) + Phi(-58.2 / 19.08) = 0.0478 + 0.0011
    CHECK(text.find(
              "# --set, a share of 0.049 lies outside the range of this key and is cut off") !=
          std::string::npos);
    CHECK(text.find("a share of") == text.rfind("a share of"));
}

TEST_CASE("study: what the solver leaves open is as the solver has it", "[app][study]")
{
    const app::Study study = read_good();
    const dem::SolverOptions solver;
    const dem::Discretisation discretisation;
    const dem::PushPlan plan;
    CHECK(study.solver.law == solver.law);
    CHECK(study.solver.damping == solver.damping);
    CHECK(study.solver.damping_factor == solver.damping_factor);
    CHECK(study.solver.step_fraction == solver.step_fraction);
    CHECK(study.solver.accuracy == solver.accuracy);
    CHECK(study.solver.steps_per_mm == solver.steps_per_mm);
    CHECK(study.solver.preload_steps == solver.preload_steps);
    CHECK(study.solver.preload_unbalance == solver.preload_unbalance);
    CHECK(study.solver.unbalance_limit == solver.unbalance_limit);
    CHECK(study.solver.min_speed == solver.min_speed);
    CHECK(study.discretisation.contact_points == discretisation.contact_points);
    CHECK(study.discretisation.face_rule == discretisation.face_rule);
    CHECK(study.discretisation.zones_per_interval == discretisation.zones_per_interval);
    CHECK(study.discretisation.block_modes == discretisation.block_modes);
    CHECK(study.discretisation.beam_modes == discretisation.beam_modes);
    const app::Study small = read_good({"solver.kinematics=small"});
    CHECK(app::push_plan(small).targets == plan.targets); // app/test_push_end: finite ones
    CHECK(app::push_plan(study).record_every == plan.record_every);
}

TEST_CASE("study: defaults follow from the values they depend on", "[app][study]")
{
    const app::Study study = read_good({"wall.base=joint", "beam.interface=joint"});
    CHECK(study.parameters.unit.cohesion == 3.7e6);
    CHECK(study.parameters.unit.residual_cohesion == 0.0);
    CHECK(study.parameters.unit.residual_friction_angle == 35 * kDegree);
    CHECK(study.parameters.base_friction_angle == 31.8 * kDegree);
    CHECK(study.parameters.beam_friction_angle == 31.8 * kDegree);
    CHECK(study.beam.material.poisson_ratio == 0.2);
    CHECK(study.load.height == Approx(1.1).epsilon(1e-15));
    CHECK(read_good({"wall.courses=5"}).load.height == Approx(0.6).epsilon(1e-15));
}

TEST_CASE("study: one of two keys for one thing takes the place of the other in the file",
          "[app][study]")
{
    const app::Study study = read_good({"joint.normal_stiffness=6 GPa/m"});
    CHECK(study.parameters.joint.wall_modulus.empty());
    CHECK(study.parameters.joint.normal_stiffness == std::vector{6e9});
    CHECK(app::effective_configuration(study).find("wall_modulus") == std::string::npos);
    CHECK_THROWS_WITH(
        read_good({"joint.normal_stiffness=6 GPa/m", "joint.wall_modulus=768 MPa"}),
        Catch::Contains("keep one of them"));
    CHECK(read_good({"load.amplitudes=1, 2 mm"}).load.amplitudes.size() == 2);
    CHECK(read_good(study_texts::kClosing).parameters.joint.wall_modulus.empty());
    const std::string text = app::effective_configuration(read_good(study_texts::kClosing));
    CHECK(read(text, study_texts::kFitted).parameters.joint.wall_modulus.size() == 4);
    CHECK_THROWS_WITH(
        read_good(study_texts::with(study_texts::kFitted, {"joint.initial_stiffness=5 GPa/m"})),
        Catch::Contains("joint.wall_modulus determines it; keep one of them"));
}

TEST_CASE("study: heights of courses give their number, their mean and the height of the load",
          "[app][study]")
{
    const app::Study study = read(without_courses(), {"wall.course_heights=0.2, 0.3, 0.4 m"});
    CHECK(study.wall.courses == 3);
    CHECK(study.wall.course_height == Approx(0.3));
    CHECK(study.load.height == Approx(1.0).epsilon(1e-15));
    CHECK_THROWS_WITH(read(without_courses(),
                           {"wall.course_heights=0.2, 0.3, 0.4 m", "wall.course_height=0.1 m"}),
                      Catch::Contains("wall.course_heights has the heights"));
    CHECK(read_good({"wall.bond=header", "wall.unit_length=0.3 m"}).wall.header_length ==
          Approx(0.15));
}

TEST_CASE("study: units that cannot crack need no strength", "[app][study]")
{
    std::string text(bad_input::kGoodStudy);
    const std::size_t begin = text.find("[unit]");
    text.erase(begin, text.find("[beam]") - begin);
    CHECK_THROWS_AS(read(text), app::ConfigError);
    const app::Study study = read(text, {"wall.unit_cracks=no"});
    CHECK_FALSE(app::has_cracks(study, study.source));
    CHECK(app::effective_configuration(study).find("[unit]") == std::string::npos);
    CHECK_NOTHROW(read_good({"wall.unit_cracks=no"})); // their data may stay
}

TEST_CASE("study: the load line may lie anywhere in the beam, its ends included",
          "[app][study]")
{
    CHECK_NOTHROW(read_good({"load.height=1 m"}));
    CHECK_NOTHROW(read_good({"load.height=1.05 m"}));
    CHECK_NOTHROW(read_good({"load.height=1.1 m"}));
    CHECK_THROWS_AS(read_good({"load.height=1.1001 m"}), app::ConfigError);
    CHECK_THROWS_AS(read_good({"load.height=0.9999 m"}), app::ConfigError);
}

TEST_CASE("study: sizes that divide the wall only up to rounding make no sliver",
          "[app][study]")
{
    CHECK_NOTHROW(read_good({"wall.length=0.9 m", "wall.unit_length=0.3 m"}));
    CHECK_NOTHROW(
        read_good({"wall.length=2.1 m", "wall.unit_length=0.7 m", "wall.bond=stack"}));
}

TEST_CASE("study: the shipped wall is that of the paper", "[app][study]")
{
    const app::Study study = shipped("wall.ini");
    CHECK(study.wall.length == 1.0);
    CHECK(study.wall.courses == 10);
    CHECK(study.wall.bond_offset == 0.5);
    CHECK(study.wall.base == dem::Base::fixed);
    CHECK(study.parameters.stone.young_modulus == 15.5e9);
    CHECK(study.parameters.unit.tensile_strength == 3.7e6);
    CHECK(study.parameters.unit.cohesion == study.parameters.unit.tensile_strength);
    CHECK(study.parameters.unit.fracture_energy == 110.0);
    CHECK(study.parameters.joint.friction_angle == 31.8 * kDegree);
    CHECK(study.load.vertical_stress == std::vector<double>{0.5e6});
    CHECK(study.load.max_displacement == 0.03);
    CHECK(study.solver.law == dem::ContactLaw::coupled);
}

TEST_CASE("study: the other shipped studies differ from the wall in what they are for",
          "[app][study]")
{
    const app::Study wall = shipped("wall.ini");
    const std::string name = GENERATE("levels.ini", "uncoupled.ini");
    const app::Study study = shipped(name);
    for (const app::Key& key : app::study_keys()) {
        INFO(key.name);
        const bool same = key.field.get(study) == key.field.get(wall);
        const bool of_level = key.name == "joint.wall_modulus" ||
                              key.name == "joint.shear_stiffness" ||
                              key.name == "load.vertical_stress";
        const bool of_law = key.name == "unit.contact_law" && name == "uncoupled.ini";
        CHECK(same != (of_level || of_law));
    }
}
