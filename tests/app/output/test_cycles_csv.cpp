#include "app/output/backbones_csv.hpp"
#include "app/output/cycles_csv.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace app;

TEST_CASE("backbones.csv: both directions, with positive displacements and forces",
          "[app][cyclic]")
{
    const std::vector<double> x{0, 0.002, 0, -0.001, 0}, f{0, 1000, 0, -500, 0};
    CHECK(backbones_csv({x, f}) ==
          "side,displacement_mm,force_kN\nright,0,0\nright,2,1\nleft,0,0\nleft,1,0.5\n");
}

TEST_CASE("cycles.csv: every column in its unit and place", "[app][cyclic]")
{
    fragility::Cycle a;
    a.end = 1;
    a.closed = true;
    a.displacement_plus = 4e-3;
    a.displacement_minus = -2e-3;
    a.force_plus = 9e3;
    a.force_minus = -8e3;
    a.force_at_plus = 6e3;
    a.force_at_minus = -3e3;
    a.energy = 3.0;
    a.residual_plus = 1e-3;
    a.residual_minus = -0.5e-3;
    fragility::Cycle b = a;
    b.begin = 1;
    b.end = 2;
    b.force_at_plus = 3e3;
    b.force_at_minus = -1.5e3;
    std::vector<dem::CurvePoint> curve(3);
    curve[1].energy = {
        .elastic = 0.5, .friction = 2.0, .fracture = 0.5, .crushing = 0.25, .damping = 0.125};
    curve[2].energy = {.kinetic = 0.25,
                       .elastic = 1.5,
                       .friction = 5.0,
                       .fracture = 1.5,
                       .crushing = 1.25,
                       .damping = 1.125,
                       .lifted = 2.0};
    const std::string table = cycles_csv({a, b}, curve);
    // Amplitude 3 mm; damping 3 J / (pi (6 kN 4 mm + 3 kN 2 mm)) = 3.18 %; stiffness 9 kN / 6
    // mm, then half of it.
    CHECK(table.find(
              "\n1,3,9,-8,3,3.18309886,1,-0.5,1.5,1,0.75,0.25,4,-2,1,2,0.5,0.25,0.125,0.5\n"
              "2,3,9,-8,3,6.36619772,1,-0.5,0.75,0.5,0.75,0.25,4,-2,1,3,1,1,1,3.25\n") !=
          std::string::npos);
}

TEST_CASE("cycles.csv: a value that a cycle does not have is an empty cell", "[app][cyclic]")
{
    const std::vector<double> x{0, 0.002, 0, -0.002, 0, 0.004},
        f{0, 1000, -500, -1000, 500, 2000};
    std::vector<dem::CurvePoint> curve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        curve[i].displacement = curve[i].interval_end = x[i];
        curve[i].energy.friction = 0.25 * static_cast<double>(i);
    }
    const std::string table = cycles_csv(fragility::cycles({x, f}), curve);
    // loop: 1 J on loading, -0.5 J back to zero, twice; residual at 2/3 of the way back
    CHECK(table.find("\n1,2,1,-1,1.5,") != std::string::npos);
    CHECK(table.find("\n2,4,2,0,5,") != std::string::npos);
    CHECK(table.find(",,,") != std::string::npos);
    CHECK(table.find(",1,1,0,0,0,0\n2,") != std::string::npos); // closed; 1 J of friction
    CHECK(table.ends_with(",0,0.25,0,0,0,0\n"));                // not closed
    CHECK(table.find("\n2,4,2,0,5,,") != std::string::npos);    // half a loop has no damping
}

TEST_CASE("cycles.csv: the ledger stands at the ends of the intervals of the curve",
          "[app][cyclic]")
{
    // Points in the middle of intervals of 2 mm, from 0 to 4 mm, to -2 mm and back to 0.
    const std::vector<double> x{0, 0.001, 0.003, 0.004, 0.003, 0.001, -0.001, -0.001, 0.001},
        end{0, 0.002, 0.004, 0.004, 0.002, 0, -0.002, 0, 0.002};
    std::vector<dem::CurvePoint> curve(x.size());
    std::vector<double> f;
    double way = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        way += i > 0 ? std::abs(end[i] - end[i - 1]) : 0.0;
        curve[i].displacement = x[i];
        curve[i].interval_end = end[i];
        curve[i].energy.friction = 1e3 * way;
        f.push_back(1e6 * x[i]);
    }
    const auto cycles = fragility::cycles({x, f});
    REQUIRE(cycles.size() == 2);
    const std::string table = cycles_csv(cycles, curve);
    CHECK(table.find(",12,0,0,0,0\n2,") != std::string::npos);
}

TEST_CASE("cycles.csv: joints that lose energy as they close have a column of their own",
          "[app][cyclic]")
{
    fragility::Cycle a;
    a.end = 1;
    std::vector<dem::CurvePoint> curve(2);
    curve[1].energy.friction = 2.0;
    CHECK(cycles_csv({a}, curve).find("closing_J") == std::string::npos);
    curve[1].energy.closing = 0.75;
    const std::string table = cycles_csv({a}, curve);
    CHECK(table.find(",solver_J,stored_J,closing_J\n") != std::string::npos);
    CHECK(table.ends_with(",2,0,0,0,0,0.75\n"));
}
