#include "dem/block/mesh.hpp"
#include "tests/dem/eigenvalues.hpp"

#include <Eigen/SparseCholesky>
#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace {

using dem::Elastic;
using dem::ZoneGrid;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kThickness = 0.2;                // [m]
constexpr Elastic kStone = {15.5e9, 0.2, 2700.0}; // of problems 5 and 6
constexpr Elastic kNoPoisson = {15.5e9, 0.0, 2700.0};
/// Plane strain by the constants of plane stress.
constexpr Elastic kPlaneStrain = {15.5e9 / (1 - 0.2 * 0.2), 0.2 / (1 - 0.2), 2700.0};

std::vector<double> even_lines(double size, int zones)
{
    std::vector<double> x(zones + 1);
    for (int i = 0; i <= zones; ++i) x[i] = size * i / zones;
    return x;
}

ZoneGrid irregular_grid()
{
    return {{-0.03, 0.0, 0.011, 0.075, 0.08, 0.17}, {0.02, 0.05, 0.051, 0.09, 0.13}};
}

/// Displacements of a strain (eps_x, eps_z, gamma) and a small rotation, about the origin.
VectorXd linear_field(const ZoneGrid& grid, const Eigen::Vector3d& strain,
                      double rotation = 0.0)
{
    VectorXd u(2 * grid.nodes());
    for (int j = 0; j < static_cast<int>(grid.z.size()); ++j)
        for (int i = 0; i < static_cast<int>(grid.x.size()); ++i) {
            const double x = grid.x[i], z = grid.z[j];
            const int n = grid.node(i, j);
            u(2 * n) = strain(0) * x + (0.5 * strain(2) - rotation) * z;
            u(2 * n + 1) = strain(1) * z + (0.5 * strain(2) + rotation) * x;
        }
    return u;
}

/// Nodal loads of a uniform stress (sigma_x, sigma_z, tau) on the boundary: half of each side
/// to each of its ends.
VectorXd boundary_loads(const ZoneGrid& grid, const Eigen::Vector3d& stress)
{
    VectorXd f = VectorXd::Zero(2 * grid.nodes());
    const auto side = [&f](int a, int b, double length, double px, double pz) {
        for (const int n : {a, b}) {
            f(2 * n) += 0.5 * length * kThickness * px;
            f(2 * n + 1) += 0.5 * length * kThickness * pz;
        }
    };
    const int nx = static_cast<int>(grid.x.size()), nz = static_cast<int>(grid.z.size());
    for (int i = 0; i + 1 < nx; ++i) {
        const double length = grid.x[i + 1] - grid.x[i];
        side(grid.node(i, 0), grid.node(i + 1, 0), length, -stress(2), -stress(1));
        side(grid.node(i, nz - 1), grid.node(i + 1, nz - 1), length, stress(2), stress(1));
    }
    for (int j = 0; j + 1 < nz; ++j) {
        const double length = grid.z[j + 1] - grid.z[j];
        side(grid.node(0, j), grid.node(0, j + 1), length, -stress(0), -stress(2));
        side(grid.node(nx - 1, j), grid.node(nx - 1, j + 1), length, stress(0), stress(2));
    }
    return f;
}

/// Whether a degree of freedom is free; i, j: grid line of the node, direction 0: x, 1: z.
using Free = std::function<bool(int i, int j, int direction)>;

std::vector<int> free_rows(const ZoneGrid& grid, const Free& is_free)
{
    std::vector<int> rows;
    for (int j = 0; j < static_cast<int>(grid.z.size()); ++j)
        for (int i = 0; i < static_cast<int>(grid.x.size()); ++i)
            for (int d = 0; d < 2; ++d)
                if (is_free(i, j, d)) rows.push_back(2 * grid.node(i, j) + d);
    return rows;
}

/// Lowest circular frequency of the grid with its mass lumped at the nodes [rad/s].
double lowest_frequency(const ZoneGrid& grid, const Elastic& material, const Free& is_free)
{
    const MatrixXd k = dem::mesh_stiffness(dem::grid_mesh(grid), kThickness, material);
    const VectorXd area = dem::nodal_areas(dem::grid_mesh(grid));
    const std::vector<int> rows = free_rows(grid, is_free);
    VectorXd inv_root_mass(rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r)
        inv_root_mass(static_cast<Eigen::Index>(r)) =
            1.0 / std::sqrt(material.density * kThickness * area(rows[r] / 2));
    const MatrixXd k_free = k(rows, rows);
    const MatrixXd scaled = inv_root_mass.asDiagonal() * k_free * inv_root_mass.asDiagonal();
    return std::sqrt(eigenvalues(scaled)(0));
}

ZoneGrid bar(int zones, double height = 0.02, int rows = 1)
{
    return {even_lines(1.0, zones), even_lines(height, rows)};
}

/// Speed of the wave whose quarter length is the bar, 1 m, fixed at x = 0 [m/s].
double wave_speed(double omega) { return omega / (0.5 * std::numbers::pi); }

struct Wave {
    const char* name;
    Elastic material;
    int moving;   ///< direction of motion; the other is held
    double speed; ///< problem 5 [m/s]
};

constexpr double kClamped = 1e25; // [N/m]: a support that does not move

/// Tip deflection of problem 6 by a grid of columns x rows zones, the load spread evenly over
/// the end [m].
double cantilever_tip(int columns, int rows, const Elastic& material)
{
    const double height = 0.1, thickness = 0.1, load = 1e3;
    const ZoneGrid grid{even_lines(1.0, columns), even_lines(height, rows)};
    Eigen::SparseMatrix<double> k =
        dem::mesh_stiffness(dem::grid_mesh(grid), thickness, material);
    for (int j = 0; j <= rows; ++j)
        for (int d = 0; d < 2; ++d) {
            const int row = 2 * grid.node(0, j) + d;
            k.coeffRef(row, row) = kClamped;
        }
    VectorXd f = VectorXd::Zero(k.rows());
    for (int j = 0; j < rows; ++j)
        for (const int end : {j, j + 1})
            f(2 * grid.node(columns, end) + 1) += 0.5 * load / rows;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(k);
    return solver.solve(f).dot(f) / load;
}

constexpr double kEulerBernoulli =
    1e3 * 1e4 * 12 / (3 * 15.5e9);        // problem 6: P L^3 / (3 E I), 2.5806 mm
constexpr double kTimoshenko = 2.5992e-3; // problem 6 [m]

} // namespace

TEST_CASE("zones: a linear field on irregular grid lines needs the consistent boundary loads "
          "and no others",
          "[dem][zones]")
{
    const ZoneGrid grid = irregular_grid();
    const MatrixXd k = dem::mesh_stiffness(dem::grid_mesh(grid), kThickness, kStone);
    const Eigen::Vector3d strain =
        GENERATE(Eigen::Vector3d(1e-4, 0, 0), Eigen::Vector3d(0, 1e-4, 0),
                 Eigen::Vector3d(0, 0, 1e-4), Eigen::Vector3d(3e-4, -2e-4, 5e-4));
    const double rotation = GENERATE(0.0, 1e-4);
    const VectorXd loads = boundary_loads(grid, dem::plane_stress(kStone) * strain);
    const VectorXd forces = k * linear_field(grid, strain, rotation);
    CHECK((forces - loads).cwiseAbs().maxCoeff() < 1e-10 * loads.cwiseAbs().maxCoeff());
}

TEST_CASE("zones: rigid motions need no force, every other motion does", "[dem][zones]")
{
    const ZoneGrid grid = irregular_grid();
    const MatrixXd k = dem::mesh_stiffness(dem::grid_mesh(grid), kThickness, kStone);
    VectorXd right = VectorXd::Zero(k.rows()), up = right;
    for (int n = 0; n < grid.nodes(); ++n) right(2 * n) = up(2 * n + 1) = 1.0;
    for (const VectorXd& u : {right, up, linear_field(grid, {0, 0, 0}, 1.0)})
        CHECK((k * u).norm() < 1e-12 * k.norm() * u.norm());

    const VectorXd e = eigenvalues(k);
    CHECK(e(2) < 1e-12 * e(e.size() - 1));
    CHECK(e(3) > 1e-6 * e(e.size() - 1)); // no hourglass motion
}

TEST_CASE("zones: stiffness is symmetric", "[dem][zones]")
{
    const MatrixXd k =
        dem::mesh_stiffness(dem::grid_mesh(irregular_grid()), kThickness, kStone);
    CHECK((k - k.transpose()).cwiseAbs().maxCoeff() < 1e-15 * k.cwiseAbs().maxCoeff());
}

TEST_CASE("zones: one zone bends as a beam, E I, whatever its proportions", "[dem][zones]")
{
    const auto [width, height] =
        GENERATE(table<double, double>({{0.1, 0.1}, {0.4, 0.05}, {0.02, 0.3}}));
    const double curvature = 1e-3;
    Eigen::Matrix<double, 8, 1> u = Eigen::Matrix<double, 8, 1>::Zero();
    const double corner = 0.25 * curvature * width * height; // u_x = curvature x z
    u(0) = u(4) = corner;
    u(2) = u(6) = -corner;
    const auto k = dem::zone_stiffness(width, height, kThickness, kStone);
    const double bending = kStone.young_modulus * kThickness * std::pow(height, 3) / 12.0;
    CHECK(0.5 * u.dot(k * u) ==
          Approx(0.5 * bending * curvature * curvature * width).epsilon(1e-12));
}

TEST_CASE("zones: nodal areas add up to the grid, a linear function over them to its integral",
          "[dem][zones]")
{
    const ZoneGrid grid = irregular_grid();
    const VectorXd area = dem::nodal_areas(dem::grid_mesh(grid));
    const double width = 0.20, height = 0.11, x_mean = 0.07, z_mean = 0.075;
    CHECK(area.sum() == Approx(width * height).epsilon(1e-14));
    double x = 0.0, z = 0.0;
    for (int j = 0; j < static_cast<int>(grid.z.size()); ++j)
        for (int i = 0; i < static_cast<int>(grid.x.size()); ++i) {
            x += area(grid.node(i, j)) * grid.x[i];
            z += area(grid.node(i, j)) * grid.z[j];
        }
    CHECK(x == Approx(width * height * x_mean).epsilon(1e-14));
    CHECK(z == Approx(width * height * z_mean).epsilon(1e-14));
}

TEST_CASE("zones: bar, P and S waves have their speeds, with an error of second order",
          "[dem][zones]")
{
    // Problem 5. One direction moves, so the grid is a chain: c_n = c sin(x)/x, x = pi/(4 n).
    const Wave wave =
        GENERATE(Wave{"bar", kNoPoisson, 0, 2395.98}, Wave{"P", kPlaneStrain, 0, 2525.59},
                 Wave{"S", kPlaneStrain, 1, 1546.60});
    INFO(wave.name << " wave");
    const auto speed = [&wave](int zones) {
        return wave_speed(
            lowest_frequency(bar(zones), wave.material,
                             [&wave](int i, int, int d) { return i > 0 && d == wave.moving; }));
    };
    for (const int zones : {4, 8, 16, 32}) {
        const double x = std::numbers::pi / (4 * zones);
        CHECK(
            speed(zones) ==
            Approx(wave.speed * std::sin(x) / x).epsilon(3e-6)); // as many digits as are given
    }
    const double coarse = speed(8), medium = speed(16), fine = speed(32);
    CHECK((fine - medium) / (medium - coarse) == Approx(0.25).epsilon(5e-3));
    CHECK(fine + (fine - medium) / 3 == Approx(wave.speed).epsilon(3e-6));
}

TEST_CASE("zones: a slender bar with free sides sounds at 599.0 Hz", "[dem][zones]")
{
    // Problem 5. Half of the bar, above its axis; both directions move. Lateral inertia: 1 -
    // (pi nu h)^2 / 96 = 1 - 2e-6.
    const auto frequency = [](int zones) {
        const ZoneGrid half = bar(zones, 0.01);
        const auto is_free = [](int i, int j, int d) { return d == 0 ? i > 0 : j > 0; };
        return lowest_frequency(half, kStone, is_free) / (2 * std::numbers::pi);
    };
    const double medium = frequency(20), fine = frequency(40);
    CHECK(fine == Approx(599.0).epsilon(1e-4));
    CHECK(fine + (fine - medium) / 3 == Approx(2395.98 / 4).epsilon(5e-6));
}

TEST_CASE("zones: one row of n zones bends like n beams with linear moment and constant shear",
          "[dem][zones]")
{
    // Problem 6:  P L^3/(3 E I) (1 - 1/(4 n^2)) + P L/(G A)
    const Elastic material = GENERATE(as<Elastic>{}, kNoPoisson, kStone);
    const double shear_modulus = 0.5 * material.young_modulus / (1 + material.poisson_ratio);
    const double shear = 1e3 / (shear_modulus * 0.1 * 0.1);
    CHECK(kEulerBernoulli + 1.2 * shear ==
          Approx(material.poisson_ratio > 0 ? kTimoshenko : 2.5961e-3).epsilon(2e-5));
    for (const int n : {1, 2, 5, 10, 40})
        CHECK(cantilever_tip(n, 1, material) ==
              Approx(kEulerBernoulli * (1 - 0.25 / (n * n)) + shear).epsilon(1e-10));
}

TEST_CASE("zones: the cantilever comes to Timoshenko's deflection as its zones get smaller",
          "[dem][zones]")
{
    const auto error = [](int columns, int rows) {
        return cantilever_tip(columns, rows, kStone) / kTimoshenko - 1;
    };
    // The clamp holds the root's depth as well: elasticity's limit is 0.08 % stiffer than the
    // beam's.
    CHECK(std::abs(error(5, 1)) < 1.2e-2);
    CHECK(std::abs(error(10, 1)) < 3.7e-3);
    CHECK(std::abs(error(20, 2)) < 3.1e-3);
    CHECK(std::abs(error(40, 4)) < 1.7e-3);
    CHECK(std::abs(error(80, 8)) < 1.2e-3);

    // Without Poisson's ratio it does not, and the error falls at second order.
    const double exact = kEulerBernoulli + 1.2 * 1e3 / (0.5 * 15.5e9 * 0.1 * 0.1);
    const double medium = cantilever_tip(40, 4, kNoPoisson) / exact - 1,
                 fine = cantilever_tip(80, 8, kNoPoisson) / exact - 1;
    CHECK(std::abs(fine) < 1.2e-4);
    CHECK(fine / medium == Approx(0.25).epsilon(0.02));
}
