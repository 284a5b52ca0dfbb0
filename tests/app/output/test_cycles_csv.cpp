#include "app/output/backbones_csv.hpp"
#include "app/output/cycles_csv.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
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
    std::vector<dem::Energy> ledger(3);
    ledger[1] = {
        .elastic = 0.5, .friction = 2.0, .fracture = 0.5, .crushing = 0.25, .damping = 0.125};
    ledger[2] = {.kinetic = 0.25,
                 .elastic = 1.5,
                 .friction = 5.0,
                 .fracture = 1.5,
                 .crushing = 1.25,
                 .damping = 1.125,
                 .lifted = 2.0};
    const std::string table = cycles_csv({a, b}, ledger);
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
    std::vector<dem::Energy> ledger(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        ledger[i].friction = 0.25 * static_cast<double>(i);
    const std::string table = cycles_csv(fragility::cycles({x, f}), ledger);
    // loop: 1 J on loading, -0.5 J back to zero, twice; residual at 2/3 of the way back
    CHECK(table.find("\n1,2,1,-1,1.5,") != std::string::npos);
    CHECK(table.find("\n2,4,2,0,5,") != std::string::npos);
    CHECK(table.find(",,,") != std::string::npos);
    CHECK(table.find(",1,1,0,0,0,0\n2,") != std::string::npos); // closed; 1 J of friction
    CHECK(table.ends_with(",0,0.25,0,0,0,0\n"));                // not closed
}

TEST_CASE("cycles.csv: joints that lose energy as they close have a column of their own",
          "[app][cyclic]")
{
    fragility::Cycle a;
    a.end = 1;
    std::vector<dem::Energy> ledger(2);
    ledger[1].friction = 2.0;
    CHECK(cycles_csv({a}, ledger).find("closing_J") == std::string::npos);
    ledger[1].closing = 0.75;
    const std::string table = cycles_csv({a}, ledger);
    CHECK(table.find(",solver_J,stored_J,closing_J\n") != std::string::npos);
    CHECK(table.ends_with(",2,0,0,0,0,0.75\n"));
}
