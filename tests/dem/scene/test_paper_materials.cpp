#include "dem/scene/paper_materials.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// Table 4 at 0.50 MPa.
dem::PaperMaterials table_4()
{
    dem::PaperMaterials p;
    p.stone = {15.5e9, 0.2, 2300.0};
    p.joint = {.kn = 8.08e9, .ks = dem::shear_stiffness(8.08e9, 0.2), .friction_angle = 0.555};
    p.crack = {.tensile_strength = 3.7e6, .cohesion = 3.7e6, .fracture_energy = 110.0};
    p.crack.friction_angle = p.crack.residual_friction_angle = 0.611;
    return p;
}

} // namespace

TEST_CASE("paper materials: Eq. 2 gives the joint stiffness of the paper",
          "[dem][paper_materials]")
{
    // Moduli of Table 3 at 0.15, 0.50, 1.00 and 1.25 MPa; stiffness to the last digit given,
    // 5.87, 8.08, 11.34, 13.03 GPa/m.
    const auto [modulus, stiffness] = GENERATE(table<double, double>(
        {{566e6, 5.87e9}, {768e6, 8.08e9}, {1057e6, 11.34e9}, {1202e6, 13.03e9}}));
    CHECK(dem::joint_stiffness(0.1, modulus, 15.5e9) ==
          Approx(stiffness).margin(0.005e9).epsilon(0));
}

TEST_CASE("paper materials: joint stiffness agrees with Eq. 2 evaluated apart",
          "[dem][paper_materials]")
{
    // E_w E_s / (h (E_s - E_w)), by hand to five digits
    CHECK(dem::joint_stiffness(0.1, 566e6, 15.5e9) == Approx(5.8745e9).epsilon(1e-5));
    CHECK(dem::joint_stiffness(0.1, 768e6, 15.5e9) == Approx(8.0804e9).epsilon(1e-5));
    CHECK(dem::joint_stiffness(0.1, 1057e6, 15.5e9) == Approx(11.343e9).epsilon(5e-5));
    CHECK(dem::joint_stiffness(0.1, 1202e6, 15.5e9) == Approx(13.031e9).epsilon(5e-5));
}

TEST_CASE("paper materials: a course of stone and joint in series has the modulus of the wall",
          "[dem][paper_materials]")
{
    const double h = GENERATE(0.05, 0.1, 0.3), wall = GENERATE(1e8, 3e9, 15.4e9),
                 stone = 15.5e9;
    const double kn = dem::joint_stiffness(h, wall, stone);
    CHECK(h / (h / stone + 1.0 / kn) == Approx(wall).epsilon(1e-12));
}

TEST_CASE("paper materials: shear stiffness relates to the normal one as G to E",
          "[dem][paper_materials]")
{
    CHECK(dem::shear_stiffness(8e9, 0.0) == 4e9);
    CHECK(dem::shear_stiffness(8e9, 0.2) == Approx(8e9 / 2.4).epsilon(1e-15));
}

TEST_CASE("paper materials: each stiffness factor acts on its own contacts alone",
          "[dem][paper_materials]")
{
    dem::PaperMaterials p = table_4();
    p.joint.stiffness_factor = GENERATE(0.5, 1.0, 1.3);
    p.crack.stiffness_factor = GENERATE(0.7, 1.0);
    p.beam_friction_angle = 0.3;
    const dem::WallMaterials w = dem::wall_materials(p, dem::lay_out(dem::WallGeometry{}, 0.1));
    REQUIRE(w.joints.size() == 135);
    REQUIRE(w.cracks.size() == 45);
    CHECK(w.joints.back().kn == p.joint.stiffness_factor * 8.08e9);
    CHECK(w.joints.back().kn / w.joints.back().ks == Approx(2.4).epsilon(1e-15));
    CHECK(w.joints.back().tan_phi == std::tan(0.555));
    CHECK(w.cracks.back().kn == Approx(p.crack.stiffness_factor * 8.08e10).epsilon(1e-15));
    CHECK(w.cracks.back().kn / w.cracks.back().ks == Approx(2.4).epsilon(1e-15));
    CHECK(w.beam_joint.kn ==
          8.08e9); // one joint to a course, whatever the factor of the others
    CHECK(w.base_joint.kn == 8.08e9);
    CHECK(w.beam_joint.tan_phi == std::tan(0.3));
    CHECK_FALSE(w.vertical_stress.has_value());
}

TEST_CASE(
    "paper materials: a crack that snaps back keeps its strength, or loses what its energy "
    "does not cover",
    "[dem][paper_materials]")
{
    dem::CrackParameters c = table_4().crack;
    const double most = std::sqrt(2.0 * c.fracture_energy * 10.0 * 8.08e9); // where u_ul = u_el
    const double given = GENERATE_COPY(0.5 * most, 2.0 * most);
    c.tensile_strength = given;
    CHECK(dem::crack_material(c, 8.08e9, 0.2).ft == given);
    c.snap_back = dem::SnapBack::weakens;
    CHECK(dem::crack_material(c, 8.08e9, 0.2).ft ==
          Approx(std::min(given, most)).epsilon(1e-15));
    CHECK(dem::crack_material(c, 8.08e9, 0.2).cohesion == c.cohesion);
}

TEST_CASE("paper materials: a residual value above the initial one counts as the initial one",
          "[dem][paper_materials]")
{
    dem::CrackParameters c = table_4().crack;
    c.residual_cohesion = GENERATE(0.0, 1e6, 5e6);
    c.residual_friction_angle = GENERATE(0.2, 0.611, 0.9);
    const dem::CrackMaterial m = dem::crack_material(c, 8.08e9, 0.2);
    CHECK(m.cohesion_res == std::min(c.residual_cohesion, 3.7e6));
    CHECK(m.tan_phi_res == std::tan(std::min(c.residual_friction_angle, 0.611)));
}
