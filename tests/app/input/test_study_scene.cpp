/// Tests of the scene that a study hands to the solver.

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using study_texts::read;
using study_texts::read_good;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

} // namespace

TEST_CASE("study: the shipped moduli give the joint stiffness of Eq. 2 at every stress level",
          "[app][study]")
{
    const app::Study study =
        app::prepare(
            app::read_study(app::read_study_file(DRYSTONE_SOURCE_DIR "/configs/levels.ini")))
            .study;
    const std::vector<double> kn = {5.87e9, 8.08e9, 9.70e9, 11.34e9, 13.03e9}; // [Pa/m]
    const std::vector<double> stress = {0.15e6, 0.50e6, 0.75e6, 1.00e6, 1.25e6};
    for (int level = 0; level < 5; ++level) {
        const dem::JointMaterial joint = study_texts::joint_material(study, level);
        CHECK(std::abs(joint.kn - kn[level]) <= 0.005e9); // printed with two decimals
        CHECK(joint.ks == joint.kn / 2.4);
        CHECK(app::loads(study.load, level).vertical_stress == stress[level]);
    }
}

TEST_CASE("study: one given stiffness serves all levels, a list one each", "[app][study]")
{
    const app::Study study = read(study_texts::kEverything); // factor 1.1
    CHECK(study_texts::joint_material(study, 0).kn == 1.1 * 5.87e9);
    CHECK(study_texts::joint_material(study, 1).kn == 1.1 * 8.08e9);
    CHECK(study_texts::joint_material(study, 0).ks == 1.1 * 2e9);
    CHECK(study_texts::joint_material(study, 1).ks == 1.1 * 2e9);
}

TEST_CASE("study: a crack is xi times as stiff as a joint, whatever the factor of the joint",
          "[app][study]")
{
    const double kn = study_texts::joint_material(read_good(), 1).kn;
    for (const char* const factor : {"0.5", "1", "2"}) {
        const app::Study study = read_good({std::string("joint.stiffness_factor=") + factor});
        CHECK(study_texts::crack_material(study, 1).kn == 10 * kn);
        CHECK(study_texts::joint_material(study, 1).kn == std::stod(factor) * kn);
    }
    CHECK(study_texts::crack_material(read_good({"unit.stiffness_factor=2"}), 1).kn == 20 * kn);
    CHECK(study_texts::crack_material(read_good(), 1).ks == 10 * kn / 2.4);
}

TEST_CASE("study: a crack that snaps back breaks at its strength, or at what its energy allows",
          "[app][study]")
{
    const double kn = study_texts::crack_material(read_good(), 1).kn;
    const double most = std::sqrt(2.0 * 110.0 * kn); // u_ul = u_el
    const auto strength = [](const char* rule, const std::string& given) {
        return study_texts::crack_material(
            read_good({std::string("unit.snap_back=") + rule, "unit.tensile_strength=" + given,
                       "unit.fracture_energy=110 N/m"}),
            1);
    };
    REQUIRE(most > 3e6);
    REQUIRE(most < 9e6);
    CHECK(strength("breaks", "9 MPa").ft == 9e6);
    CHECK(strength("weakens", "9 MPa").ft == Approx(most).epsilon(1e-14));
    CHECK(strength("weakens", "9 MPa").cohesion == 9e6);
    CHECK(strength("weakens", "3 MPa").ft == 3e6);
}

TEST_CASE("study: an open crack closes to the origin unless the study says otherwise",
          "[app][study]")
{
    CHECK(read_good().solver.unloading == dem::Unloading::secant);
    CHECK(read_good({"unit.unloading=elastic"}).solver.unloading == dem::Unloading::elastic);
}

TEST_CASE("study: every joint and crack ID has the material of the study", "[app][study]")
{
    const app::Study study = read(study_texts::kEverything);
    const dem::WallMaterials all = study_texts::materials(study, 1);
    const dem::Layout layout = app::layout_of(study, study.source);
    REQUIRE(static_cast<int>(all.joints.size()) == layout.n_joints);
    REQUIRE(static_cast<int>(all.cracks.size()) == layout.n_cracks);
    CHECK(all.stone.density == 2000.0);
    CHECK(all.joints.back().kn == 1.1 * 8.08e9);
    CHECK(all.joints.back().tan_phi == std::tan(30 * kDegree));
    const dem::CrackMaterial& crack = all.cracks.back();
    CHECK(crack.kn == Approx(0.9 * 12 * 8.08e9).epsilon(1e-15));
    CHECK(crack.ks == Approx(crack.kn / 2.5).epsilon(1e-15));
    CHECK(crack.ft == 3e6);
    CHECK(crack.cohesion == 4e6);
    CHECK(crack.cohesion_res == 0.1e6);
    CHECK(crack.tan_phi == std::tan(0.7));
    CHECK(crack.tan_phi_res == std::tan(33 * kDegree));
    CHECK(crack.fracture_energy == 100.0);
}

TEST_CASE("study: base and beam joints have the stiffness of the joints without their factor",
          "[app][study]")
{
    const dem::WallMaterials all = study_texts::materials(read(study_texts::kEverything), 1);
    for (const dem::JointMaterial& joint : {all.base_joint, all.beam_joint}) {
        CHECK(joint.kn == 8.08e9);
        CHECK(joint.ks == 2e9);
    }
    CHECK(all.base_joint.tan_phi == std::tan(25 * kDegree));
    CHECK(all.beam_joint.tan_phi == std::tan(40 * kDegree));
}

TEST_CASE("study: targets replace the one displacement of a monotonic push", "[app][study]")
{
    CHECK(app::push_plan(read_good({"load.max_displacement=12 mm"})).targets ==
          std::vector<double>{0.012});
    CHECK(app::push_plan(read_good({"solver.kinematics=small"})).snapshot_every == 5e-4);
    const dem::PushPlan plan = app::push_plan(read(study_texts::kEverything));
    CHECK(plan.targets == std::vector<double>{0.005, -0.005, 0.01, -0.01});
    CHECK(plan.record_every == 1e-4);
    CHECK(plan.snapshot_every == 0.0);
    CHECK_FALSE(plan.progress);
}

TEST_CASE("study: stop_below ends the push once the force is below that share of the peak",
          "[app][study]")
{
    CHECK_FALSE(app::push_plan(read_good({"solver.kinematics=small"})).decided);
    const auto decided = app::push_plan(read_good({"load.stop_below=0.5"})).decided;
    REQUIRE(decided);
    std::vector<dem::CurvePoint> curve;
    for (const double force : {0.0, 10.0, 40.0, 100.0, 60.0}) {
        curve.emplace_back().force = force;
        CHECK_FALSE(decided(curve));
    }
    curve.emplace_back().force = 49.9;
    CHECK(decided(curve));
}

TEST_CASE("study: a force against the push at its beginning does not end it", "[app][study]")
{
    const std::string target = GENERATE("20 mm", "-20 mm");
    const double along = target.front() == '-' ? -1.0 : 1.0;
    for (const char* stop : {"load.stop_below=0.5", "load.stop_below=0"}) {
        INFO(stop << ", " << target);
        const auto decided =
            app::push_plan(read_good({"load.targets=" + target, stop})).decided;
        REQUIRE(decided);
        std::vector<dem::CurvePoint> curve;
        for (const double force : {-5.0, -1.0, 2.0, 40.0, 30.0}) {
            curve.emplace_back().force = along * force;
            CHECK_FALSE(decided(curve));
        }
        curve.emplace_back().force = -along;
        CHECK(decided(curve));
    }
}

TEST_CASE("study: a push to the left in two parts goes one way", "[app][study]")
{
    const app::Study study = read_good({"load.targets=-5, -10 mm", "load.stop_below=0.5"});
    CHECK(app::push_way(study.load).direction == -1);
    std::vector<dem::CurvePoint> curve(3);
    curve[1].force = -100.0;
    curve[2].force = -49.0; // a push to and fro would go on
    curve[2].displacement = curve[1].displacement = -1e-3;
    CHECK(app::push_plan(study).decided(curve));
}

TEST_CASE("study: amplitudes and protocols become displacements to visit", "[app][study]")
{
    const auto cycles =
        app::push_plan(read_good({"load.amplitudes=3, 6 mm", "load.repeats=2"}));
    REQUIRE(cycles.targets.size() == 9);
    CHECK(cycles.targets[2] == Approx(0.003));
    CHECK(cycles.targets[5] == Approx(-0.006));
    CHECK(cycles.targets.back() == 0.0);
    const app::Study fema = read_good({"load.protocol=fema461", "load.max_displacement=20 mm"});
    CHECK(app::push_plan(fema).targets.size() == 41);
    CHECK(app::push_way(fema.load).farthest == Approx(0.020));
    CHECK(app::push_way(fema.load).direction == 0);
}

TEST_CASE("study: stop_below ends a push to and fro once a whole cycle is weak on both sides",
          "[app][study]")
{
    const auto decided =
        app::push_plan(read_good({"load.amplitudes=3, 6 mm", "load.stop_below=0.5"})).decided;
    REQUIRE(decided);
    std::vector<dem::CurvePoint> curve;
    const auto visit = [&](double displacement, double force) {
        curve.emplace_back();
        curve.back().displacement = displacement;
        curve.back().force = force;
        return decided(curve);
    };
    for (const auto& [x, f] : {std::pair{0.0, 0.0},
                               {1.0, 10.0},
                               {0.0, 0.0},
                               {-1.0, -10.0},
                               {0.0, 0.0},
                               {1.0, 4.0},
                               {0.0, 0.0},
                               {-1.0, -6.0},
                               {0.0, 0.0},
                               {1.0, 6.0},
                               {0.0, 0.0},
                               {-1.0, -4.0},
                               {0.0, 0.0},
                               {1.0, 4.0},
                               {0.1, -3.0}, // unloaded before it is back, and weak
                               {-0.01, -3.0},
                               {-1.0, -4.0}})
        CHECK_FALSE(visit(x, f));
    CHECK(visit(0.01, 3.0));
}

TEST_CASE("study: loads carry the height of the load and gravity", "[app][study]")
{
    const dem::Loads loads = app::loads(read(study_texts::kEverything).load, 0);
    CHECK(loads.vertical_stress == 150e3);
    CHECK(loads.height == 1.3);
    CHECK(loads.gravity == 9.80665);
}

TEST_CASE(
    "study: body forces have the height of the centre of gravity of the wall that there is",
    "[app][study]")
{
    const auto height = [](const std::vector<std::string>& more) {
        std::vector<std::string> all = {"load.pattern=body"};
        all.insert(all.end(), more.begin(), more.end());
        return read_good(all).load.height;
    };
    const double beam = 2400.0 * 0.1, wall = 2300.0; // kg/m3 m of 1 m x 1 m
    CHECK(height({}) == (0.5 * 1.0 * (2300.0 * 1.0) + (1.0 + 0.5 * 0.10) * (2400.0 * 0.10)) /
                            (2300.0 * 1.0 + 2400.0 * 0.10)); // to the bit
    // a door of 0.2 m x 0.6 m around 0.3 m; lintels are of the wall's stone
    CHECK(height({"wall.openings=0.4 m, 0 m, 0.2 m, 0.6 m"}) ==
          Approx((wall * (0.5 - 0.12 * 0.3) + beam * 1.05) / (wall * 0.88 + beam))
              .epsilon(1e-14));
    // a lintel of twice the density, of 0.4 m x 0.1 m around 0.65 m
    CHECK(height({"wall.openings=0.4 m, 0 m, 0.2 m, 0.6 m", "lintel.density=4600 kg/m3"}) ==
          Approx((wall * (0.5 - 0.12 * 0.3) + 2300.0 * 0.04 * 0.65 + beam * 1.05) /
                 (wall * 0.88 + 2300.0 * 0.04 + beam))
              .epsilon(1e-14));
}

TEST_CASE("study: body forces of a gable push at its own centre of gravity", "[app][study]")
{
    // a square of 1 m under a triangle of 1 m x 0.6 m: 1 m2 around 0.5 m and 0.3 m2 around 1.2
    // m
    const app::Study gable = read(R"([wall]
outlines = 0 0, 1 0, 1 1, 0 1; 0 1, 1 1, 0.5 1.6
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
)");
    CHECK(gable.load.height == Approx((0.5 + 0.36) / 1.3).epsilon(1e-14));
}

TEST_CASE("study: random lengths beside openings make a wall under every seed", "[app][study]")
{
    for (int seed = 1; seed <= 60; ++seed) // 6 of them left slivers
        CHECK_NOTHROW(
            read_good({"wall.length=3 m", "wall.courses=9", "wall.course_height=0.3 m",
                       "wall.unit_length=0.6 m", "wall.unit_length_cov=0.15",
                       "wall.openings=0.3 m, 0 m, 0.9 m, 2.1 m; 1.8 m, 0.9 m, 0.8 m, "
                       "1.2 m",
                       "wall.seed=" + std::to_string(seed)}));
}
