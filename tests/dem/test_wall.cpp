#include "dem/scene/wall.hpp"

#include <catch2/catch.hpp>

TEST_CASE("wall: Eq. 2 gives the joint stiffness of the paper", "[dem][wall]")
{
    // Moduli of Table 3 at 0.15, 0.50, 1.00 and 1.25 MPa; stiffness to the last digit given,
    // 5.87, 8.08, 11.34, 13.03 GPa/m.
    const auto [modulus, stiffness] = GENERATE(table<double, double>(
        {{566e6, 5.87e9}, {768e6, 8.08e9}, {1057e6, 11.34e9}, {1202e6, 13.03e9}}));
    CHECK(dem::joint_stiffness(0.1, modulus, 15.5e9) ==
          Approx(stiffness).margin(0.005e9).epsilon(0));
}

TEST_CASE("wall: joint stiffness agrees with Eq. 2 evaluated apart", "[dem][wall]")
{
    // E_w E_s / (h (E_s - E_w)), by hand to five digits
    CHECK(dem::joint_stiffness(0.1, 566e6, 15.5e9) == Approx(5.8745e9).epsilon(1e-5));
    CHECK(dem::joint_stiffness(0.1, 768e6, 15.5e9) == Approx(8.0804e9).epsilon(1e-5));
    CHECK(dem::joint_stiffness(0.1, 1057e6, 15.5e9) == Approx(11.343e9).epsilon(5e-5));
    CHECK(dem::joint_stiffness(0.1, 1202e6, 15.5e9) == Approx(13.031e9).epsilon(5e-5));
}

TEST_CASE("wall: a course of stone and joint in series has the modulus of the wall",
          "[dem][wall]")
{
    const double h = GENERATE(0.05, 0.1, 0.3), wall = GENERATE(1e8, 3e9, 15.4e9),
                 stone = 15.5e9;
    const double kn = dem::joint_stiffness(h, wall, stone);
    CHECK(h / (h / stone + 1.0 / kn) == Approx(wall).epsilon(1e-12));
}

TEST_CASE("wall: shear stiffness relates to the normal one as G to E", "[dem][wall]")
{
    CHECK(dem::shear_stiffness(8e9, 0.0) == 4e9);
    CHECK(dem::shear_stiffness(8e9, 0.2) == Approx(8e9 / 2.4).epsilon(1e-15));
}
