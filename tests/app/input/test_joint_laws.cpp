/// Keys of closure, of envelopes and of energy in shear: what they fill, what is said of them.

#include "app/input/key_effects.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/joint_laws.hpp"
#include "app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

using study_texts::kClosing;
using study_texts::kFitted;
using study_texts::read_good;
using study_texts::with;

namespace {

constexpr app::Verb kPush{
    .name = "push",
    .sections = "wall lintel stone joint unit beam base load solver output uq fragility"};

app::Study shipped(const std::string& name)
{
    return app::prepare(
               app::read_study(app::read_study_file(DRYSTONE_SOURCE_DIR "/configs/" + name)))
        .study;
}

bool has_mixed_law(const dem::JointMaterial& j)
{
    return j.envelope != dem::Envelope::coulomb || j.shear_fracture_energy > 0.0;
}

const std::vector<std::string> kMortar = {"joint.tensile_strength=0.2 MPa",
                                          "joint.cohesion=0.2 MPa"};

std::string notes_of(const app::Study& s) { return app::joint_law_notes(s, s.source); }

} // namespace

TEST_CASE(
    "joint laws: without their keys joints are linear, envelopes Coulomb's, shear brittle",
    "[app][joint_laws]")
{
    for (const app::Study& s : {read_good(), shipped("paper.ini"), read_good(kMortar)}) {
        CHECK(study_texts::laid(s).closure == dem::Closure::linear);
        CHECK_FALSE(study_texts::laid(s).mixed_mode);
        const dem::JointMaterial joint = study_texts::joint_material(s, 1);
        CHECK(joint.closing.initial_stiffness == 0.0);
        CHECK(joint.envelope == dem::Envelope::coulomb);
        CHECK(joint.shear_fracture_energy == 0.0);
        CHECK(study_texts::crack_material(s, 1).shear_fracture_energy == 0.0);
        CHECK(app::joint_law_notes(s, s.source).empty());
    }
}

TEST_CASE(
    "joint laws: two numbers give joints, base and beam their law, and the stiffness under "
    "each stress",
    "[app][joint_laws]")
{
    const app::Study s = read_good(
        with(kClosing, {"joint.closure_loss=0.3", "joint.stiffness_factor=2", "wall.base=joint",
                        "beam.interface=joint", "load.vertical_stress=0, 0.77 MPa"}));
    CHECK(study_texts::laid(s).closure == dem::Closure::exponential);
    for (const int level : {0, 1}) {
        const double kn = 4.87e9 + s.load.vertical_stress[level] / 0.154e-3;
        const dem::WallMaterials w = study_texts::materials(s, level);
        for (const dem::JointMaterial& own : {w.base_joint, w.beam_joint}) {
            CHECK(own.kn == Approx(kn).epsilon(1e-14));
            CHECK(own.ks == Approx(kn / 2.4).epsilon(1e-14));
            CHECK(own.closing.initial_stiffness == Approx(4.87e9).epsilon(1e-14));
            CHECK(own.closing.maximum == Approx(0.154e-3).epsilon(1e-14));
            CHECK(own.closing.stiffest == Approx(487e9).epsilon(1e-14));
            CHECK(own.closing.loss == 0.3);
        }
        const dem::JointMaterial& joint = w.joints.front();
        CHECK(joint.kn == 2.0 * w.base_joint.kn); // twice as stiff: half the closure
        CHECK(joint.closing.initial_stiffness == 2.0 * w.base_joint.closing.initial_stiffness);
        CHECK(joint.closing.maximum == 0.5 * w.base_joint.closing.maximum);
        CHECK(w.cracks.front().kn == 10.0 * w.base_joint.kn);
    }
}

TEST_CASE("joint laws: a given shear stiffness is that at the stress, a given limit is kept",
          "[app][joint_laws]")
{
    const app::Study s = read_good(with(
        kClosing, {"joint.shear_stiffness=2, 3 GPa/m", "joint.largest_stiffness=60 GPa/m"}));
    CHECK(study_texts::joint_material(s, 0).ks == 2e9);
    CHECK(study_texts::joint_material(s, 1).ks == 3e9);
    CHECK(study_texts::joint_material(s, 0).closing.stiffest == 60e9);
}

TEST_CASE("joint laws: a draw that begins above the limit, or far below it, moves the limit",
          "[app][joint_laws]")
{
    app::Study s = read_good(with(kClosing, {"joint.largest_stiffness=60 GPa/m"}));
    double& k0 = s.parameters.joint.closing.initial_stiffness;
    for (const auto& [drawn, limit] : {std::pair{80e9, 80e9}, {5e9, 60e9}, {1e7, 1e10}}) {
        k0 = drawn;
        CHECK(study_texts::joint_material(s, 0).closing.stiffest == limit);
    }
}

TEST_CASE("joint laws: the wall moduli of the paper give one law, which serves every stress",
          "[app][joint_laws]")
{
    const app::Study s = read_good(with(kFitted, {"load.vertical_stress=0.75 MPa"}));
    const dem::Closing& c = s.parameters.joint.closing;
    CHECK(c.initial_stiffness == Approx(4.866e9).epsilon(1e-4));
    CHECK(c.maximum == Approx(0.1537e-3).epsilon(3e-4));
    CHECK(study_texts::joint_material(s, 0).kn == c.initial_stiffness + 0.75e6 / c.maximum);
    CHECK(study_texts::laid(s).closure == dem::Closure::hyperbolic);
    CHECK(app::joint_law_notes(s, s.source) ==
          "note: joint.closure: k_0 = 4.866 GPa/m and V_m = 0.1537 mm, one law fitted to "
          "joint.wall_modulus; residuals -0.55, +0.47, +0.24, -0.26 %\n");
    const std::string text = app::effective_configuration(s);
    INFO(text);
    CHECK(text.find("\n# maximum_closure       = 0.1537") != std::string::npos);
    CHECK(text.find("# default, fitted: residuals -0.55, +0.47, +0.24, -0.26 %\n") !=
          std::string::npos);
    // Without stresses of their own the moduli are those of the study's stresses.
    CHECK(read_good({"joint.closure=hyperbolic"}).parameters.joint.modulus_stress ==
          std::vector{0.15e6, 0.5e6});
}

TEST_CASE("joint laws: the law follows the draw of the stone's modulus", "[app][joint_laws]")
{
    const app::Study s =
        read_good(with(kFitted, {"stone.young_modulus=normal(mean 15.5 GPa, cov 0.1)"}));
    app::Parameters p = s.parameters;
    p.stone.young_modulus = 12e9;
    for (const app::ParameterRule& rule : s.rules) rule.apply(p, s.wall.course_height);
    const app::Study given = read_good(with(kFitted, {"stone.young_modulus=12 GPa"}));
    CHECK(p.joint.closing.initial_stiffness ==
          given.parameters.joint.closing.initial_stiffness);
    CHECK(p.joint.closing.maximum == given.parameters.joint.closing.maximum);
    CHECK(p.joint.closing.initial_stiffness != s.parameters.joint.closing.initial_stiffness);
}

TEST_CASE(
    "joint laws: envelopes and energies in shear reach cracks and mortar, and name the law "
    "of mixed modes",
    "[app][joint_laws]")
{
    const app::Study units =
        read_good({"unit.envelope=hyperbolic", "unit.shear_fracture_energy=1100 N/m"});
    const dem::CrackMaterial crack = study_texts::crack_material(units, 0);
    CHECK(crack.envelope == dem::Envelope::hyperbolic);
    CHECK(crack.shear_fracture_energy == 1100.0);
    const app::Study mortar = read_good(
        with(kMortar, {"joint.envelope=hyperbolic", "joint.shear_fracture_energy=0.1 N/mm"}));
    const dem::CrackMaterial bond = dem::bond_of(study_texts::joint_material(mortar, 0));
    CHECK(bond.envelope == dem::Envelope::hyperbolic);
    CHECK(bond.shear_fracture_energy == 100.0);
    for (const char* key : {"unit.envelope=hyperbolic", "unit.shear_fracture_energy=1 N/m"}) {
        CHECK(study_texts::laid(read_good({key})).mixed_mode);
        CHECK_FALSE(study_texts::laid(read_good({key, "wall.unit_cracks=no"})).mixed_mode);
    }
    for (const char* key : {"joint.envelope=hyperbolic", "joint.shear_fracture_energy=1 N/m"}) {
        CHECK(study_texts::laid(read_good(with(kMortar, {key}))).mixed_mode);
        CHECK_FALSE(study_texts::laid(read_good({key})).mixed_mode);
        CHECK_FALSE(has_mixed_law(study_texts::joint_material(read_good({key}), 0)));
    }
}

TEST_CASE("joint laws: keys of a law that is not chosen are named as without effect",
          "[app][joint_laws]")
{
    const std::string notes = app::effect_notes(
        read_good({"joint.initial_stiffness=4 GPa/m", "joint.closure_loss=0.1",
                   "joint.wall_modulus_stress=0.1, 0.2 MPa", "joint.envelope=hyperbolic",
                   "joint.shear_fracture_energy=1 N/m", "unit.envelope=hyperbolic",
                   "unit.tension_reduces_shear=no"}),
        kPush);
    CHECK(notes ==
          "note: joint.wall_modulus_stress: no effect, because joint.wall_modulus gives "
          "no law of closure\n"
          "note: joint.initial_stiffness, joint.closure_loss: no effect, because "
          "joint.closure is linear\n"
          "note: joint.envelope, joint.shear_fracture_energy: no effect, because joints "
          "have no mortar\n"
          "note: unit.tension_reduces_shear: no effect, because unit.envelope is "
          "hyperbolic\n");
}

TEST_CASE("joint laws: what friction takes of the tensile strength is told, where it does",
          "[app][joint_laws]")
{
    CHECK(
        notes_of(read_good({"unit.cohesion=1 MPa"})) ==
        "note: unit.envelope: coulomb leaves units 1.43 of 3.7 MPa in tension, because c < f_T "
        "tan(phi): friction takes 61 % of it; unit.envelope = hyperbolic keeps it\n");
    CHECK(
        notes_of(read_good(with(kMortar, {"joint.friction_angle=60 deg"}))) ==
        "note: joint.envelope: coulomb leaves mortar 0.115 of 0.2 MPa in tension, because c < "
        "f_T tan(phi): friction takes 42 % of it; joint.envelope = hyperbolic keeps it\n");
    for (const char* other : {"unit.envelope=hyperbolic", "unit.tension_reduces_shear=no",
                              "wall.unit_cracks=no", "unit.friction_angle=10 deg"})
        CHECK(notes_of(read_good({"unit.cohesion=1 MPa", other})).empty());
}
