#include "dem/block/condensation.hpp"
#include "tests/dem/block_specs.hpp"
#include "tests/dem/eigenvalues.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace {

using block_specs::Mesh;
using dem::BlockSpec;
using dem::Condensed;
using dem::FaceRule;
using dem::Motion;
using dem::Point;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Mesh some_mesh()
{
    return {GENERATE(FaceRule::even, FaceRule::lobatto), GENERATE(2, 3, 4, 6),
            GENERATE(1, 2, 3)};
}

/// Displacements of a strain (eps_x, eps_z, gamma) that keep the bottom level.
VectorXd linear_field(const std::vector<Point>& points, const Eigen::Vector3d& strain)
{
    VectorXd u(2 * static_cast<Eigen::Index>(points.size()));
    for (std::size_t p = 0; p < points.size(); ++p) {
        const auto row = 2 * static_cast<Eigen::Index>(p);
        u(row) = strain(0) * points[p].x + strain(2) * points[p].z;
        u(row + 1) = strain(1) * points[p].z;
    }
    return u;
}

int point_at(const Condensed& c, Point at)
{
    const auto p = std::find_if(c.points.begin(), c.points.end(),
                                [at](Point q) { return dem::same_place(at, q); });
    REQUIRE(p != c.points.end());
    return static_cast<int>(p - c.points.begin());
}

/// A uniform stress (sigma_x, sigma_z, tau) on the contact areas of a block's faces.
VectorXd contact_loads(const BlockSpec& spec, const Condensed& c, const Eigen::Vector3d& stress)
{
    VectorXd f = VectorXd::Zero(c.stiffness.rows());
    for (const dem::BlockEdge& e : spec.edges) {
        const double dx = e.to.x - e.from.x, dz = e.to.z - e.from.z;
        const double nx = dz == 0         ? 0
                          : e.from.x == 0 ? -1
                                          : 1,
                     nz = dx == 0         ? 0
                          : e.from.z == 0 ? -1
                                          : 1;
        for (std::size_t i = 0; i < e.points.position.size(); ++i) {
            const double s = e.points.position[i],
                         area = e.points.weight[i] * std::hypot(dx, dz) * spec.thickness;
            const int p = point_at(c, {e.from.x + s * dx, e.from.z + s * dz});
            f(2 * p) += area * (stress(0) * nx + stress(2) * nz);
            f(2 * p + 1) += area * (stress(2) * nx + stress(1) * nz);
        }
    }
    return f;
}

double largest(const VectorXd& v) { return v.cwiseAbs().maxCoeff(); }

/// A linear field at the contact points against stress times contact areas; relative.
double patch_error(const BlockSpec& spec, const Eigen::Vector3d& strain)
{
    const Condensed c = dem::condense(spec);
    const VectorXd loads = contact_loads(spec, c, dem::plane_stress(spec.material) * strain);
    return largest(c.stiffness * linear_field(c.points, strain) - loads) / largest(loads);
}

Eigen::Vector3d some_strain()
{
    return GENERATE(Eigen::Vector3d(1e-4, 0, 0), Eigen::Vector3d(0, 1e-4, 0),
                    Eigen::Vector3d(0, 0, 1e-4), Eigen::Vector3d(2e-4, -3e-4, 1e-4));
}

} // namespace

TEST_CASE("condensation: a linear field at the contact points gives stress times contact areas",
          "[dem][condensation]")
{
    CHECK(patch_error(block_specs::half_unit(some_mesh()), some_strain()) < 1e-10);
}

TEST_CASE("condensation: a block between two others below and two above passes the patch test "
          "with even points",
          "[dem][condensation]")
{
    const Mesh mesh{FaceRule::even, GENERATE(2, 3, 5), GENERATE(1, 2)};
    CHECK(patch_error(block_specs::quarter_bond(mesh), some_strain()) < 1e-10);
}

TEST_CASE("condensation: a block between two others below and two above passes the patch test "
          "with lobatto points",
          "[dem][condensation]")
{
    const Mesh mesh{FaceRule::lobatto, GENERATE(2, 3, 5), GENERATE(1, 2)};
    CHECK(patch_error(block_specs::quarter_bond(mesh), some_strain()) < 1e-10);
}

TEST_CASE("condensation: sides without contacts are free of stress", "[dem][condensation]")
{
    const BlockSpec spec = block_specs::stacked(some_mesh());
    const double nu = spec.material.poisson_ratio;
    CHECK(patch_error(spec, {-nu * 1e-4, 1e-4, 0}) < 1e-10); // sigma_x = 0
}

TEST_CASE("condensation: clamped blocks pass the patch test with fields that leave their "
          "support at rest",
          "[dem][condensation]")
{
    const Mesh mesh = some_mesh();
    BlockSpec clamped = block_specs::on_ground(mesh, Motion::clamped_bottom);
    clamped.material.poisson_ratio = 0.0; // a clamped block that spreads has no uniform stress
    BlockSpec toe = block_specs::on_ground(mesh, Motion::clamped_bottom_held_right);
    toe.material.poisson_ratio = 0.0;
    for (const BlockSpec& spec : {clamped, toe}) {
        const bool held_right = spec.motion == Motion::clamped_bottom_held_right;
        const Eigen::Vector3d strain(0, 1e-4, held_right ? 0.0 : 1e-4);
        const Condensed c = dem::condense(spec);
        const VectorXd loads =
            contact_loads(spec, c, dem::plane_stress(spec.material) * strain);
        const VectorXd forces = c.stiffness * linear_field(c.points, strain);
        for (Eigen::Index i = 0; i < forces.size(); ++i)
            if (!c.held[i]) CHECK(std::abs(forces(i) - loads(i)) < 1e-10 * largest(loads));
    }
}

TEST_CASE("condensation: nodes follow a linear field of the points, inside and between them",
          "[dem][condensation]")
{
    const Mesh mesh = some_mesh();
    const Eigen::Vector3d strain = some_strain();
    for (const BlockSpec& spec :
         {block_specs::half_unit(mesh), block_specs::quarter_bond(mesh)}) {
        const Condensed c = dem::condense(spec);
        const VectorXd nodes = c.nodes_from_points * linear_field(c.points, strain);
        CHECK(largest(nodes - linear_field(c.mesh.nodes, strain)) < 1e-12 * largest(nodes));
    }
}

TEST_CASE("condensation: nodes off the contact faces are in equilibrium whatever the points do",
          "[dem][condensation]")
{
    const BlockSpec spec = block_specs::stacked(some_mesh());
    const Condensed c = dem::condense(spec);
    const MatrixXd k = dem::mesh_stiffness(c.mesh, spec.thickness, spec.material);
    const MatrixXd forces = k * c.nodes_from_points;
    const std::vector<Point> nodes = c.mesh.nodes;
    int off = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n)
        if (nodes[n].z > 0 && nodes[n].z < spec.height) {
            ++off;
            CHECK(forces.middleRows<2>(2 * static_cast<Eigen::Index>(n)).cwiseAbs().maxCoeff() <
                  1e-12 * k.cwiseAbs().maxCoeff());
        }
    CHECK(off > 0);
}

TEST_CASE("condensation: stiffness is the elastic energy of the nodes, without force under "
          "rigid motions",
          "[dem][condensation]")
{
    const Mesh mesh = some_mesh();
    for (const BlockSpec& spec : {block_specs::half_unit(mesh), block_specs::quarter_bond(mesh),
                                  block_specs::beam(mesh)}) {
        const Condensed c = dem::condense(spec);
        const MatrixXd k = dem::mesh_stiffness(c.mesh, spec.thickness, spec.material);
        const MatrixXd energy = c.nodes_from_points.transpose() * k * c.nodes_from_points;
        const double size = c.stiffness.cwiseAbs().maxCoeff();
        CHECK((energy - c.stiffness).cwiseAbs().maxCoeff() < 1e-13 * size);
        CHECK(c.stiffness == c.stiffness.transpose());

        const VectorXd values = eigenvalues(c.stiffness);
        CHECK(std::abs(values(2)) < 1e-12 * size); // three rigid motions
        CHECK(values(3) > 1e-5 * size);
        for (const double sign : {0.0, 1.0}) { // moved, and turned
            VectorXd rigid(c.stiffness.rows());
            for (std::size_t p = 0; p < c.points.size(); ++p) {
                rigid(2 * static_cast<Eigen::Index>(p)) = 1.0 - sign * c.points[p].z;
                rigid(2 * static_cast<Eigen::Index>(p) + 1) = 2.0 + sign * c.points[p].x;
            }
            CHECK(largest(c.stiffness * rigid) < 1e-12 * size * largest(rigid));
        }
    }
}

TEST_CASE("condensation: a condensed load keeps its resultant and moment",
          "[dem][condensation]")
{
    const Mesh mesh = some_mesh();
    for (const BlockSpec& spec :
         {block_specs::half_unit(mesh), block_specs::stacked(mesh), block_specs::beam(mesh)}) {
        const Condensed c = dem::condense(spec);
        VectorXd load = VectorXd::Zero(2 * c.mesh.nodes.size());
        const std::vector<Point> nodes = c.mesh.nodes;
        double fx = 0, fz = 0, moment = 0, size = 0;
        for (std::size_t n = 0; n < nodes.size(); ++n) { // any load
            const double x = std::sin(3.0 * static_cast<double>(n)),
                         z = std::cos(5.0 * static_cast<double>(n));
            load(2 * static_cast<Eigen::Index>(n)) = x;
            load(2 * static_cast<Eigen::Index>(n) + 1) = z;
            fx += x;
            fz += z;
            moment += z * nodes[n].x - x * nodes[n].z;
            size += std::abs(x) + std::abs(z);
        }
        const VectorXd f = dem::condense_load(c, load);
        for (std::size_t p = 0; p < c.points.size(); ++p) {
            const double x = f(2 * static_cast<Eigen::Index>(p)),
                         z = f(2 * static_cast<Eigen::Index>(p) + 1);
            fx -= x;
            fz -= z;
            moment -= z * c.points[p].x - x * c.points[p].z;
        }
        CHECK(std::abs(fx) < 1e-12 * size);
        CHECK(std::abs(fz) < 1e-12 * size);
        CHECK(std::abs(moment) < 1e-12 * size);
    }
}

TEST_CASE("condensation: faces that meet in a corner share its point", "[dem][condensation]")
{
    const Mesh mesh{FaceRule::even, 4, 1};
    CHECK(dem::condense(block_specs::half_unit(mesh)).points.size() == 4 * 3);
    CHECK(dem::condense(block_specs::stacked(mesh)).points.size() == 2 * 4);
    CHECK(dem::condense(block_specs::beam(mesh)).points.size() == 3 * 3 + 1);
}

TEST_CASE("condensation: supports hold what they say", "[dem][condensation]")
{
    const Mesh mesh{FaceRule::even, 4, 2};
    const auto [spec, held] = GENERATE_COPY(table<BlockSpec, int>(
        {{block_specs::half_unit(mesh), 0},
         {block_specs::beam(mesh), 0},
         {block_specs::at_toe(mesh), 1}, // x of the lower right corner
         {block_specs::on_ground(mesh, Motion::clamped_bottom), 4}, // both lower corners
         {block_specs::on_ground(mesh, Motion::clamped_bottom_held_right),
          3}})); // lower left, x of the upper right
    const Condensed c = dem::condense(spec);
    CHECK(std::count(c.held.begin(), c.held.end(), true) == held);
    if (spec.motion == Motion::held_right_corner)
        CHECK(c.held[2 * point_at(c, {spec.width, 0.0})]);
    if (spec.motion == Motion::clamped_bottom)
        for (const double x : {0.0, spec.width})
            for (int d = 0; d < 2; ++d) CHECK(c.held[2 * point_at(c, {x, 0.0}) + d]);
    if (spec.motion == Motion::clamped_bottom_held_right) {
        CHECK(c.held[2 * point_at(c, {spec.width, spec.height})]);
        VectorXd u = VectorXd::Ones(c.stiffness.rows());
        for (Eigen::Index i = 0; i < u.size(); ++i) u(i) = c.held[i] ? 0.0 : 1.0;
        const VectorXd nodes = c.nodes_from_points * u;
        const std::vector<Point> at = c.mesh.nodes;
        for (std::size_t n = 0; n < at.size(); ++n) {
            const auto row = 2 * static_cast<Eigen::Index>(n);
            if (at[n].x == spec.width || at[n].z == 0.0) CHECK(nodes(row) == 0.0);
            if (at[n].z == 0.0) CHECK(nodes(row + 1) == 0.0);
        }
    }
}

TEST_CASE("condensation: the outline runs counter-clockwise through corners and contact points "
          "and moves with them",
          "[dem][condensation]")
{
    const Mesh mesh = some_mesh();
    for (const BlockSpec& spec : {block_specs::half_unit(mesh), block_specs::quarter_bond(mesh),
                                  block_specs::stacked(mesh), block_specs::beam(mesh)}) {
        const Condensed c = dem::condense(spec);
        double twice_area = 0.0;
        for (std::size_t i = 0; i < c.outline.size(); ++i) {
            const Point a = c.outline[i], b = c.outline[(i + 1) % c.outline.size()];
            twice_area += a.x * b.z - b.x * a.z;
            CHECK((a.x == b.x || a.z == b.z)); // no corner cut
        }
        CHECK(twice_area == Approx(2 * spec.width * spec.height).epsilon(1e-12));
        CHECK(dem::same_place(c.outline.front(), {0, 0}));
        std::size_t found = 0;
        for (std::size_t o = 0; o < c.outline.size(); ++o)
            for (std::size_t p = 0; p < c.points.size(); ++p)
                if (dem::same_place(c.outline[o], c.points[p])) {
                    ++found;
                    for (int d = 0; d < 2; ++d) {
                        VectorXd unit = VectorXd::Zero(c.stiffness.rows());
                        unit(2 * static_cast<Eigen::Index>(p) + d) = 1.0;
                        const auto row = 2 * static_cast<Eigen::Index>(o) + d;
                        CHECK((c.outline_from_points.row(row).transpose() - unit)
                                  .cwiseAbs()
                                  .maxCoeff() < 1e-12);
                    }
                }
        CHECK(found == c.points.size());
    }
}

TEST_CASE("condensation: zones along sides without contacts are no larger than asked for",
          "[dem][condensation]")
{
    BlockSpec spec = block_specs::stacked({FaceRule::even, 4, 2});
    spec.zone_size = GENERATE(0.09, 0.05, 0.03, 0.013);
    const Condensed c = dem::condense(spec);
    std::set<double> x, z; // of the grid lines
    for (const Point p : c.mesh.nodes) {
        x.insert(p.x);
        z.insert(p.z);
    }
    CHECK(x.size() == 3 * 2 + 1); // contact points and zones between
    REQUIRE(z.size() >= 2);
    CHECK(*z.begin() == 0.0);
    CHECK(*z.rbegin() == Approx(spec.height).epsilon(1e-15));
    const double size = *std::next(z.begin());
    CHECK(size < spec.zone_size * (1 + 1e-9));
    CHECK(static_cast<double>(z.size() - 1) < spec.height / spec.zone_size + 1);
}
