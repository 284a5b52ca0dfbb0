/// Verdicts on walls under their vertical load: rest where there is an equilibrium, a fall
/// where there is none.

#include "dem/block/model.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

dem::Discretisation rigid()
{
    dem::Discretisation d;
    d.contact_points = 2;
    d.zones_per_interval = 1;
    d.block_modes = d.beam_modes = 3;
    return d;
}

/// Blocks of a stack without beam, on beds that are inclined, on a wedge; pushed by body
/// forces.
dem::PushResult inclined(double slope, double tan_phi, int blocks, dem::SolverOptions o)
{
    scenes::Scene s = scenes::monolith(1.0, 1.0, 0.0, 1e11);
    s.beam.present = false;
    s.loads.pattern = dem::LoadPattern::body;
    s.joint.tan_phi = tan_phi;
    const double angle = std::atan(slope), c = std::cos(angle), n = std::sin(angle);
    const auto at = [&](double along, double up) {
        return dem::Point{0.5 + along * c - up * n, 0.1 + along * n + up * c};
    };
    dem::DrawnWall w;
    w.base = dem::Base::joint;
    w.units.push_back({{{at(0, 0).x, 0.0}, {at(0.8, 0).x, 0.0}, at(0.8, 0), at(0, 0)}});
    for (int i = 0; i < blocks; ++i)
        w.units.push_back(
            {{at(0, 0.2 * i), at(0.8, 0.2 * i), at(0.8, 0.2 * (i + 1)), at(0, 0.2 * (i + 1))}});
    s.loads.height = 0.3;
    const dem::Model m = dem::discretise(dem::drawn_layout(w, 0.0), s.stone, s.beam, s.loads,
                                         {s.joint, s.crack}, rigid());
    dem::PushPlan plan;
    plan.targets = {1e-5};
    return dem::push(m, scenes::uniform(s, m), plan, o);
}

} // namespace

TEST_CASE("standing: a block on joints as stiff as stone is pushed and does not fall",
          "[dem][standing]")
{
    scenes::Scene s = scenes::monolith(1.0, 1.0, 0.5e6, 2.4e14);
    s.joint.tan_phi = scenes::tan_deg(75.0);
    s.beam.material.density = 7500.0;
    s.loads.top = GENERATE(dem::TopLoad::dead, dem::TopLoad::fixed_line, dem::TopLoad::follower,
                           dem::TopLoad::link);
    s.loads.link_length = 1.0;
    const dem::Model m = scenes::model_of(s, rigid());
    dem::PushPlan plan;
    plan.targets = {5e-5};
    dem::SolverOptions o;
    o.kinematics = dem::Kinematics::finite;
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan, o);
    CHECK(r.settled);
    CHECK(r.slow_starts == 0);
    CHECK(r.outcome == dem::Outcome::reached_target);
}

TEST_CASE("standing: a block that slides down a slope has come down, one that grips stands",
          "[dem][standing]")
{
    dem::SolverOptions o;
    o.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    const double slope = 0.5;
    // Friction takes nearly all of what the weight gives on its way.
    const dem::PushResult slides = inclined(slope, 0.99 * slope, 2, o),
                          grips = inclined(slope, 1.01 * slope, 2, o);
    CHECK(slides.outcome == dem::Outcome::lost_equilibrium);
    CHECK(slides.curve.size() == 1);
    CHECK(slides.slow_starts == 1);
    CHECK(grips.settled);
    CHECK(grips.slow_starts == 0);
    CHECK(grips.outcome == dem::Outcome::reached_target);
}

TEST_CASE("standing: a wall that has no time to come to rest is loaded slowly and stands",
          "[dem][standing]")
{
    dem::SolverOptions o;
    o.preload_steps = 100;                                    // its first sway takes more
    const dem::PushResult hasty = inclined(0.38, 0.9, 10, o); // turns at 0.4
    CHECK(hasty.slow_starts == 1);
    CHECK(hasty.settled);
    CHECK(hasty.outcome == dem::Outcome::reached_target);
    CHECK(hasty.residual < 0.01);
}
