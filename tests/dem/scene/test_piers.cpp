/// Piers and spandrels: where they are, and that their forces are in balance with what acts on
/// the wall.

#include "dem/scene/mechanism/piers.hpp"

#include "dem/block/model.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "dem/scene/touching.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

const std::vector<dem::Opening> kDoorAndWindows = {
    {0.25, 0.0, 0.75, 2.0}, {1.5, 1.0, 0.5, 1.0}, {2.25, 1.0, 0.5, 1.0}};

dem::Discretisation cheap()
{
    dem::Discretisation d;
    d.contact_points = 3;
    d.block_modes = d.beam_modes = 6;
    return d;
}

/// A door beside a window, in courses of 0.2 m.
scenes::Scene facade()
{
    scenes::Scene s = scenes::paper_wall(0.15);
    s.wall.length = 2.0;
    s.wall.courses = 8;
    s.wall.course_height = 0.2;
    s.wall.unit_length = 0.4;
    s.wall.openings = {{0.4, 0.0, 0.4, 1.2}, {1.2, 0.4, 0.4, 0.8}};
    s.wall.lintel_bearing = 0.2;
    s.wall.lintel = s.stone;
    s.loads.height = 8 * 0.2 + s.beam.height;
    return s;
}

double relative(double a, double b) { return std::abs(a - b) / std::abs(b); }

} // namespace

TEST_CASE("piers: openings leave piers beside them and spandrels above them", "[dem][piers]")
{
    const dem::Piers p = dem::piers_of(kDoorAndWindows, {0.0, 0.0, 3.0, 3.0});
    REQUIRE(p.piers.size() == 4);
    CHECK(p.piers[0].at == dem::Region{0.0, 0.0, 0.25, 2.0});
    CHECK(p.piers[1].at == dem::Region{1.0, 1.0, 1.5, 2.0}); // free on both sides
    CHECK(p.piers[3].at == dem::Region{2.75, 1.0, 3.0, 2.0});
    for (const dem::Pier& pier : p.piers) {
        CHECK(pier.cut == 1.5);
        CHECK(pier.storey == 1);
    }
    REQUIRE(p.spandrels.size() == 3);
    CHECK(p.spandrels[0].at == dem::Region{0.25, 2.0, 1.0, 3.0});
    CHECK(p.spandrels[0].cut == 0.625);
}

TEST_CASE("piers: windows above windows are storeys, and what lies between them a spandrel",
          "[dem][piers]")
{
    const std::vector<dem::Opening> windows = {{0.5, 4.0, 1.0, 1.0}, {0.5, 1.0, 1.0, 1.2}};
    const dem::Piers p = dem::piers_of(windows, {0.0, 0.0, 2.0, 6.0});
    REQUIRE(p.piers.size() == 4);
    CHECK(p.piers[0].storey == 1);
    CHECK(p.piers[0].at == dem::Region{0.0, 1.0, 0.5, 2.2});
    CHECK(p.piers[3].storey == 2);
    CHECK(p.piers[3].at == dem::Region{1.5, 4.0, 2.0, 5.0});
    CHECK(p.spandrels[1].at == dem::Region{0.5, 2.2, 1.5, 4.0});
    CHECK(dem::piers_of({}, {0.0, 0.0, 2.0, 6.0}).piers.empty());
}

TEST_CASE(
    "piers: at every point of a push their shears are the force and their axial forces the "
    "load and weight above",
    "[dem][piers]")
{
    const scenes::Scene s = facade();
    const dem::Model m = scenes::model_of(s, cheap());
    dem::PushPlan plan;
    plan.targets = {GENERATE(0.004, -0.004)};
    plan.snapshot_every = 2e-4;
    dem::SolverOptions o;
    o.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan, o);
    REQUIRE(r.snapshots.size() > 15);
    const dem::PierProbe probe(m.layout, dem::piers_of(s.wall.openings, {0.0, 0.0, 2.0, 1.6}));
    REQUIRE(probe.piers().piers.size() == 3);
    const double above = s.loads.vertical_stress * m.layout.length * m.layout.thickness +
                         probe.weight_above(0, m.layout, s.stone, s.loads.gravity) +
                         dem::area_of(m.layout.blocks.back()) * m.layout.thickness *
                             s.loads.gravity * s.beam.material.density;
    double most = 0.0;
    for (const dem::Snapshot& shot : r.snapshots) most = std::max(most, std::abs(shot.force));
    int beyond = 0; // points, of some twenty
    for (const dem::Snapshot& shot : r.snapshots) {
        double shear = 0.0, normal = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const dem::CutForce f = probe.pier(i, shot).force;
            shear += f.shear;
            normal += f.normal;
        }
        INFO("at " << shot.displacement);
        // Blocks that slip at this moment have inertia.
        const double miss = std::abs(shear - probe.base_shear(shot)) / most;
        beyond += miss > 0.005 ? 1 : 0;
        CHECK(miss < 0.04);
        CHECK(std::abs(shear - shot.force) < 0.03 * most); // a mean over an interval
        CHECK(relative(normal, above) < 0.005);
    }
    CHECK(beyond <= 1);
}

TEST_CASE("piers: what a spandrel hands on is what its pier carries more or less than before",
          "[dem][piers]")
{
    // A cut around the pier at the left end and above the door: its axial force is the weight
    // above it, and what the spandrel beside it and the beam hand over.
    const scenes::Scene s = facade();
    const dem::Model m = scenes::model_of(s, cheap());
    dem::PushPlan plan;
    plan.targets = {0.003};
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan);
    const dem::Piers piers = dem::piers_of(s.wall.openings, {0.0, 0.0, 2.0, 1.6});
    const dem::PierProbe probe(m.layout, piers);
    const double normal = probe.pier(0, r.at_end).force.normal,
                 over = probe.spandrel(0, r.at_end).force.shear;
    const double cut = piers.spandrels.front().cut;
    double weight = 0.0;
    for (int b = 0; b < m.layout.beam; ++b)
        if (dem::centre_of(m.layout.blocks[b]).x < cut &&
            dem::centre_of(m.layout.blocks[b]).z > piers.piers.front().cut)
            weight += dem::area_of(m.layout.blocks[b]) * m.layout.thickness * s.loads.gravity *
                      s.stone.density;
    double beam = 0.0; // on the left of the cut
    for (const dem::FaceState& f : r.at_end.faces)
        if (f.kind == dem::FaceKind::beam_joint &&
            dem::centre_of(m.layout.blocks[f.block_a]).x < cut)
            for (const dem::ContactState& c : f.contacts) beam -= c.sigma * c.area;
    CHECK(normal == Approx(weight + beam + over).margin(0.005 * std::abs(normal)));
    CHECK(std::abs(over) < beam);
}

TEST_CASE("piers: the right end of a spandrel drops by its length times the sine of a turn",
          "[dem][piers]")
{
    const scenes::Scene s = facade();
    const dem::Model m = scenes::model_of(s, cheap());
    const dem::PierProbe probe(m.layout, dem::piers_of(s.wall.openings, {0.0, 0.0, 2.0, 1.6}));
    constexpr double kTurn = 0.1; // clockwise
    dem::Snapshot turned;
    for (const dem::Block& b : m.layout.blocks) {
        dem::BlockState state;
        for (const dem::Point p : dem::corners_of(b)) {
            state.outline.push_back(p);
            state.displacement.push_back({std::cos(kTurn) * p.x + std::sin(kTurn) * p.z - p.x,
                                          std::cos(kTurn) * p.z - std::sin(kTurn) * p.x - p.z});
        }
        turned.blocks.push_back(std::move(state));
    }
    REQUIRE(probe.piers().spandrels.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const dem::Region at = probe.piers().spandrels[i].at;
        CHECK(probe.spandrel(i, turned).drop ==
              Approx(std::sin(kTurn) * (at.x1 - at.x0)).epsilon(1e-10));
    }
}

TEST_CASE("piers: a pier alone moves by what its upper end moves against its lower end",
          "[dem][piers]")
{
    const scenes::Scene s = facade();
    const dem::Model m = scenes::model_of(s, cheap());
    dem::PushPlan plan;
    plan.targets = {0.02};
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan);
    const dem::PierProbe probe(m.layout, dem::piers_of(s.wall.openings, {0.0, 0.0, 2.0, 1.6}));
    for (std::size_t i = 0; i < 3; ++i) {
        const dem::Pier& p = probe.piers().piers[i];
        const dem::Snapshot alone = probe.alone(i, r.at_end);
        INFO("pier " << i + 1);
        CHECK_FALSE(alone.blocks.empty());
        CHECK(alone.displacement == probe.pier(i, r.at_end).displacement);
        for (const dem::BlockState& b : alone.blocks)
            for (const dem::Point& at : b.outline) {
                CHECK(at.x > p.at.x0 - 0.21); // a lintel may reach in
                CHECK(at.z < p.at.z1 - p.at.z0 + 1e-9);
            }
        if (std::abs(probe.pier(i, r.at_end).force.shear) < 0.05 * r.at_end.force) continue;
        const dem::Mechanism mechanism = dem::mechanism(alone, p.at.z1 - p.at.z0);
        CHECK(mechanism.turning_share + mechanism.sliding_share == Approx(1.0).margin(0.35));
    }
}
