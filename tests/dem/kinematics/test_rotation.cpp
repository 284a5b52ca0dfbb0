#include "dem/kinematics/rotation.hpp"
#include "tests/dem/bits.hpp"

#include <catch2/catch.hpp>

#include <cmath>

TEST_CASE(
    "rotation: half a turn of any size is the sine and cosine of the C library within 2e-16",
    "[dem][rotation]")
{
    for (int i = -20000; i <= 20000; ++i) {
        const double angle = 1e-3 * i; // -20 ... 20, through all quarters
        const dem::HalfTurn<double> h = dem::half_turn(angle);
        const double c = std::abs(h.c - std::cos(0.5 * angle)),
                     s = std::abs(h.s - std::sin(0.5 * angle));
        if (c > 2e-16 || s > 2e-16) FAIL("at " << angle << ": " << c << ", " << s);
    }
}

TEST_CASE(
    "rotation: a register turns every lane as one wall alone would, whatever the others do",
    "[dem][rotation]")
{
    for (const double big : {0.1, 1.0, 3.0, 7.0}) {
        dem::Pack angles(0.0);
        for (int i = 0; i < dem::lanes<dem::Pack>; ++i)
            angles.set(i, (i % 2 == 0 ? 0.3 : big) * (1.0 + 0.1 * i));
        const dem::HalfTurn<dem::Pack> h = dem::half_turn(angles);
        for (int i = 0; i < dem::lanes<dem::Pack>; ++i) {
            const dem::HalfTurn<double> one = dem::half_turn(angles[i]);
            CHECK(bits::same_number(h.c[i], one.c));
            CHECK(bits::same_number(h.s[i], one.s));
        }
    }
}

TEST_CASE("rotation: the whole turn is twice the half", "[dem][rotation]")
{
    const double angle = GENERATE(-2.5, -0.7, 0.0, 1e-9, 0.2, 3.0);
    const dem::Turn<double> t = dem::whole(dem::half_turn(angle));
    CHECK(t.c == Approx(std::cos(angle)).margin(1e-15));
    CHECK(t.s == Approx(std::sin(angle)).margin(1e-15));
}
