/// Losses of a block that rocks to and fro: the friction of its joint, and nothing to the
/// solver.

#include "fragility/curve/cyclic_curve.hpp"

#include "dem/block/model.hpp"
#include "scenes/paper_wall.hpp"
#include "scenes/rocking_statics.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace {

/// A rigid block of 1 m x 1 m under 0.50 MPa that rocks on a joint and may slip.
struct Rocker {
    scenes::Scene scene = scenes::monolith(1.0, 1.0, 0.5e6, 8.08e9);
    dem::Model model;
    dem::WallMaterials materials;

    explicit Rocker(double friction_angle_deg, int contact_points)
    {
        scene.wall.toe = dem::Toe::free;
        scene.stone.young_modulus = scene.beam.material.young_modulus = 1e15;
        dem::Discretisation d;
        d.contact_points = contact_points;
        d.block_modes = d.beam_modes = 3;
        d.zones_per_interval = 1;
        model = scenes::model_of(scene, d);
        materials = scenes::uniform(scene, model);
        materials.base_joint.tan_phi = std::tan(friction_angle_deg * std::acos(-1.0) / 180.0);
    }
};

} // namespace

TEST_CASE("rocking loops: a block that may slip loses what its joint loses in balance at every "
          "moment, and the solver next to nothing",
          "[fragility][cyclic][repeats]")
{
    const auto [angle, points] =
        GENERATE(table<double, int>({{25.0, 9}, {31.8, 9}, {31.8, 17}, {50.0, 9}}));
    const double d = 10e-3;
    const Rocker rocker(angle, points);
    dem::PushPlan plan;
    plan.targets = {d, -d, d, -d, 0.0};
    dem::SolverOptions options;
    options.accuracy = 5e-5;
    const dem::PushResult r = dem::push(rocker.model, rocker.materials, plan, options);
    std::vector<double> displacement, force;
    for (const dem::CurvePoint& p : r.curve) {
        displacement.push_back(p.displacement);
        force.push_back(p.force);
    }
    const fragility::Cycle c = fragility::cycles({displacement, force}).at(1);
    const auto lost = [&](double dem::Energy::*part) {
        return r.curve[c.end].energy.*part - r.curve[c.begin].energy.*part;
    };
    const scenes::RockingLoop exact =
        scenes::rocking_loop(scenes::in_balance(rocker.scene, rocker.materials, r.at_end), d);
    const double whole = 4.0 * exact.force * d;
    CHECK(exact.energy > 0.015 * whole);
    CHECK(exact.friction == Approx(exact.energy).margin(2e-4 * whole)); // its steps
    CHECK(c.energy == Approx(exact.energy).margin(1e-4 * whole));
    CHECK(c.force_plus == Approx(exact.force).epsilon(5e-5));
    CHECK(lost(&dem::Energy::friction) == Approx(exact.energy).margin(2e-4 * whole));
    CHECK(lost(&dem::Energy::damping) < 1.2e-4 * whole);
}
