/// Blocks whose outline is not a rectangle: their area, triangles, stiffness and modes.

#include "dem/block/condensation.hpp"
#include "dem/block/triangle.hpp"
#include "dem/scene/geometry/polygon.hpp"
#include "tests/dem/block_specs.hpp"

#include <Eigen/SparseCholesky>

#include <catch2/catch.hpp>

#include <cmath>
#include <set>

namespace {

using dem::BlockSpec;
using dem::Mesh;
using dem::Point;
using Eigen::VectorXd;

std::vector<Point> l_shape()
{
    return {{0, 0}, {0.2, 0}, {0.2, 0.08}, {0.09, 0.08}, {0.09, 0.15}, {0, 0.15}};
}
std::vector<Point> skew()
{
    return {{0, 0.02}, {0.17, 0}, {0.21, 0.11}, {0.12, 0.16}, {0.03, 0.12}};
}

/// Contacts on all sides but the last.
BlockSpec spec_of(const std::vector<Point>& outline, int points = 4)
{
    BlockSpec s;
    s.outline = outline;
    for (const Point p : outline) {
        s.width = std::max(s.width, p.x);
        s.height = std::max(s.height, p.z);
    }
    s.thickness = 0.2;
    s.material = {15.5e9, 0.2, 2300.0};
    s.face_rule = dem::FaceRule::lobatto;
    s.zones_per_interval = 2;
    s.zone_size = 0.0125;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto points_on = dem::face_points(s.face_rule, points, s.zones_per_interval);
        s.edges.push_back({outline[i], outline[(i + 1) % outline.size()], points_on, 8e9, 3e9});
    }
    return s;
}

VectorXd linear_field(const std::vector<Point>& points, const Eigen::Vector3d& e)
{
    VectorXd u(2 * static_cast<Eigen::Index>(points.size()));
    for (std::size_t p = 0; p < points.size(); ++p) {
        u(2 * static_cast<Eigen::Index>(p)) = e(0) * points[p].x + e(2) * points[p].z;
        u(2 * static_cast<Eigen::Index>(p) + 1) = e(1) * points[p].z;
    }
    return u;
}

/// Forces of a uniform stress on the points: stress times normal times area. Sides run
/// counter-clockwise.
VectorXd tractions(const BlockSpec& s, const dem::Condensed& c, const Eigen::Vector3d& stress)
{
    VectorXd f = VectorXd::Zero(2 * static_cast<Eigen::Index>(c.points.size()));
    for (const dem::BlockEdge& e : s.edges) {
        const double dx = e.to.x - e.from.x, dz = e.to.z - e.from.z;
        for (std::size_t i = 0; i < e.points.position.size(); ++i) {
            const Point at{e.from.x + e.points.position[i] * dx,
                           e.from.z + e.points.position[i] * dz};
            const auto p = std::find_if(c.points.begin(), c.points.end(),
                                        [at](Point q) { return dem::same_place(at, q); }) -
                           c.points.begin();
            const double share = e.points.weight[i] * s.thickness;
            f(2 * p) += share * (stress(0) * dz - stress(2) * dx);
            f(2 * p + 1) += share * (stress(2) * dz - stress(1) * dx);
        }
    }
    return f;
}

double largest(const VectorXd& v) { return v.cwiseAbs().maxCoeff(); }

} // namespace

TEST_CASE("polygon: area, centre and inside of an L", "[dem][polygon]")
{
    const std::vector<Point> l = l_shape();
    CHECK(dem::polygon_area(l) == Approx(0.2 * 0.08 + 0.09 * 0.07));
    const Point c = dem::polygon_centre(l);
    CHECK(c.x == Approx((0.016 * 0.1 + 0.0063 * 0.045) / 0.0223));
    CHECK(c.z == Approx((0.016 * 0.04 + 0.0063 * 0.115) / 0.0223));
    CHECK(dem::is_inside(l, {0.05, 0.1}));
    CHECK_FALSE(dem::is_inside(l, {0.15, 0.1}));
    CHECK(dem::distance_to_segment({0.1, 0.1}, {0, 0}, {0.05, 0}) ==
          Approx(std::hypot(0.05, 0.1)));
}

TEST_CASE("polygon block: triangles fill the outline and keep its points", "[dem][polygon]")
{
    for (const auto& outline : {l_shape(), skew()}) {
        const dem::Condensed c = dem::condense(spec_of(outline));
        double area = 0.0;
        for (const auto& t : c.mesh.triangles) {
            const double one = dem::triangle_area(
                {c.mesh.nodes[t[0]], c.mesh.nodes[t[1]], c.mesh.nodes[t[2]]});
            CHECK(one > 0.0);
            area += one;
        }
        CHECK(area == Approx(dem::polygon_area(outline)).epsilon(1e-12));
        CHECK(dem::nodal_areas(c.mesh).sum() == Approx(area).epsilon(1e-12));
        CHECK(c.outline.size() == c.points.size()); // every corner has contacts
        std::set<int> used;
        for (const auto& t : c.mesh.triangles) used.insert(t.begin(), t.end());
        CHECK(used.size() == c.mesh.nodes.size());
    }
}

TEST_CASE(
    "polygon block: a linear field at the contact points gives stress times contact areas",
    "[dem][polygon]")
{
    for (const auto& outline : {l_shape(), skew()})
        for (const int points : {2, 4, 5})
            for (const Eigen::Vector3d& strain :
                 {Eigen::Vector3d(1e-4, 0, 0), Eigen::Vector3d(2e-4, -3e-4, 1e-4)}) {
                const BlockSpec s = spec_of(outline, points);
                const dem::Condensed c = dem::condense(s);
                const VectorXd f = tractions(s, c, dem::plane_stress(s.material) * strain);
                CHECK(largest(c.stiffness * linear_field(c.points, strain) - f) <
                      1e-10 * largest(f));
            }
}

TEST_CASE("polygon block: a rectangle of triangles is as stiff as one of rectangular zones",
          "[dem][polygon]")
{
    const std::vector<Point> corners = {{0, 0}, {0.1, 0}, {0.1, 0.09}, {0, 0.09}};
    BlockSpec s = spec_of(corners, 5);
    s.zones_per_interval = 4; // of 2, rectangular zones are 0.6 % too stiff in the second field
    for (dem::BlockEdge& e : s.edges) e.points = dem::face_points(s.face_rule, 5, 4);
    const Eigen::MatrixXd triangles = dem::condense(s).stiffness;
    s.outline.clear();
    const Eigen::MatrixXd zones = dem::condense(s).stiffness;
    REQUIRE(triangles.rows() == zones.rows());
    // Each field that the softest modes are made of: bending and shear in both directions.
    const dem::Condensed c = dem::condense(s);
    for (const int field : {0, 1, 2, 3}) {
        VectorXd u(2 * static_cast<Eigen::Index>(c.points.size()));
        for (std::size_t p = 0; p < c.points.size(); ++p) {
            const double x = c.points[p].x - 0.05, z = c.points[p].z - 0.045;
            const double bend_x[] = {x * z, x * x, z, x},
                         bend_z[] = {-0.5 * x * x, x * z, 0.0, -z};
            u(2 * static_cast<Eigen::Index>(p)) = bend_x[field];
            u(2 * static_cast<Eigen::Index>(p) + 1) = bend_z[field];
        }
        INFO("field " << field);
        CHECK(u.dot(triangles * u) == Approx(u.dot(zones * u)).epsilon(0.005));
    }
}

TEST_CASE("polygon block: a cantilever of triangles bends as Timoshenko says", "[dem][polygon]")
{
    // Problem 6: 1 m x 0.1 m, 0.1 m thick, 1 kN; Timoshenko 2.5992 mm. Zones of 20 x 2: 0.31 %.
    std::vector<Point> ring;
    const auto add = [&ring](Point a, Point b, int n) {
        for (int i = 0; i < n; ++i)
            ring.push_back({a.x + (b.x - a.x) * i / n, a.z + (b.z - a.z) * i / n});
    };
    add({0, 0}, {1, 0}, 20);
    add({1, 0}, {1, 0.1}, 2);
    add({1, 0.1}, {0, 0.1}, 20);
    add({0, 0.1}, {0, 0}, 2);
    const Mesh m = dem::triangle_mesh(ring, 0.05);
    Eigen::SparseMatrix<double> k = dem::mesh_stiffness(m, 0.1, {15.5e9, 0.2, 0.0});
    VectorXd f = VectorXd::Zero(k.rows());
    for (std::size_t i = 0; i < m.ring.size(); ++i) {
        const int n = m.ring[i];
        if (m.nodes[n].x == 0.0)
            for (int d = 0; d < 2; ++d) k.coeffRef(2 * n + d, 2 * n + d) = 1e25;
        // A middle carries two thirds of its side, a corner a sixth of each.
        if (m.nodes[n].x != 1.0) continue;
        const bool middle = i % 2 == 1, end = m.nodes[n].z == 0.0 || m.nodes[n].z == 0.1;
        f(2 * n + 1) = 500.0 * (middle ? 2.0 / 3.0 : end ? 1.0 / 6.0 : 1.0 / 3.0);
    }
    REQUIRE(f.sum() == Approx(1000.0));
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(k);
    CHECK(solver.solve(f).dot(f) / 1e3 == Approx(2.5992e-3).epsilon(0.0031));
}

TEST_CASE("polygon block: an outline that crosses itself is refused", "[dem][polygon]")
{
    const std::vector<Point> bow = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    CHECK_THROWS_WITH(dem::triangle_mesh(bow, 0.1), "an outline crosses itself");
    const std::vector<Point> twice = {{0, 0}, {1, 0}, {1, 1}, {1, 0}};
    CHECK_THROWS_WITH(dem::triangle_mesh(twice, 0.1), "an outline visits a point twice");
}

TEST_CASE("polygon block: a joint that ends a micrometre off its side finds the same block",
          "[dem][polygon]")
{
    // Two stones meet on the first side; the corner that they share lies off it.
    const auto split = [](double off) {
        BlockSpec s = spec_of(skew(), 5);
        const Point a = s.edges[0].from, b = s.edges[0].to;
        const double length = std::hypot(b.x - a.x, b.z - a.z);
        const Point meet{0.6 * a.x + 0.4 * b.x - off * (b.z - a.z) / length,
                         0.6 * a.z + 0.4 * b.z + off * (b.x - a.x) / length};
        s.edges[0].to = meet;
        s.edges.insert(s.edges.begin() + 1, s.edges[0]);
        s.edges[1].from = meet;
        s.edges[1].to = b;
        return s;
    };
    const dem::BlockElement exact = dem::block_element(split(0.0));
    for (const double off : {-2e-6, -1e-6, -3e-7, 1.2e-7, 5e-7, 2e-6}) {
        INFO("off its side by " << off << " m");
        const dem::BlockElement e = dem::block_element(split(off));
        REQUIRE(e.points.size() == exact.points.size());
        REQUIRE(e.lambda.size() == exact.lambda.size());
        CHECK((e.lambda - exact.lambda).cwiseAbs().maxCoeff() < 1e-4 * exact.lambda.maxCoeff());
        CHECK(e.lambda(3) == Approx(exact.lambda(3)).epsilon(1e-4));
    }
}

TEST_CASE("polygon block: two joints that end a micrometre apart at a corner share its point",
          "[dem][polygon]")
{
    const dem::BlockElement exact = dem::block_element(spec_of(skew(), 5));
    for (const Point off : {Point{1e-6, 0}, Point{-7e-7, 7e-7}, Point{3e-7, -9e-7}}) {
        BlockSpec s = spec_of(skew(), 5);
        s.edges[1].to.x += off.x; // the next edge begins at the corner itself
        s.edges[1].to.z += off.z;
        const dem::BlockElement e = dem::block_element(s);
        REQUIRE(e.points.size() == exact.points.size());
        CHECK(e.lambda(3) == Approx(exact.lambda(3)).epsilon(1e-4));
        CHECK(e.lambda.maxCoeff() == Approx(exact.lambda.maxCoeff()).epsilon(1e-4));
    }
}

TEST_CASE("polygon block: a contact point that lies on no side is an error, not a point "
          "without force",
          "[dem][polygon]")
{
    BlockSpec s = spec_of(skew(), 5);
    s.edges[0].to.z += 2e-5;
    CHECK_THROWS_WITH(dem::block_element(s),
                      Catch::StartsWith("no zone has a node at the contact point ("));
}
