#include "app/output/cycle_columns.hpp"
#include "tests/app/push_scenes.hpp"
#include "tests/app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace {

/// A wall that is pushed to and fro until it slides, cracks and crushes.
app::PushedWall pushed()
{
    return scenes::pushed(study_texts::read(
        study_texts::kSmallWall,
        {"wall.unit_cracks=yes", "unit.tensile_strength=0.2 MPa", "unit.fracture_energy=10 N/m",
         "joint.friction_angle=35 deg", "joint.compressive_strength=3 MPa",
         "joint.crushing_energy=2000 N/m", "load.vertical_stress=0.5 MPa",
         "load.amplitudes=1, 4 mm", "solver.fidelity=simple", "output.record_every=0.02 mm"}));
}

} // namespace

TEST_CASE("cycle parts: they add up to the loop, and no part of it can be missing",
          "[app][cyclic]")
{
    const app::PushedWall wall = pushed();
    const auto cycles = fragility::cycles({wall.displacement, wall.force});
    REQUIRE(cycles.size() == 2);
    std::map<std::string, std::vector<double>, std::less<>> parts;
    for (const app::CycleColumn& c : app::cycle_columns(cycles, wall.result.curve))
        if (c.unit == "J" && c.name != "energy" && c.name != "closing")
            for (const auto& v : c.values) parts[std::string(c.name)].push_back(v.value());
    CHECK(parts.size() == 5);
    std::map<std::string, double, std::less<>> largest; // share of the energy that passes
    constexpr double kMargin = 3e-4; // straight lines between the points of the curve
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        const fragility::Cycle& c = cycles[i];
        const double through = 2.0 * fragility::amplitude(c) * (c.force_plus - c.force_minus);
        double sum = 0.0;
        for (const auto& [name, values] : parts) {
            sum += values[i];
            largest[name] = std::max(largest[name], std::abs(values[i]) / through);
        }
        // The force of a point leaves out a part of what damping takes.
        CHECK(sum < c.energy + parts.at("solver")[i] + kMargin * through);
        CHECK(sum > c.energy - kMargin * through);
    }
    for (const auto& [name, share] : largest) {
        INFO(name);
        CHECK(share > 5.0 * kMargin);
    }
}

TEST_CASE(
    "cycle parts: a wall that turns where it has just begun to slide carries no more than "
    "friction does, and its first loop has no negative energy",
    "[app][cyclic]")
{
    const std::string amplitude = GENERATE("0.12 mm", "0.15 mm");
    const app::PushedWall wall = scenes::pushed(
        study_texts::read(study_texts::kSmallWall,
                          {"wall.base=joint", "wall.toe=free", "joint.friction_angle=6 deg",
                           "joint.wall_modulus=1500 MPa", "load.vertical_stress=0.5 MPa",
                           "load.amplitudes=" + amplitude, "load.gravity=0 m/s2",
                           "solver.accuracy=1 %", "solver.steps_per_mm=400"}));
    const auto cycles = fragility::cycles({wall.displacement, wall.force});
    REQUIRE(cycles.size() == 1);
    const double friction = std::tan(6.0 * std::acos(-1.0) / 180.0) * 0.5e6 * 0.6 * 0.2;
    INFO(amplitude << ", forces / friction " << cycles[0].force_plus / friction << ", "
                   << cycles[0].force_minus / friction << ", energy " << cycles[0].energy);
    CHECK(cycles[0].force_plus < 1.02 * friction);
    CHECK(cycles[0].force_plus > 0.9 * friction);
    CHECK(cycles[0].force_minus > -1.02 * friction);
    CHECK(cycles[0].energy > 0.0);
}
