/// Walls under vertical load: problem 12 of the verification list and the wall modulus of Table
/// 3.

#include "dem/block/model.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace {

/// Ten blocks on top of each other, eleven joints with base and beam.
scenes::Scene stack(double stress)
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.length = s.wall.unit_length = 0.2;
    s.wall.bond_offset = 0.0;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.wall.base = dem::Base::joint;
    s.stone.density = 2700.0;
    s.beam.material = {1e15, 0.2, 0.0};
    s.loads.vertical_stress = stress;
    s.joint.kn = 8.0804e9;
    return s;
}

/// Settlement under vertical load and self-weight [m].
double settlement(const scenes::Scene& s, const dem::Discretisation& d = {})
{
    const dem::Model m = scenes::model_of(s, d);
    dem::SolverOptions options;
    options.preload_unbalance = 1e-9;
    options.preload_steps = 40000;
    dem::PushPlan plan;
    plan.targets = {1e-7};
    return dem::push(m, scenes::uniform(s, m), plan, options).settlement;
}

} // namespace

TEST_CASE("static wall: a stack settles by its joints and its stone in series",
          "[dem][static_wall]")
{
    scenes::Scene s = stack(0.5e6);
    s.loads.gravity = 0.0;
    dem::Discretisation d;
    d.block_modes = GENERATE(0, 6);
    SECTION("joints 0.68067 mm and stone 0.0323 mm")
    {
        s.stone.poisson_ratio = 0.0; // friction would hold the blocks' lateral expansion
        CHECK(settlement(s, d) == Approx(0.68067e-3 + 0.03226e-3).epsilon(1e-4));
    }
    SECTION("rigid stone: joints alone")
    {
        s.stone.young_modulus = 1e15;
        CHECK(settlement(s, d) == Approx(0.68067e-3).epsilon(1e-4));
    }
}

TEST_CASE("static wall: ten blocks under their own weight settle by 0.0180 mm",
          "[dem][static_wall]")
{
    scenes::Scene s = stack(0.0);
    s.stone.young_modulus = 1e15;
    s.joint.kn = 8.08e9;
    CHECK(settlement(s) == Approx(1.80295e-5).epsilon(1e-4));
}

TEST_CASE(
    "static wall: a block on its joint has the frequency of a mass on a spring, 870.65 Hz",
    "[dem][static_wall]")
{
    scenes::Scene s = stack(0.0);
    s.wall.courses = 1;
    s.loads.height = 0.2;
    s.stone.young_modulus = 1e15;
    s.joint.kn = 8.08e9;
    // Settlement under its own weight is g / omega^2.
    CHECK(std::sqrt(s.loads.gravity / settlement(s)) / (2.0 * std::numbers::pi) ==
          Approx(870.65).epsilon(1e-3));
}

TEST_CASE("static wall: the paper's wall has the modulus of Table 3", "[dem][static_wall]")
{
    const auto [stress, modulus] = GENERATE(
        table<double, double>({{0.15, 566e6}, {0.50, 768e6}, {1.00, 1057e6}, {1.25, 1202e6}}));
    scenes::Scene s = scenes::paper_wall(stress);
    s.loads.gravity = 0.0;
    const double computed = stress * 1e6 * 1.0 / settlement(s); // the wall is 1 m high
    CHECK(computed == Approx(modulus).epsilon(0.01));
}
