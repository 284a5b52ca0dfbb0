/// Loops of pushed walls: closed forms, and what must hold whatever the numbers are.

#include "fragility/curve/cyclic_curve.hpp"

#include "dem/block/model.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

dem::Discretisation rigid(int contact_points)
{
    dem::Discretisation d;
    d.contact_points = contact_points;
    d.block_modes = d.beam_modes = 3;
    d.zones_per_interval = 1;
    return d;
}

dem::Discretisation coarse()
{
    dem::Discretisation d;
    d.contact_points = 3;
    d.block_modes = 6;
    return d;
}

/// A push, its path and its cycles.
struct Pushed {
    dem::PushResult result;
    std::vector<double> displacement, force;
    std::vector<fragility::Cycle> cycles;
};

Pushed pushed(const dem::Model& m, const dem::WallMaterials& w, std::vector<double> targets,
              double accuracy = dem::SolverOptions{}.accuracy)
{
    dem::PushPlan plan;
    plan.targets = std::move(targets);
    dem::SolverOptions options;
    options.accuracy = accuracy;
    Pushed p{dem::push(m, w, plan, options), {}, {}, {}};
    for (const dem::CurvePoint& at : p.result.curve) {
        p.displacement.push_back(at.displacement);
        p.force.push_back(at.force);
    }
    p.cycles = fragility::cycles({p.displacement, p.force});
    return p;
}

/// Energy that the ledger lost in friction in one cycle [J].
double friction(const Pushed& p, const fragility::Cycle& c)
{
    return p.result.curve[c.end].energy.friction - p.result.curve[c.begin].energy.friction;
}

/// A low block that slides: friction angle 5.7 degrees at its base, none elsewhere.
struct Slider {
    static constexpr double kHeight = 0.02; // [m]
    scenes::Scene scene = scenes::monolith(1.0, kHeight, 0.5e6, 1e10);
    dem::Model model;
    dem::WallMaterials materials;
    double strength = 0.0, stiffness = 0.0; ///< [N] [N/m]

    Slider()
    {
        scene.wall.toe = dem::Toe::free;
        scene.loads.height = kHeight;
        scene.stone.young_modulus = scene.beam.material.young_modulus = 1e15;
        model = scenes::model_of(scene, rigid(5));
        materials = scenes::uniform(scene, model);
        materials.base_joint.tan_phi = 0.1;
        const double t = scene.wall.thickness,
                     n = 0.5e6 * t + scene.stone.density * 9.81 * kHeight * t;
        strength = 0.1 * n;
        // Shear of base and beam joint in series, and the turn of the block on its base.
        stiffness = 1.0 / (2.0 / (scene.joint.ks * t) +
                           12.0 * kHeight * kHeight / (scene.joint.kn * t));
    }
};

} // namespace

TEST_CASE("pushed cycles: a sliding block has the energy and damping of its closed form",
          "[fragility][cyclic]")
{
    const Slider s;
    const double d = 5.03e-3, f = s.strength, elastic = f / s.stiffness;
    // The first cycle begins without stress; the third ends where the drive stops.
    const Pushed p = pushed(s.model, s.materials, {d, -d, d, -d, d, -d, 0.0}, 1e-5);
    REQUIRE(p.cycles.size() == 3);
    const fragility::Cycle& c = p.cycles[1];
    const double energy = 4.0 * f * (d - elastic);
    CHECK(c.displacement_plus == d);
    CHECK(c.displacement_minus == -d);
    CHECK(friction(p, c) == Approx(energy).epsilon(1e-6));
    // A cycle ends at zero exactly; the first has slipped 4 d - 5 F / k by then.
    CHECK(p.result.curve[c.begin].energy.friction ==
          Approx(f * (4.0 * d - 5.0 * elastic)).epsilon(1e-6));
    // The loop has what the solver takes besides, and no more.
    const double solver =
        p.result.curve[c.end].energy.damping - p.result.curve[c.begin].energy.damping;
    CHECK(solver < 1e-5 * energy);
    CHECK(c.energy == Approx(energy + solver).epsilon(1e-5));
    CHECK(fragility::equivalent_damping(c).value() ==
          Approx(2.0 / std::numbers::pi * (1.0 - elastic / d)).epsilon(1e-4));
    CHECK(c.residual_plus.value() == Approx(d - elastic).epsilon(1e-5));
}

TEST_CASE("pushed cycles: a rocking block that cannot slip dissipates nothing, comes back to "
          "zero and is symmetric",
          "[fragility][cyclic]")
{
    scenes::Scene s = scenes::monolith(1.0, 1.0, 0.5e6, 1e10); // its toe is held
    s.stone.young_modulus = s.beam.material.young_modulus = 1e15;
    const dem::Model m = scenes::model_of(s, rigid(33));
    const double d = 10e-3;
    const Pushed p = pushed(m, scenes::uniform(s, m), {d, -d, 0.0});
    REQUIRE(p.cycles.size() == 1);
    const fragility::Cycle& c = p.cycles[0];
    const double whole = 4.0 * c.force_plus * d; // a loop as large as can be
    CHECK(std::abs(c.energy) < 1e-3 * whole);
    CHECK(p.result.energy.damping < 1e-4 * whole);
    CHECK(std::abs(c.residual_plus.value()) < 1e-3 * d);
    CHECK(c.force_minus == Approx(-c.force_plus).epsilon(1e-3));
}

TEST_CASE("pushed cycles: the last cycle ends at zero and unloads as all others do, however "
          "small it is",
          "[fragility][cyclic]")
{
    scenes::Scene s = scenes::monolith(1.0, 1.0, 0.5e6, 1e10);
    s.stone.young_modulus = s.beam.material.young_modulus = 1e15;
    const dem::Model m = scenes::model_of(s, rigid(5));
    const double d = GENERATE(0.2e-3, 1e-3);
    const Pushed p = pushed(m, scenes::uniform(s, m), {d, -d, d, -d, 0.0});
    REQUIRE(p.cycles.size() == 2);
    CHECK(p.displacement.back() == 0.0);
    for (const fragility::Cycle& c : p.cycles) {
        CHECK(c.closed);
        REQUIRE(c.residual_plus);
        REQUIRE(c.residual_minus);
        CHECK(std::abs(*c.residual_minus) < 0.01 * d);
    }
    // A push one way ends with the mean over its last interval, as ever.
    CHECK(pushed(m, scenes::uniform(s, m), {d}).displacement.back() < d);
}

TEST_CASE("pushed cycles: a rocking block that may slip loses energy where contact points "
          "unload, and none to the solver",
          "[fragility][cyclic]")
{
    scenes::Scene s = scenes::monolith(0.5, 1.0, 0.5e6, 1e10);
    s.wall.toe = dem::Toe::free;
    const dem::Model m = scenes::model_of(s);
    const double d = 10e-3;
    const Pushed p = pushed(m, scenes::uniform(s, m), {d, -d, d, -d, 0.0});
    const fragility::Cycle& c = p.cycles[1];
    const double whole = 4.0 * c.force_plus * d;
    CHECK(std::abs(c.energy) < 0.01 * whole);
    CHECK(p.result.energy.damping < 1e-3 * whole);
}

namespace {

/// Forces of one way between two turns at displacements between both [N].
std::vector<double> forces_of_way(const Pushed& p, std::size_t from, std::size_t to)
{
    constexpr int kPoints = 100;
    const double x0 = p.displacement[from], x1 = p.displacement[to];
    std::vector<double> forces;
    std::size_t i = from + 1;
    for (int k = 1; k < kPoints; ++k) {
        const double x = x0 + (x1 - x0) * k / kPoints;
        while ((p.displacement[i] - x) * (x1 - x0) < 0.0) ++i;
        const double t =
            (x - p.displacement[i - 1]) / (p.displacement[i] - p.displacement[i - 1]);
        forces.push_back(p.force[i - 1] + t * (p.force[i] - p.force[i - 1]));
    }
    return forces;
}

/// Points at which the path turns back.
std::vector<std::size_t> turns(const Pushed& p)
{
    std::vector<std::size_t> at;
    const auto& x = p.displacement;
    for (std::size_t i = 1; i + 1 < x.size(); ++i)
        if ((x[i] - x[i - 1]) * (x[i + 1] - x[i]) < 0.0) at.push_back(i);
    return at;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

} // namespace

TEST_CASE("pushed cycles: equal cycles of a whole wall that is not damaged retrace each other",
          "[fragility][cyclic]")
{
    const double d = 1e-3;
    const scenes::Scene s = scenes::paper_wall(0.50);
    const dem::Model m = scenes::model_of(s, coarse());
    const Pushed p = pushed(m, scenes::uniform(s, m), {d, -d, d, -d, d, -d, 0.0});
    const std::vector<std::size_t> t = turns(p);
    REQUIRE(t.size() == 6);
    CHECK(p.result.energy.fracture == 0.0);
    for (const std::size_t i : t) { // nothing bends before these turns: the way leads on
        const double along = (p.displacement[i] - p.displacement[i - 1]) /
                             (p.displacement[i - 1] - p.displacement[i - 2]);
        CHECK(p.force[i] - p.force[i - 1] ==
              Approx(along * (p.force[i - 1] - p.force[i - 2])).epsilon(0.02));
    }
    const double peak = p.cycles[0].force_plus;
    for (std::size_t k : {2, 3, 4})
        CHECK(largest_difference(forces_of_way(p, t[k - 2], t[k - 1]),
                                 forces_of_way(p, t[k], t[k + 1])) < 0.005 * peak);
}

TEST_CASE("pushed cycles: damage never heals, and a crack that closes carries compression",
          "[fragility][cyclic]")
{
    const scenes::Scene s = scenes::paper_wall(1.25);
    const dem::Model m = scenes::model_of(s, coarse());
    dem::PushPlan plan;
    plan.targets = {6e-3, -6e-3, 6e-3, 0.0};
    plan.snapshot_every = 0.5e-3;
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan);
    int closed_again = 0;
    for (std::size_t f = 0; f < r.at_end.faces.size(); ++f) {
        if (r.at_end.faces[f].kind != dem::FaceKind::unit_crack) continue;
        for (std::size_t c = 0; c < r.at_end.faces[f].contacts.size(); ++c) {
            double damage = 0.0;
            bool was_open = false, closed = false;
            for (const dem::Snapshot& shot : r.snapshots) {
                const dem::ContactState& now = shot.faces[f].contacts[c];
                REQUIRE(now.damage >= damage);
                damage = now.damage;
                was_open = was_open || (damage >= 1.0 && now.sigma == 0.0);
                closed = closed || (was_open && now.sigma < -1e4);
            }
            closed_again += closed ? 1 : 0;
        }
    }
    CHECK(closed_again > 0);
}

TEST_CASE("pushed cycles: the ledger of all cycles is that of the push", "[fragility][cyclic]")
{
    const scenes::Scene s = scenes::paper_wall(1.25);
    const dem::Model m = scenes::model_of(s, coarse());
    const Pushed p = pushed(m, scenes::uniform(s, m), {3e-3, -3e-3, 6e-3, -6e-3, 0.0});
    REQUIRE(p.cycles.size() == 2);
    double all = 0.0;
    for (const fragility::Cycle& c : p.cycles) all += friction(p, c);
    CHECK(all == Approx(p.result.curve.back().energy.friction).epsilon(1e-3));
    CHECK(p.result.residual < 0.005);
    REQUIRE(p.result.at_farthest);
    CHECK(p.result.at_farthest->displacement == -6e-3);
}
