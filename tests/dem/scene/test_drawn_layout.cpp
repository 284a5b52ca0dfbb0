/// Scenes of any outlines against walls in courses, limit analysis and closed forms.

#include "dem/block/model.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <numbers>

namespace {

using dem::Point;

std::vector<Point> rectangle(double x0, double x1, double z0, double z1)
{
    return {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}};
}

/// The units of a wall in courses, as somebody would draw them.
dem::DrawnWall drawn(const dem::WallGeometry& wall)
{
    std::map<int, std::vector<double>> units; // x0, x1, z0, z1
    for (const dem::Block& b : dem::lay_out(wall, 0.0).blocks) {
        const auto [at, fresh] = units.try_emplace(b.unit, std::vector{b.x0, b.x1, b.z0, b.z1});
        at->second[1] = b.x1;
    }
    dem::DrawnWall d;
    for (const auto& [unit, s] : units) d.units.push_back({rectangle(s[0], s[1], s[2], s[3])});
    d.thickness = wall.thickness;
    d.unit_length = wall.unit_length;
    d.cracks = wall.cracks;
    return d;
}

dem::Model model_of(dem::Layout layout, const scenes::Scene& s,
                    const dem::Discretisation& d = {})
{
    return dem::discretise(std::move(layout), s.stone, s.beam, s.loads, {s.joint, s.crack}, d);
}

double peak(const scenes::Scene& s, const dem::Model& m)
{
    dem::SolverOptions o;
    o.accuracy = 0.001;
    dem::PushPlan plan;
    plan.targets = {0.006};
    return scenes::peak_force(dem::push(m, scenes::uniform(s, m), plan, o));
}

/// A wall of rigid blocks without beam under its weight, pushed by body forces.
dem::PushResult pushed(const dem::DrawnWall& wall, double tan_phi, double to, double kn = 1e11)
{
    scenes::Scene s = scenes::monolith(1.0, 1.0, 0.0, kn);
    s.beam.present = false;
    s.loads.pattern = dem::LoadPattern::body;
    s.stone.density = 2000.0;
    s.joint.ks = 0.4 * kn;
    s.joint.tan_phi = tan_phi;
    dem::Discretisation d;
    d.contact_points = 2;
    d.zones_per_interval = 1;
    d.block_modes = 3;
    const dem::Model m = model_of(dem::drawn_layout(wall, 0.0), s, d);
    dem::PushPlan plan;
    plan.targets = {to};
    plan.record_every = std::abs(to) / 100;
    dem::SolverOptions o;
    o.accuracy = 0.001;
    dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan, o);
    CHECK(r.residual < 0.01);
    CHECK_FALSE(dem::failed(r.outcome));
    return r;
}

/// The largest load factor.
double peak_factor(const dem::DrawnWall& wall, double tan_phi, double to)
{
    const dem::PushResult r = pushed(wall, tan_phi, to);
    return scenes::peak_force(r) / r.weight;
}

using Course = std::vector<double>;

/// Courses of 0.175 m; lengths in units of 0.4 m, a negative one is an opening.
dem::DrawnWall of_courses(const std::vector<Course>& courses)
{
    dem::DrawnWall w;
    w.base = dem::Base::joint;
    for (std::size_t c = 0; c < courses.size(); ++c) {
        double x = 0.0;
        for (const double length : courses[c]) {
            const double next = x + 0.4 * std::abs(length);
            const double z = 0.175 * static_cast<double>(c);
            if (length > 0.0)
                w.units.push_back({rectangle(x, next, z, 0.175 * static_cast<double>(c + 1))});
            x = next;
        }
    }
    return w;
}

/// A semicircular arch of mean radius 1 m, as voussoirs between radial joints at the given
/// angles from the left springing [rad]. They are straight between their corners: so finely cut
/// that the thrust line sees a circle.
dem::DrawnWall arch(double thickness, int voussoirs)
{
    dem::DrawnWall w;
    w.base = dem::Base::joint;
    const double inner = 1.0 - 0.5 * thickness, outer = 1.0 + 0.5 * thickness;
    const auto at = [](double r, double a) {
        return Point{1.5 - r * std::cos(a), std::max(0.0, r * std::sin(a))};
    };
    constexpr int kArcs = 3; // straight pieces of each voussoir's back
    for (int i = 0; i < voussoirs; ++i) {
        std::vector<Point> o;
        for (int k = 0; k <= kArcs; ++k)
            o.push_back(at(outer, std::numbers::pi * (i + 1.0 - 1.0 * k / kArcs) / voussoirs));
        for (int k = 0; k <= kArcs; ++k)
            o.push_back(at(inner, std::numbers::pi * (i + 1.0 * k / kArcs) / voussoirs));
        if (i + 1 == voussoirs) o.front().z = o.back().z = 0.0;
        w.units.push_back({o});
    }
    return w;
}

/// Two courses of two stones that meet on sloping beds, and a corner that lies off the side
/// under it.
dem::DrawnWall sloping(Point off)
{
    const auto bed = [](double x) { return 0.10 + 0.0825 * x; };
    const Point low{0.18, bed(0.18)}, high{0.25 + off.x, bed(0.25) + off.z};
    dem::DrawnWall w;
    w.base = dem::Base::joint;
    w.thickness = 0.5;
    w.units = {{{{0, 0}, {0.155, 0}, low, {0, bed(0)}}},
               {{{0.155, 0}, {0.41, 0}, {0.41, bed(0.41)}, low}},
               {{{0, bed(0)}, high, {0.237, 0.24}, {0, 0.24}}},
               {{high, {0.41, bed(0.41)}, {0.41, 0.24}, {0.237, 0.24}}}};
    return w;
}

scenes::Scene stiff_stones()
{
    scenes::Scene s = scenes::monolith(0.41, 0.24, 0.1e6, 1e10);
    s.joint.ks = 0.4 * s.joint.kn;
    s.joint.tan_phi = 0.7;
    s.beam.interface = dem::BeamInterface::joint;
    return s;
}

} // namespace

TEST_CASE("drawn layout: the paper's wall drawn unit by unit has the joints and cracks of the "
          "wall in "
          "courses",
          "[dem][drawn_layout]")
{
    const scenes::Scene s = scenes::paper_wall(0.50);
    const dem::Layout courses = dem::lay_out(s.wall, s.beam.height),
                      outlines = dem::drawn_layout(drawn(s.wall), s.beam.height);
    CHECK(outlines.n_joints == courses.n_joints);
    CHECK(outlines.n_cracks == courses.n_cracks);
    CHECK(outlines.faces.size() == courses.faces.size());
    REQUIRE(outlines.blocks.size() == courses.blocks.size());
    for (std::size_t b = 0; b < courses.blocks.size(); ++b) {
        CHECK(outlines.blocks[b].x0 == Approx(courses.blocks[b].x0).margin(1e-12));
        CHECK(outlines.blocks[b].course == courses.blocks[b].course);
        CHECK(outlines.blocks[b].unit == courses.blocks[b].unit);
    }
    CHECK(outlines.length == courses.length);
    CHECK(outlines.height == Approx(courses.height));
    CHECK(outlines.course_height == Approx(courses.course_height));
    CHECK(outlines.courses == courses.courses);
}

TEST_CASE("drawn layout: drawn, and of triangles, the paper's wall carries the same",
          "[dem][drawn_layout][slow]")
{
    const scenes::Scene s = scenes::paper_wall(0.50);
    dem::DrawnWall wall = drawn(s.wall);
    const double courses = peak(s, scenes::model_of(s));
    // The toe is held in the paper and free here: let it be held.
    dem::Layout outlines = dem::drawn_layout(wall, s.beam.height);
    for (int b = 0; b < outlines.beam; ++b)
        if (outlines.blocks[b].motion != dem::Motion::free && outlines.blocks[b].x1 == 1.0)
            outlines.blocks[b].motion = dem::Motion::clamped_bottom_held_right;
    CHECK(peak(s, model_of(outlines, s)) == Approx(courses).epsilon(1e-3));

    dem::Layout triangles = outlines;
    for (dem::Block& b : triangles.blocks)
        if (b.unit > 0) b.outline = rectangle(b.x0, b.x1, b.z0, b.z1);
    CHECK(peak(s, model_of(triangles, s)) == Approx(courses).epsilon(5e-3));
}

TEST_CASE("drawn layout: sides that touch become joints, whatever corners they have",
          "[dem][drawn_layout]")
{
    dem::DrawnWall w;
    w.base = dem::Base::joint;
    // A block of 1 m with a needless corner under two; the right one leans on the left with a
    // slanted joint.
    w.units = {{{{0, 0}, {1, 0}, {1, 0.5}, {0.7, 0.5}, {0, 0.5}}},
               {{{0, 0.5}, {0.5, 0.5}, {0.3, 1.0}, {0, 1.0}}},
               {{{0.5, 0.5}, {1, 0.5}, {1, 1}, {0.3, 1}}}};
    const dem::Layout l = dem::drawn_layout(w, 0.1);
    CHECK(l.n_joints == 3);
    REQUIRE(l.faces.size() == 1 + 3 + 2); // base, joints, beam
    CHECK(l.length == Approx(1.0));
    const dem::Face* slanted = nullptr;
    for (const dem::Face& f : l.faces) {
        if (f.kind == dem::FaceKind::head_joint) slanted = &f;
        CHECK(std::hypot(f.normal.x, f.normal.z) == Approx(1.0));
    }
    REQUIRE(slanted != nullptr);
    CHECK(slanted->a == 1);
    CHECK(slanted->b == 2);
    CHECK(slanted->normal.x == Approx(0.5 / std::hypot(0.5, 0.2)));
    CHECK(slanted->normal.z == Approx(0.2 / std::hypot(0.5, 0.2)));
    CHECK(slanted->from.z < slanted->to.z);
}

TEST_CASE("drawn layout: stones of one shape between like neighbours share an element",
          "[dem][drawn_layout]")
{
    dem::DrawnWall w;
    w.base = dem::Base::joint;
    for (int k = 0; k < 8; ++k) // leaning stones, 0.3 m long, in a row
        w.units.push_back(
            {{{0.3 * k, 0}, {0.3 * k + 0.3, 0}, {0.3 * k + 0.4, 0.2}, {0.3 * k + 0.1, 0.2}}});
    scenes::Scene s = scenes::monolith(1.0, 1.0, 0.0, 1e11);
    s.beam.present = false;
    s.loads.pattern = dem::LoadPattern::body;
    const dem::Model m = model_of(dem::drawn_layout(w, 0.0), s);
    REQUIRE(m.places.size() == 8);
    CHECK(m.elements.size() == 3); // the first, the last, and those between
    for (std::size_t b = 2; b < 7; ++b) CHECK(m.places[b].element == m.places[1].element);
}

// Ferris and Tin-Loi (2001), Int. J. Solids Struct. 38:3835: walls with openings, friction
// 0.65, all blocks pushed in proportion to their weight. Associated: linear programming over
// the corners of all faces. Friction without dilatancy lies below.
TEST_CASE(
    "drawn layout: wall 3 of Ferris and Tin-Loi, with a door, carries what limit analysis says",
    "[dem][drawn_layout]")
{
    const Course fe = {1, 1, 1, 1}, fu = {.5, 1, 1, 1, .5}, we = {1, .5, -1, .5, 1},
                 wu = {.5, 1, -1, 1, .5};
    const double f =
        peak_factor(of_courses({fe, fu, fe, wu, we, wu, we, wu, fe, fu, fe}), 0.65, 2.5e-3);
    constexpr double kAssociated = 0.40369;
    CHECK(f < 1.005 * kAssociated);
    CHECK(f == Approx(0.3558).epsilon(0.02)); // non-associated
}

TEST_CASE("drawn layout: a semicircular arch stands from a thickness of 0.1075 radii on",
          "[dem][drawn_layout][slow]")
{
    // Milankovitch (1907); Heyman's approximation is 0.1059. The load factor that it can carry
    // falls to zero there, linearly.
    const double thick = peak_factor(arch(0.114, 36), 10.0, 1e-4),
                 thin = peak_factor(arch(0.111, 36), 10.0, 1e-4);
    INFO("load factors " << thick << ", " << thin);
    CHECK(0.111 - thin * 0.003 / (thick - thin) == Approx(0.10748).epsilon(0.01));
}

TEST_CASE("drawn layout: an arch of least thickness hinges at its crown, its haunch and its "
          "springings",
          "[dem][drawn_layout][slow]")
{
    // Milankovitch's thrust line touches the back at the crown and the springings, and the
    // belly 54.48 degrees from the crown. Pushed, the arch needs four of these five hinges:
    // that of the haunch behind stays shut.
    constexpr double kThickness = 0.109;
    const dem::PushResult r = pushed(arch(kThickness, 90), 10.0, 3e-5);
    struct Hinge {
        double angle; ///< from the crown [deg], positive on the side of the push
        bool at_back; ///< closed there, open at the belly
    };
    std::vector<Hinge> hinges;
    for (const dem::FaceState& f : r.at_end.faces) {
        const auto radius = [](dem::Point p) { return std::hypot(p.x - 1.5, p.z); };
        const auto [in, out] = radius(f.contacts.front().at) < radius(f.contacts.back().at)
                                   ? std::pair{f.contacts.front(), f.contacts.back()}
                                   : std::pair{f.contacts.back(), f.contacts.front()};
        // Elsewhere joints of 100 GPa/m open by 1e-6 m at most.
        if (std::max(in.opening, out.opening) < 3e-6) continue;
        CHECK(std::min(in.opening, out.opening) < 0.0);
        hinges.push_back({std::atan2(in.at.x - 1.5, in.at.z) * 180.0 / std::numbers::pi,
                          in.opening > out.opening});
    }
    std::ranges::sort(hinges, {}, &Hinge::angle);
    REQUIRE(hinges.size() == 4);
    const Hinge expected[] = {{-90.0, true}, {0.0, true}, {54.48, false}, {90.0, true}};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(hinges[i].angle ==
              Approx(expected[i].angle).margin(1.0)); // joints are 2 degrees apart
        CHECK(hinges[i].at_back == expected[i].at_back);
    }
}

TEST_CASE("drawn layout: bad scenes are refused with the reason", "[dem][drawn_layout]")
{
    dem::DrawnWall w;
    CHECK_THROWS_WITH(dem::drawn_layout(w, 0.0), Catch::Contains("at least one outline"));
    w.units = {{{{0, 0}, {0, 1}, {1, 1}}}};
    CHECK_THROWS_WITH(dem::drawn_layout(w, 0.0), Catch::Contains("counter-clockwise"));
    w.units = {{{{0, 0}, {1, 1}, {0, 1}}}};
    CHECK_THROWS_WITH(dem::drawn_layout(w, 0.0),
                      Catch::Contains("nothing stands on the floor"));
    w.units = {{{{0, 0}, {1, 0}, {0.5, 1}}}};
    CHECK_THROWS_WITH(dem::drawn_layout(w, 0.1), Catch::Contains("a beam needs a level side"));
    w.units = {{rectangle(0, 1, 0, 1)}, {rectangle(5, 6, 0.5, 1)}};
    const scenes::Scene s = scenes::paper_wall(0.5);
    scenes::Scene alone = s;
    alone.beam.present = false;
    alone.loads.pattern = dem::LoadPattern::body;
    alone.loads.vertical_stress = 0.0;
    w.base = dem::Base::joint;
    CHECK_THROWS_WITH(model_of(dem::drawn_layout(w, 0.0), alone),
                      Catch::Contains("touches no other"));
}

TEST_CASE("drawn layout: a rectangle stays one with the corners of neighbours on its sides",
          "[dem][drawn_layout]")
{
    CHECK(dem::block_of(
              {{0, 0}, {0.1, 0}, {0.2, 0}, {0.2, 0.1}, {0.15, 0.1}, {0, 0.1}, {0, 0.04}})
              .outline.empty());
    // Corners cut off by 1 mm, which is less area than the tolerance
    const dem::Block cut =
        dem::block_of({{0, 0}, {0.2, 0}, {0.2, 0.099}, {0.199, 0.1}, {0, 0.1}});
    CHECK(cut.outline.size() == 5);
    CHECK_FALSE(dem::block_of({{0, 0}, {0.2, 0}, {0.1, 0.1}, {0, 0.1}}).outline.empty());
}

TEST_CASE("drawn layout: a wall that cannot carry its weight comes down before it is pushed",
          "[dem][drawn_layout]")
{
    // The thinnest semicircle that stands is 0.107 of its mean radius thick (Milankovitch).
    const dem::PushResult thin = pushed(arch(0.10, 24), 0.7, 1e-3),
                          thick = pushed(arch(0.14, 24), 0.7, 1e-3);
    CHECK(thin.outcome == dem::Outcome::lost_equilibrium);
    CHECK_FALSE(thin.settled);
    CHECK(thin.curve.size() == 1); // nothing of it is a capacity
    CHECK(thick.settled);
    CHECK(thick.outcome == dem::Outcome::reached_target);
}

TEST_CASE(
    "drawn layout: a corner within a micrometre of the side under it leaves all blocks as "
    "they are",
    "[dem][drawn_layout]")
{
    const scenes::Scene s = stiff_stones();
    const auto elements = [&](Point off) {
        return model_of(dem::drawn_layout(sloping(off), s.beam.height), s).elements;
    };
    const std::vector<dem::BlockElement> exact = elements({});
    for (const Point off :
         {Point{0, 9e-7}, Point{0, -4e-7}, Point{3e-7, 3e-7}, Point{1e-6, 0}}) {
        INFO("off by " << off.x << " " << off.z << " m");
        const std::vector<dem::BlockElement> moved = elements(off);
        REQUIRE(moved.size() == exact.size());
        for (std::size_t e = 0; e < exact.size(); ++e) {
            REQUIRE(moved[e].lambda.size() == exact[e].lambda.size());
            CHECK((moved[e].lambda - exact[e].lambda).cwiseAbs().maxCoeff() <
                  1e-4 * exact[e].lambda.maxCoeff());
        }
    }
}

TEST_CASE(
    "drawn layout: a corner within a micrometre of the side under it does not change what "
    "the wall carries",
    "[dem][drawn_layout]")
{
    const scenes::Scene s = stiff_stones();
    dem::Discretisation d;
    d.contact_points = 4;
    d.zones_per_interval = 1;
    d.block_modes = 12;
    const auto carried = [&](Point off) {
        return peak(s, model_of(dem::drawn_layout(sloping(off), s.beam.height), s, d));
    };
    const double exact = carried({});
    for (const Point off : {Point{0, 6e-7}, Point{0, -3e-7}})
        CHECK(carried(off) == Approx(exact).epsilon(1e-4));
}

TEST_CASE("drawn layout: sides that bend a little at each of many corners are not one joint",
          "[dem][drawn_layout]")
{
    // Each corner lies within a micrometre of the line between those beside it, the middle 0.3
    // mm off the whole.
    std::vector<Point> below{{0, 0}, {0.4, 0}}, arc;
    constexpr int kSides = 40;
    const auto at = [](int i) {
        const double x = 0.4 * i / kSides;
        return Point{x, 0.1 + 0.0075 * x * (0.4 - x)};
    };
    for (int i = kSides; i >= 0; --i) below.push_back(at(i));
    for (int i = 0; i <= kSides; ++i) arc.push_back(at(i));
    std::vector<Point> above = arc;
    above.push_back({0.4, 0.2});
    above.push_back({0, 0.2});
    dem::DrawnWall w;
    w.units = {{below}, {above}};
    scenes::Scene s = stiff_stones();
    s.loads.height = 0.2 + s.beam.height;
    const dem::Layout layout = dem::drawn_layout(w, s.beam.height);
    CHECK(layout.n_joints > 3);
    CHECK(layout.n_joints < kSides); // most of them continue each other
    for (const dem::Face& f : layout.faces)
        for (const Point p : arc) {
            if (f.kind != dem::FaceKind::bed_joint || p.x < f.from.x || p.x > f.to.x) continue;
            const double off = (p.x - f.from.x) * f.normal.x + (p.z - f.from.z) * f.normal.z;
            CHECK(std::abs(off) <= dem::kTouching);
        }
    CHECK_NOTHROW(model_of(layout, s));
}
