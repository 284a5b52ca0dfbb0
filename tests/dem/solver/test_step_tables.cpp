#include "dem/block/model.hpp"
#include "dem/solver/state/step_tables.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace {

using dem::Contact;
using dem::ContactRun;
using dem::HorizontalShare;
using dem::Model;
using dem::StepTables;
using Eigen::VectorXd;

/// Walls with every kind of support, beam, face and bond.
std::vector<scenes::Scene> walls()
{
    std::vector<scenes::Scene> all(5, scenes::paper_wall(0.50));
    for (scenes::Scene& s : all) {
        s.wall.courses = 4;
        s.wall.length = 0.7; // ends in a piece of a unit
        s.loads.height = 0.46;
    }
    all[1].wall.base = dem::Base::joint;
    all[1].beam.interface = dem::BeamInterface::joint;
    all[2].wall.base = dem::Base::joint;
    all[2].wall.toe = dem::Toe::free;
    all[2].wall.bond_offset = 0.3;
    all[3].wall.toe = dem::Toe::free;
    all[3].wall.bond_offset = 0.0;
    all[4].wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    all[4].wall.first_course = dem::FirstCourse::shifted;
    all[4].beam.rotation = dem::BeamRotation::fixed;
    return all;
}

/// By number.
std::vector<Contact> contacts_of(const Model& m)
{
    std::vector<Contact> all = m.dry;
    all.insert(all.end(), m.tied.begin(), m.tied.end());
    all.insert(all.end(), m.cracks.begin(), m.cracks.end());
    return all;
}

/// A small motion of a rigid body.
struct RigidMotion {
    double x, z;  ///< of the load line's middle [m]
    double angle; ///< [rad]
    dem::Point about;
    [[nodiscard]] dem::Point at(dem::Point p) const
    {
        return {x - angle * (p.z - about.z), z + angle * (p.x - about.x)};
    }
};

/// Modal coordinates of a block whose contact points move as given.
VectorXd coordinates(const Model& m, int block, const RigidMotion& motion)
{
    const dem::BlockElement& e = m.elements[m.places[block].element];
    const dem::Block& b = m.layout.blocks[block];
    VectorXd u(e.phi.rows());
    for (std::size_t p = 0; p < e.points.size(); ++p) {
        const dem::Point moved = motion.at({b.x0 + e.points[p].x, b.z0 + e.points[p].z});
        const double driven = block == m.layout.beam ? motion.x : 0.0; // by the load line
        u(2 * static_cast<Eigen::Index>(p)) = moved.x - driven;
        u(2 * static_cast<Eigen::Index>(p) + 1) = moved.z;
    }
    const VectorXd q = e.phi.colPivHouseholderQr().solve(u);
    REQUIRE((e.phi * q - u).norm() <= 1e-11 * (u.norm() + std::abs(motion.x)));
    return q;
}

/// Relative displacements of all contacts when the blocks that `moves` names move.
template <class Moves>
std::vector<double> stretches(const Model& m, const StepTables& t, const RigidMotion& motion,
                              Moves moves)
{
    std::vector<double> du(2 * t.area.size(), 0.0);
    for (int b = 0; b < static_cast<int>(t.blocks.size()); ++b) {
        if (!moves(b)) continue;
        const VectorXd q = coordinates(m, b, motion);
        scatter(t.matrices[t.blocks[b].element], t.port_contact.data() + t.blocks[b].first_port,
                q.data(), du.data());
    }
    return du;
}

void add(const std::vector<HorizontalShare>& shares, double motion, std::vector<double>& du)
{
    for (const HorizontalShare& h : shares) du[h.row] += h.factor * motion;
}

double largest(const std::vector<double>& v)
{
    double most = 0.0;
    for (const double x : v) most = std::max(most, std::abs(x));
    return most;
}

/// A block that a support keeps from moving sideways.
bool held_sideways(const Model& m, const dem::WallGeometry& wall, int block)
{
    const dem::Block& b = m.layout.blocks[block];
    const bool toe = wall.toe == dem::Toe::held && b.x1 == wall.length;
    return b.course == 1 && (wall.base == dem::Base::fixed || toe);
}

} // namespace

TEST_CASE("step tables: the contacts of a face are neighbours under one law, each in one run",
          "[dem][step_tables]")
{
    for (const scenes::Scene& s : walls()) {
        const Model m = scenes::model_of(s);
        const StepTables t = dem::step_tables(m);
        const std::vector<Contact> contacts = contacts_of(m);
        REQUIRE(static_cast<int>(contacts.size()) == t.n_contacts);
        std::vector<int> seen(m.layout.faces.size(), 0);
        int next = 0;
        const auto follow = [&](const std::vector<ContactRun>& runs, auto law_of) {
            for (const ContactRun& run : runs) {
                CHECK(run.first == next);
                CHECK(run.count > 0);
                next += run.count;
                const int face = contacts[run.first].face;
                ++seen[face];
                CHECK(run.law == law_of(m.layout.faces[face]));
                for (int k = run.first; k < next; ++k) REQUIRE(contacts[k].face == face);
            }
        };
        follow(t.dry, [&](const dem::Face& f) {
            if (f.kind == dem::FaceKind::base_joint) return m.layout.n_joints;
            if (f.kind == dem::FaceKind::beam_joint) return m.layout.n_joints + 1;
            return f.id - 1;
        });
        CHECK(next == t.first_tied);
        follow(t.tied, [](const dem::Face&) { return 0; });
        CHECK(next == t.first_crack);
        follow(t.cracks, [](const dem::Face& f) { return f.id - 1; });
        CHECK(next == t.n_contacts);
        CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<int>(seen.size()));
        for (int k = 0; k < t.n_contacts; ++k) REQUIRE(t.area[k] == contacts[k].area);
    }
}

TEST_CASE("step tables: each contact is a port of exactly its two blocks, of one at the ground",
          "[dem][step_tables]")
{
    for (const scenes::Scene& s : walls()) {
        const Model m = scenes::model_of(s);
        const StepTables t = dem::step_tables(m);
        std::map<int, std::vector<int>> blocks; // by contact
        int ports = 0, modes = 0;
        for (int b = 0; b < static_cast<int>(t.blocks.size()); ++b) {
            const auto& row = t.blocks[b];
            CHECK(row.element == m.places[b].element);
            CHECK(row.first_port == ports);
            CHECK(row.first_mode == modes);
            CHECK(row.modes == t.matrices[row.element].modes);
            for (int p = 0; p < t.matrices[row.element].ports; ++p)
                blocks[t.port_contact[ports + p]].push_back(b);
            ports += t.matrices[row.element].ports;
            modes += row.modes;
        }
        CHECK(ports == static_cast<int>(t.port_contact.size()));
        CHECK(modes == static_cast<int>(t.lambda.size()));
        const std::vector<Contact> contacts = contacts_of(m);
        for (int k = 0; k < t.n_contacts; ++k) {
            const dem::Face& f = m.layout.faces[contacts[k].face];
            const std::vector<int> both =
                f.a == dem::kGround ? std::vector{f.b} : std::vector{f.a, f.b};
            REQUIRE(blocks[k] == both);
        }
    }
}

TEST_CASE("step tables: block b past block a along the normal opens, along (nz, -nx) slips",
          "[dem][step_tables]")
{
    const Model m = scenes::model_of(walls()[2]);
    const StepTables t = dem::step_tables(m);
    const RigidMotion motion{2e-3, 1e-3, 3e-3, {0.35, 0.46}};
    const std::vector<Contact> contacts = contacts_of(m);
    for (int block = 0; block < m.layout.beam; ++block) {
        const auto du = stretches(m, t, motion, [&](int b) { return b == block; });
        const dem::Block& at = m.layout.blocks[block];
        for (int k = 0; k < t.n_contacts; ++k) {
            const Contact& c = contacts[k];
            const dem::Face& f = m.layout.faces[c.face];
            const double side = (f.b == block ? 1.0 : 0.0) - (f.a == block ? 1.0 : 0.0);
            const int point = (f.b == block ? c.b : c.a) - m.places[block].first_point;
            dem::Point u{0.0, 0.0};
            if (side != 0.0) {
                const dem::Point p = m.elements[m.places[block].element].points[point];
                u = motion.at({at.x0 + p.x, at.z0 + p.z});
            }
            REQUIRE(std::abs(du[2 * k] - side * (c.nx * u.x + c.nz * u.z)) < 1e-15);
            REQUIRE(std::abs(du[2 * k + 1] - side * (c.nz * u.x - c.nx * u.z)) < 1e-15);
        }
    }
}

TEST_CASE(
    "step tables: a rigid motion of the whole wall stretches its joints with the ground alone",
    "[dem][step_tables]")
{
    scenes::Scene s = walls()[2]; // free at its base
    dem::Discretisation d;
    d.block_modes = GENERATE(3, 12, 0);
    const Model m = scenes::model_of(s, d);
    const StepTables t = dem::step_tables(m);
    const dem::Point line{0.5 * s.wall.length, s.loads.height};
    const auto [x, z, angle] = GENERATE(table<double, double, double>(
        {{1e-3, 0.0, 0.0}, {0.0, -2e-3, 0.0}, {0.0, 0.0, 1e-3}, {-3e-3, 1e-3, -2e-3}}));
    const RigidMotion motion{x, z, angle, line};
    std::vector<double> du = stretches(m, t, motion, [](int) { return true; });
    add(t.beam, x, du);
    const std::vector<Contact> contacts = contacts_of(m);
    int on_ground = 0;
    for (int k = 0; k < t.n_contacts; ++k) {
        const dem::Face& f = m.layout.faces[contacts[k].face];
        dem::Point expected{0.0, 0.0};
        if (f.a == dem::kGround) {
            const auto& place = m.places[f.b];
            const dem::Point p =
                m.elements[place.element].points[contacts[k].b - place.first_point];
            expected = motion.at({m.layout.blocks[f.b].x0 + p.x, 0.0});
            ++on_ground;
        }
        REQUIRE(du[2 * k] ==
                Approx(expected.z).epsilon(1e-11).margin(1e-15)); // opening of a bed joint
        REQUIRE(du[2 * k + 1] == Approx(expected.x).epsilon(1e-11).margin(1e-15));
    }
    CHECK(on_ground > 10);
}

TEST_CASE("step tables: wall, beam and ground moved sideways together stretch nothing",
          "[dem][step_tables]")
{
    for (const scenes::Scene& s : walls()) {
        const Model m = scenes::model_of(s);
        const StepTables t = dem::step_tables(m);
        const double x = 1e-3;
        std::vector<double> du = stretches(m, t, {x, 0.0, 0.0, {}},
                                           [&](int b) { return !held_sideways(m, s.wall, b); });
        add(t.beam, x, du);
        CHECK(largest(du) == Approx(x).epsilon(1e-12)); // the ground has not moved yet
        add(t.ground, x, du);
        CHECK(largest(du) < 1e-14);
    }
}

TEST_CASE("step tables: the shares of the beam and of a fixed base are the wall's plan area",
          "[dem][step_tables]")
{
    for (const scenes::Scene& s : walls()) {
        const Model m = scenes::model_of(s);
        const StepTables t = dem::step_tables(m);
        const std::vector<Contact> contacts = contacts_of(m);
        const auto sum = [&](const std::vector<HorizontalShare>& shares, int direction) {
            double area = 0.0;
            for (const HorizontalShare& h : shares) {
                REQUIRE(h.area == t.area[h.row / 2]);
                if (h.row % 2 == direction) area += h.factor * h.area;
            }
            return area;
        };
        const double plan = s.wall.length * s.wall.thickness;
        CHECK(sum(t.beam, 1) == Approx(plan).epsilon(1e-13)); // the beam is above its joint
        CHECK(sum(t.beam, 0) == 0.0);
        if (s.wall.base == dem::Base::joint && s.wall.toe == dem::Toe::held) continue;
        CHECK(sum(t.ground, 1) == Approx(-plan).epsilon(1e-13));
        CHECK(sum(t.ground, 0) == 0.0);
    }
}

TEST_CASE("step tables: a toe held sideways takes the push of its neighbour, not its own joint",
          "[dem][step_tables]")
{
    scenes::Scene s = walls()[0];
    s.wall.base = dem::Base::joint;
    const Model m = scenes::model_of(s);
    const StepTables t = dem::step_tables(m);
    const std::vector<Contact> contacts = contacts_of(m);
    double pushed = 0.0;
    for (const HorizontalShare& h : t.ground) {
        const dem::Face& f = m.layout.faces[contacts[h.row / 2].face];
        const bool base = f.kind == dem::FaceKind::base_joint;
        CHECK_FALSE((base && m.layout.blocks[f.b].x1 == s.wall.length));
        if (h.row % 2 == 0) pushed += h.factor * h.area;
    }
    CHECK(pushed == Approx(s.wall.course_height * s.wall.thickness).epsilon(1e-13));
}
