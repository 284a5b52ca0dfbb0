#include "dem/block/sparse_modes.hpp"

#include "core/eigen_pairs.hpp"
#include "dem/block/block_modes.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace dem {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

/// Smallest share of the amplitude of a field that must be new, as in block_modes.
constexpr double kNew = 0.01;
/// Share of the contact stiffness, added so that rigid motions can be factorised [-]. Modes
/// softer than this are as good as rigid.
constexpr double kShift = 1e-7;

/// Share of the square of a vector below which what is new in it is rounding [-]; then Lanczos
/// begins anew.
constexpr double kResidual = 1e-14;
constexpr int kRestarts = 40;

struct Problem {
    Sparse k, c; ///< of the open unknowns
    Eigen::SimplicialLDLT<Sparse> shifted;
};

/// Columns and rows of the unknowns that no support holds.
Sparse open_columns(const SparseBlock& b)
{
    std::vector<Eigen::Triplet<double>> entries;
    int open = 0;
    for (int i = 0; i < b.stiffness.cols(); ++i)
        if (i >= static_cast<int>(b.held.size()) || !b.held[static_cast<std::size_t>(i)])
            entries.emplace_back(i, open++, 1.0);
    Sparse m(b.stiffness.cols(), open);
    m.setFromTriplets(entries.begin(), entries.end());
    return m;
}

double size_of(const Sparse& c, const VectorXd& v) { return v.dot(c * v); }

/// Appends v, made C-orthonormal to the basis, if enough of it is new.
bool append(const Sparse& c, VectorXd v, double least, MatrixXd& basis)
{
    const double whole = size_of(c, v);
    if (!(whole > 0.0)) return false;
    v /= std::sqrt(whole);
    for (int twice = 0; twice < 2; ++twice)
        if (basis.cols() > 0) v -= basis * (basis.transpose() * (c * v));
    const double left = size_of(c, v);
    if (left < least) return false;
    basis.conservativeResize(v.size(), basis.cols() + 1);
    basis.col(basis.cols() - 1) = v / std::sqrt(left);
    return true;
}

/// A field at the points, with the inside in equilibrium: nearly all stiffness is on the
/// points.
MatrixXd with_inside(const Problem& p, const MatrixXd& at_points)
{
    MatrixXd all = MatrixXd::Zero(p.k.cols(), at_points.cols());
    all.topRows(at_points.rows()) = at_points;
    const Index outer = at_points.rows(), inner = p.k.cols() - outer;
    if (inner == 0) return all;
    const Sparse inside = p.k.bottomRightCorner(inner, inner);
    const Sparse across = p.k.bottomLeftCorner(inner, outer);
    const Eigen::SimplicialLDLT<Sparse> solver(inside);
    if (solver.info() != Eigen::Success)
        throw std::runtime_error("block: its zones cannot be factorised");
    all.bottomRows(inner) = solver.solve(-(across * at_points));
    return all;
}

/// A field with a part of every mode, the same in every run.
VectorXd irregular(Index size, int which)
{
    VectorXd v(size);
    for (Index i = 0; i < size; ++i)
        v(i) = std::sin(1.0 + which + (1.7 + 0.31 * which) * static_cast<double>(i * i % 9973));
    return v;
}

/// Softest first, C-orthogonal to `known`.
MatrixXd softest(const Problem& p, const MatrixXd& known, Index wanted)
{
    MatrixXd basis = known;
    const Index start = known.cols();
    const Index most = std::min<Index>(start + 6 * wanted + 40, p.c.nonZeros());
    // without what is known, or the solution would be a rigid motion 1e7 times as large as the
    // rest
    const auto fresh = [&](int which) -> VectorXd {
        const VectorXd v = irregular(p.k.cols(), which);
        return v - basis * (basis.transpose() * (p.c * v));
    };
    VectorXd v = fresh(0);
    for (int restarts = 0; basis.cols() < most && restarts < kRestarts;) {
        v = p.shifted.solve(p.c * v);
        if (append(p.c, v, kResidual, basis)) {
            v = basis.rightCols(1);
        } else { // what is left of v is rounding: begin anew
            v = fresh(++restarts);
        }
    }
    const MatrixXd q = basis.rightCols(basis.cols() - start);
    if (q.cols() == 0) return q;
    const core::EigenPairs ritz = core::eigen_pairs(q.transpose() * (p.k * q));
    return q * ritz.vectors.leftCols(std::min(wanted, q.cols()));
}

MatrixXd ritz_modes(const Problem& p, const MatrixXd& basis, VectorXd& lambda)
{
    if (basis.cols() == 0) return basis;
    const core::EigenPairs best =
        core::eigen_pairs(basis.transpose() * (p.k * basis), basis.transpose() * (p.c * basis));
    lambda = best.values;
    return basis * best.vectors;
}

void extend(const Problem& p, const MatrixXd& candidates, Index wanted, MatrixXd& basis)
{
    for (Index i = 0; i < candidates.cols() && basis.cols() < wanted; ++i)
        append(p.c, candidates.col(i), kNew, basis);
}

} // namespace

bool has_many_points(const BlockSpec& spec)
{
    if (spec.modes == 0) return false;
    std::size_t points = 0;
    for (const BlockEdge& e : spec.edges) points += e.points.position.size();
    return points > kManyPoints;
}

SparseModes sparse_modes(const BlockSpec& spec, const SparseBlock& block)
{
    const Sparse open = open_columns(block);
    const Sparse close = open.transpose();
    Problem p;
    p.k = close * block.stiffness * open;
    p.c = close * sparse_metric(spec, block.points, block.stiffness.cols()) * open;
    p.shifted.compute(p.k + kShift * p.c);
    if (p.shifted.info() != Eigen::Success)
        throw std::runtime_error("block: its zones cannot be factorised");

    const Index held = std::count(block.held.begin(), block.held.end(), true);
    const Index points = 2 * static_cast<Index>(block.points.size()) - held;
    const auto field = [&](const MatrixXd& f) -> MatrixXd {
        if (f.cols() == 0) return MatrixXd(p.k.cols(), 0);
        MatrixXd all = MatrixXd::Zero(block.stiffness.cols(), f.cols());
        all.topRows(f.rows()) = f;
        return with_inside(p, (close * all).topRows(points));
    };
    const LinearFields fields = linear_fields(spec, block.points);
    const bool supported = fields.rigid.cols() == 0;
    const bool hinged = is_hinged(spec.motion);
    const int rigid_held = !supported ? 0 : hinged ? 1 : 3; // of the modes asked for
    const Index wanted = std::min<Index>(spec.modes - rigid_held, points);
    MatrixXd rigid(p.k.cols(), 0), moving(p.k.cols(), 0);
    extend(p, field(fields.rigid), 3, rigid);
    extend(p, field(fields.moving), 3, moving);
    MatrixXd basis = rigid;
    if (wanted > rigid.cols()) extend(p, field(fields.linear), wanted, basis);
    if (basis.cols() < wanted) extend(p, softest(p, rigid, wanted), wanted, basis);
    if (basis.cols() < wanted)
        throw std::runtime_error("block: the search for its softest modes found " +
                                 std::to_string(basis.cols()) + " of " +
                                 std::to_string(wanted));

    VectorXd lambda;
    const MatrixXd elastic =
        ritz_modes(p, basis.rightCols(basis.cols() - rigid.cols()), lambda);
    MatrixXd modes(p.k.cols(), moving.cols() + elastic.cols());
    modes << moving, elastic;
    SparseModes m;
    m.lambda = VectorXd::Zero(modes.cols());
    if (lambda.size() > 0) m.lambda.tail(lambda.size()) = lambda.cwiseMax(0.0);
    const MatrixXd all = open * modes;
    m.phi = all.topRows(2 * static_cast<Index>(block.points.size()));
    m.nodes = block.nodes * all;
    return m;
}

} // namespace dem
