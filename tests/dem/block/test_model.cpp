#include "tests/dem/model_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

namespace {

using dem::Contact;
using dem::FaceKind;
using dem::FaceRule;
using dem::Model;
using dem::Point;
using model_scenes::coarse;
using model_scenes::for_each_contact;
using model_scenes::small_wall;

/// The block a point of the solver's arrays is on.
int block_of(const Model& m, int point)
{
    for (std::size_t b = 0; b < m.places.size(); ++b) {
        const int i = point - m.places[b].first_point;
        if (i >= 0 && i < static_cast<int>(m.elements[m.places[b].element].points.size()))
            return static_cast<int>(b);
    }
    return dem::kGround;
}

/// Undeformed position in the wall of a point that is not the ground's.
Point place_of(const Model& m, int point)
{
    const dem::Block& block = m.layout.blocks[block_of(m, point)];
    const dem::BlockPlace& place = m.places[block_of(m, point)];
    const Point local = m.elements[place.element].points[point - place.first_point];
    return {block.x0 + local.x, block.z0 + local.z};
}

} // namespace

TEST_CASE("model: contacts join two points at one place, pointing from a to b", "[dem][model]")
{
    scenes::Scene s = small_wall();
    s.wall.base = dem::Base::joint;
    s.wall.bond_offset = GENERATE(0.5, 0.3);
    s.wall.length = GENERATE(0.4, 0.47);
    const Model m = scenes::model_of(s, coarse(0, GENERATE(FaceRule::even, FaceRule::lobatto)));
    for_each_contact(m, [&](const Contact& c, bool) {
        const dem::Face& f = m.layout.faces[c.face];
        CHECK(block_of(m, c.a) == f.a);
        CHECK(block_of(m, c.b) == f.b);
        const Point b = place_of(m, c.b);
        if (f.a != dem::kGround) {
            const Point a = place_of(m, c.a);
            CHECK(std::hypot(a.x - b.x, a.z - b.z) < 1e-7);
        }
        const bool bed = f.from.z == f.to.z;
        CHECK(c.nx == (bed ? 0.0 : 1.0));
        CHECK(c.nz == (bed ? 1.0 : 0.0));
        CHECK((b.x >= f.from.x - 1e-7 && b.x <= f.to.x + 1e-7));
        CHECK((b.z >= f.from.z - 1e-7 && b.z <= f.to.z + 1e-7));
        CHECK(c.area > 0.0);
    });
}

TEST_CASE("model: the contact areas of a face add up to it", "[dem][model]")
{
    scenes::Scene s = small_wall();
    s.wall.thickness = 0.17;
    s.wall.base = dem::Base::joint;
    s.wall.bond_offset = GENERATE(0.5, 0.3);
    const Model m = scenes::model_of(s, coarse(3, GENERATE(FaceRule::even, FaceRule::lobatto)));
    std::map<int, double> area;
    for_each_contact(m, [&area](const Contact& c, bool) { area[c.face] += c.area; });
    CHECK(area.size() == m.layout.faces.size());
    for (const auto& [face, sum] : area) {
        const dem::Face& f = m.layout.faces[face];
        CHECK(sum ==
              Approx(std::hypot(f.to.x - f.from.x, f.to.z - f.from.z) * 0.17).epsilon(1e-12));
    }
}

TEST_CASE("model: contacts have the material of their joint or crack, base and beam their own",
          "[dem][model]")
{
    scenes::Scene s = small_wall();
    s.wall.base = dem::Base::joint;
    s.beam.interface = GENERATE(dem::BeamInterface::tied, dem::BeamInterface::joint);
    const bool tied = s.beam.interface == dem::BeamInterface::tied;
    const Model m = scenes::model_of(s, coarse(3));
    std::set<int> joints, cracks;
    for (const Contact& c : m.cracks) {
        CHECK(m.layout.faces[c.face].kind == FaceKind::unit_crack);
        cracks.insert(c.material);
    }
    for (const auto* list : {&m.dry, &m.tied})
        for (const Contact& c : *list) {
            const dem::Face& f = m.layout.faces[c.face];
            CHECK(f.kind != FaceKind::unit_crack);
            CHECK((list == &m.tied) == (tied && f.kind == FaceKind::beam_joint));
            if (f.kind == FaceKind::base_joint) CHECK(c.material == dem::kBaseMaterial);
            if (f.kind == FaceKind::beam_joint) CHECK(c.material == dem::kBeamMaterial);
            if (f.id > 0) {
                CHECK(c.material == f.id - 1);
                joints.insert(c.material);
            }
        }
    CHECK(static_cast<int>(joints.size()) == m.layout.n_joints);
    CHECK(static_cast<int>(cracks.size()) == m.layout.n_cracks);
}

TEST_CASE(
    "model: points and modes of the blocks fill the solver's arrays without gap or overlap",
    "[dem][model]")
{
    const Model m = scenes::model_of(small_wall(), coarse(GENERATE(0, 6)));
    REQUIRE(m.places.size() == m.layout.blocks.size());
    int points = 0, modes = 0;
    for (const dem::BlockPlace& place : m.places) {
        CHECK(place.first_point == points);
        CHECK(place.first_mode == modes);
        points += static_cast<int>(m.elements[place.element].points.size());
        modes += static_cast<int>(m.elements[place.element].phi.cols());
    }
    CHECK(m.n_points == points);
    CHECK(m.n_modes == modes);
    CHECK(m.ground_point == points);
}

TEST_CASE("model: blocks that are alike share an element, and it has their size",
          "[dem][model]")
{
    const Model m = scenes::model_of(scenes::paper_wall(0.50), coarse(3));
    CHECK(m.elements.size() < 20);
    for (std::size_t b = 0; b < m.places.size(); ++b) {
        const dem::Block& block = m.layout.blocks[b];
        double width = 0.0, height = 0.0;
        for (const Point p : m.elements[m.places[b].element].outline) {
            width = std::max(width, p.x);
            height = std::max(height, p.z);
        }
        CHECK(width == Approx(block.x1 - block.x0).epsilon(1e-9));
        CHECK(height == Approx(block.z1 - block.z0).epsilon(1e-9));
    }
    // Third and fifth course: the same all along. First and third: another support.
    for (int i = 0; i < 10; ++i) {
        CHECK(m.places[20 + i].element == m.places[40 + i].element);
        CHECK(m.places[i].element != m.places[20 + i].element);
    }
    CHECK(m.places[22].element == m.places[24].element); // left halves inside a course
    CHECK(m.places[22].element != m.places[23].element); // left and right half
}

TEST_CASE("model: blocks alike but for their support have elements of their own",
          "[dem][model]")
{
    scenes::Scene s = small_wall(); // a column of whole units, held at its foot
    s.wall.length = s.wall.unit_length;
    s.wall.bond_offset = 0.0;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.wall.base = dem::Base::joint;
    const Model m = scenes::model_of(s, coarse(3));
    REQUIRE(m.places.size() == 4);
    CHECK(m.places[0].element != m.places[1].element);
    CHECK(m.places[1].element == m.places[2].element);
}

TEST_CASE("model: contact points are as dense on long faces as on those of a half unit",
          "[dem][model]")
{
    scenes::Scene s = small_wall();
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.wall.base = dem::Base::joint;
    dem::Discretisation d = coarse(3);
    d.contact_points = GENERATE(2, 4);
    const Model m = scenes::model_of(s, d);
    std::map<int, int> points;
    for_each_contact(m, [&points](const Contact& c, bool) { ++points[c.face]; });
    for (const auto& [face, n] : points) {
        const dem::Face& f = m.layout.faces[face];
        const double halves =
            std::hypot(f.to.x - f.from.x, f.to.z - f.from.z) / (0.5 * s.wall.unit_length);
        CHECK(n == static_cast<int>(std::lround(halves)) * (d.contact_points - 1) + 1);
    }
}

TEST_CASE("model: what makes no wall is refused", "[dem][model]")
{
    using Spoil = std::function<void(scenes::Scene&, dem::Discretisation&)>;
    const double nan = std::nan("");
    const std::vector<Spoil> faults = {
        [](auto& s, auto&) { s.wall.courses = 0; },
        [](auto& s, auto&) { s.wall.length = 0.0; },
        [nan](auto& s, auto&) { s.wall.length = nan; },
        [](auto& s, auto&) { s.wall.thickness = -0.2; },
        [](auto& s, auto&) { s.wall.course_height = 0.0; },
        [](auto& s, auto&) { s.wall.unit_length = 0.0; },
        [](auto& s, auto&) { s.wall.bond_offset = 1.0; },
        [](auto& s, auto&) { s.wall.bond_offset = -0.1; },
        [](auto& s, auto&) { s.beam.height = 0.0; },
        [](auto& s, auto&) { s.loads.height = 0.29; }, // top of the wall: 0.30 m
        [](auto& s, auto&) { s.loads.height = 0.41; }, // top of the beam: 0.40 m
        [nan](auto& s, auto&) { s.loads.height = nan; },
        [](auto& s, auto&) { s.loads.vertical_stress = -1.0; },
        [nan](auto& s, auto&) { s.loads.vertical_stress = nan; },
        [](auto& s, auto&) { s.stone.young_modulus = 0.0; },
        [](auto& s, auto&) { s.stone.poisson_ratio = 0.5; },
        [](auto& s, auto&) { s.beam.material.density = -1.0; },
        [](auto& s, auto&) { s.joint.kn = 0.0; },
        [](auto& s, auto&) { s.crack.ks = 0.0; },
        [](auto&, auto& d) { d.contact_points = 1; },
        [](auto&, auto& d) { d.zones_per_interval = 0; },
        [](auto&, auto& d) { d.block_modes = 2; },
        [](auto&, auto& d) { d.block_modes = -1; },
        [](auto&, auto& d) { d.beam_modes = -1; },
    };
    CHECK_NOTHROW(scenes::model_of(small_wall(), coarse(3)));
    for (std::size_t i = 0; i < faults.size(); ++i) {
        scenes::Scene s = small_wall();
        dem::Discretisation d = coarse(3);
        faults[i](s, d);
        INFO("fault " << i);
        CHECK_THROWS_AS(scenes::model_of(s, d), std::invalid_argument);
    }
}
