#include "dem/block/block_modes.hpp"

#include "core/eigen_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Displacements (u_x, u_z) at the contact points of the linear field u = a + b x + c z, where
/// x and z are measured from `centre`.
VectorXd linear_field(const std::vector<Point>& points, Point centre, Point a, Point b, Point c)
{
    VectorXd u(2 * static_cast<Index>(points.size()));
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double x = points[p].x - centre.x, z = points[p].z - centre.z;
        u(2 * static_cast<Index>(p)) = a.x + b.x * x + c.x * z;
        u(2 * static_cast<Index>(p) + 1) = a.z + b.z * x + c.z * z;
    }
    return u;
}

MatrixXd columns(std::initializer_list<VectorXd> list)
{
    MatrixXd m(list.begin()->size(), static_cast<Index>(list.size()));
    Index i = 0;
    for (const VectorXd& v : list) m.col(i++) = v;
    return m;
}

/// Appends the candidates to `basis`, made C-orthonormal to it, until it has `wanted` columns.
/// Candidates that the basis nearly spans are left out, and those that move no contact point.
void extend_basis(const MatrixXd& c, const MatrixXd& candidates, Index wanted, MatrixXd& basis)
{
    for (Index k = 0; k < candidates.cols() && basis.cols() < wanted; ++k) {
        VectorXd v = candidates.col(k);
        const double whole = v.dot(c * v);
        if (!(whole > 0.0))
            continue; // a shear moves none of them where all contacts are at the bottom
        v /= std::sqrt(whole);
        for (int twice = 0; twice < 2; ++twice)
            if (basis.cols() > 0) v -= basis * (basis.transpose() * (c * v));
        const double left = v.dot(c * v);
        if (left < 0.01) continue; // the basis spans all but a tenth of its amplitude
        basis.conservativeResize(v.size(), basis.cols() + 1);
        basis.col(basis.cols() - 1) = v / std::sqrt(left);
    }
}

/// The best modes in the span of `basis` (Rayleigh-Ritz).
BlockModes ritz(const MatrixXd& k, const MatrixXd& c, const MatrixXd& basis)
{
    if (basis.cols() == 0) return {basis, VectorXd(0)};
    const core::EigenPairs best =
        core::eigen_pairs(basis.transpose() * k * basis, basis.transpose() * c * basis);
    return {basis * best.vectors, best.values};
}

BlockModes joined(const BlockModes& a, const BlockModes& b)
{
    BlockModes m;
    m.phi.resize(std::max(a.phi.rows(), b.phi.rows()), a.phi.cols() + b.phi.cols());
    m.phi << a.phi, b.phi;
    m.lambda.resize(a.lambda.size() + b.lambda.size());
    m.lambda << a.lambda, b.lambda;
    return m;
}

MatrixXd rigid_motions(const BlockSpec& spec, const std::vector<Point>& points)
{
    const Point centre{0.5 * spec.width, 0.5 * spec.height};
    return columns({linear_field(points, centre, {1, 0}, {}, {}),
                    linear_field(points, centre, {0, 1}, {}, {}),
                    linear_field(points, centre, {}, {0, -1}, {1, 0})});
}

/// The rigid motions that the driven beam can make: upwards, and rotation about its load line.
MatrixXd driven_motions(const BlockSpec& spec, const std::vector<Point>& points)
{
    const Point line{0.5 * spec.width, spec.load_height};
    const VectorXd up = linear_field(points, line, {0, 1}, {}, {});
    if (spec.rotation_fixed) return columns({up});
    return columns({up, linear_field(points, line, {}, {0, -1}, {1, 0})});
}

MatrixXd strains(const BlockSpec& spec, const std::vector<Point>& points)
{
    const Point centre{0.5 * spec.width, 0.5 * spec.height};
    return columns({linear_field(points, centre, {}, {1, 0}, {}),
                    linear_field(points, centre, {}, {}, {0, 1}),
                    linear_field(points, centre, {}, {0, 1}, {1, 0})});
}

/// The displacements of pure bending in plane stress, sigma_z = E x and sigma_x = E z about the
/// centre of the extent.
MatrixXd bendings(const BlockSpec& spec, const std::vector<Point>& points)
{
    const double nu = spec.material.poisson_ratio;
    MatrixXd u(2 * static_cast<Index>(points.size()), 2);
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double x = points[p].x - 0.5 * spec.width, z = points[p].z - 0.5 * spec.height;
        const auto row = 2 * static_cast<Index>(p);
        u.row(row) << -0.5 * (z * z + nu * x * x), x * z;
        u.row(row + 1) << x * z, -0.5 * (x * x + nu * z * z);
    }
    return u;
}

/// Strains that the elastic modes of a floating block begin with.
MatrixXd first_strains(const BlockSpec& spec, const std::vector<Point>& points)
{
    if (!spec.begins_with_bending) return strains(spec, points);
    MatrixXd both(2 * static_cast<Index>(points.size()), 5);
    both << strains(spec, points), bendings(spec, points);
    return both;
}

/// Modes of a block that no support touches. Rigid motions and deformations are kept apart, so
/// that rigid motions have no elastic force at all.
BlockModes floating_modes(const BlockSpec& spec, const Condensed& con, const MatrixXd& c)
{
    const MatrixXd& k = con.stiffness;
    const Index all = k.rows();
    const Index wanted = spec.modes > 0 ? std::min<Index>(spec.modes, all) : all;
    MatrixXd rigid(all, 0);
    extend_basis(c, rigid_motions(spec, con.points), 3, rigid);
    MatrixXd basis = rigid;
    if (wanted > 3 && wanted < all)
        extend_basis(c, first_strains(spec, con.points), wanted, basis);
    if (basis.cols() < wanted) extend_basis(c, core::eigen_pairs(k, c).vectors, wanted, basis);
    const BlockModes elastic = ritz(k, c, basis.rightCols(basis.cols() - rigid.cols()));
    MatrixXd moving = rigid;
    if (spec.motion == Motion::driven) {
        moving.resize(all, 0);
        extend_basis(c, driven_motions(spec, con.points), 2, moving);
    }
    return joined({moving, VectorXd::Zero(moving.cols())}, elastic);
}

/// The linear fields that a support allows, about the corner that is held, or the lower right
/// one.
MatrixXd supported_fields(const BlockSpec& spec, const std::vector<Point>& points)
{
    const Point corner{is_held_left(spec.motion) ? 0.0 : spec.width, 0.0};
    const auto field = [&](Point a, Point b, Point c) {
        return linear_field(points, corner, a, b, c);
    };
    const VectorXd shear = field({}, {}, {1, 0}), stretch = field({}, {}, {0, 1});
    if (spec.motion == Motion::clamped_bottom) return columns({shear, stretch});
    if (is_clamped(spec.motion)) return columns({stretch});
    return columns({field({0, 1}, {}, {}), field({}, {0, -1}, {1, 0}), shear, stretch,
                    field({}, {1, 0}, {})});
}

/// Modes of a block on a support. The rows of held displacements stay zero.
BlockModes supported_modes(const BlockSpec& spec, const Condensed& con, const MatrixXd& c)
{
    std::vector<Index> open;
    for (std::size_t i = 0; i < con.held.size(); ++i)
        if (!con.held[i]) open.push_back(static_cast<Index>(i));
    const MatrixXd k_open = con.stiffness(open, open), c_open = c(open, open);
    const Index all = static_cast<Index>(open.size());
    const bool hinged = is_hinged(spec.motion); // it can still turn and lift
    const Index wanted =
        spec.modes > 0 ? std::min<Index>(spec.modes - (hinged ? 1 : 3), all) : all;
    MatrixXd basis(all, 0);
    if (wanted < all)
        extend_basis(c_open, supported_fields(spec, con.points)(open, Eigen::all), wanted,
                     basis);
    extend_basis(c_open, core::eigen_pairs(k_open, c_open).vectors, wanted, basis);
    const BlockModes m = ritz(k_open, c_open, basis);
    BlockModes full{MatrixXd::Zero(con.stiffness.rows(), m.phi.cols()), m.lambda.cwiseMax(0.0)};
    for (Index i = 0; i < all; ++i) full.phi.row(open[i]) = m.phi.row(i);
    return full;
}

/// Calls `add` for each of the contacts of a block with these points; entries (row, column,
/// value) of 2 x 2 blocks.
template <class Add>
void each_contact(const BlockSpec& spec, const std::vector<Point>& points, Add add)
{
    for (const BlockEdge& e : spec.edges) {
        const double dx = e.to.x - e.from.x, dz = e.to.z - e.from.z,
                     length = std::hypot(dx, dz);
        const Eigen::Vector2d t(dx / length, dz / length), n(t.y(), -t.x());
        const Eigen::Matrix2d stiffness = e.kn * n * n.transpose() + e.ks * t * t.transpose();
        for (std::size_t i = 0; i < e.points.position.size(); ++i) {
            const double s = e.points.position[i];
            const Point at{e.from.x + s * dx, e.from.z + s * dz};
            const auto p = std::find_if(points.begin(), points.end(),
                                        [at](Point q) { return same_place(at, q); }) -
                           points.begin();
            add(2 * static_cast<Index>(p),
                e.points.weight[i] * length * spec.thickness * stiffness);
        }
    }
}

} // namespace

MatrixXd contact_metric(const BlockSpec& spec, const Condensed& con)
{
    MatrixXd c = MatrixXd::Zero(con.stiffness.rows(), con.stiffness.cols());
    each_contact(spec, con.points,
                 [&](Index at, const Eigen::Matrix2d& k) { c.block<2, 2>(at, at) += k; });
    return c;
}

Eigen::SparseMatrix<double> sparse_metric(const BlockSpec& spec,
                                          const std::vector<Point>& points, Index unknowns)
{
    std::vector<Eigen::Triplet<double>> entries;
    each_contact(spec, points, [&](Index at, const Eigen::Matrix2d& k) {
        for (int r = 0; r < 2; ++r)
            for (int q = 0; q < 2; ++q)
                entries.emplace_back(static_cast<int>(at) + r, static_cast<int>(at) + q,
                                     k(r, q));
    });
    Eigen::SparseMatrix<double> c(unknowns, unknowns);
    c.setFromTriplets(entries.begin(), entries.end());
    return c;
}

LinearFields linear_fields(const BlockSpec& spec, const std::vector<Point>& points)
{
    const bool supported = spec.motion != Motion::free && spec.motion != Motion::driven;
    if (supported) return {MatrixXd(), MatrixXd(), supported_fields(spec, points)};
    LinearFields f{rigid_motions(spec, points), rigid_motions(spec, points),
                   first_strains(spec, points)};
    if (spec.motion == Motion::driven) f.moving = driven_motions(spec, points);
    return f;
}

BlockModes block_modes(const BlockSpec& spec, const Condensed& c)
{
    const MatrixXd metric = contact_metric(spec, c);
    const bool supported = spec.motion != Motion::free && spec.motion != Motion::driven;
    return supported ? supported_modes(spec, c, metric) : floating_modes(spec, c, metric);
}

} // namespace dem
