#include "dem/solver/step/stability_limit.hpp"

#include "dem/solver/state/elastic_operator.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstddef>

namespace dem {

namespace {

using Vector = std::vector<double>;

constexpr double kTolerance = 1e-3; // of the eigenvalue
constexpr int kMostIterations = 400;
constexpr int kRitzEvery = 10;

/// Numbers in (-0.5, 0.5) without a pattern: the fractions of multiples of the golden ratio.
Vector start_vector(std::size_t n)
{
    constexpr double kGolden = 0.6180339887498949;
    Vector v(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double x = kGolden * static_cast<double>(i + 1);
        v[i] = x - std::floor(x) - 0.5;
    }
    return v;
}

void scale(double factor, Vector& v)
{
    for (double& x : v) x *= factor;
}

/// The largest eigenvalue of the tridiagonal matrix, and how much its residual may still hide.
struct Ritz {
    double value, error;
};
Ritz largest(const Vector& diagonal, const Vector& beside)
{
    const auto n = static_cast<Eigen::Index>(diagonal.size());
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n),
                                  Eigen::Map<const Eigen::VectorXd>(beside.data(), n - 1));
    return {solver.eigenvalues()(n - 1),
            std::abs(beside.back() * solver.eigenvectors()(n - 1, n - 1))};
}

/// q = R v
void apply(const MassRoots& roots, const Vector& v, Vector& q)
{
    for (std::size_t m = 0; m < v.size(); ++m) q[m] = roots.modes[m] * v[m];
    for (const MassRoots::Rigid& r : roots.rigid) {
        Eigen::Map<Eigen::Vector3d> three(q.data() + r.first_mode);
        three = Eigen::Vector3d(r.root * three);
    }
}

/// w = R^T w
void apply_transposed(const MassRoots& roots, Vector& w)
{
    for (std::size_t m = 0; m < w.size(); ++m) w[m] *= roots.modes[m];
    for (const MassRoots::Rigid& r : roots.rigid) {
        Eigen::Map<Eigen::Vector3d> three(w.data() + r.first_mode);
        three = Eigen::Vector3d(r.root.transpose() * three);
    }
}

} // namespace

double largest_frequency(const StepTables& t, const MassRoots& roots, WallState<double>& s)
{
    const std::size_t n = s.laws.inv_mass.size();
    Vector v = start_vector(n), before(n, 0.0), q(n), w(n);
    scale(1.0 / std::sqrt(dot(v, v)), v);
    Vector diagonal, beside;
    Ritz ritz{std::nan(""), 0.0};
    for (int i = 1; i <= kMostIterations; ++i) {
        apply(roots, v, q);
        apply_stiffness(t, q, s, w);
        apply_transposed(roots, w);
        const double alpha = dot(v, w), last = beside.empty() ? 0.0 : beside.back();
        for (std::size_t m = 0; m < n; ++m) w[m] -= alpha * v[m] + last * before[m];
        diagonal.push_back(alpha);
        beside.push_back(std::sqrt(dot(w, w)));
        if (!std::isfinite(beside.back())) break;
        const bool all = beside.back() <= 1e-14 * std::abs(diagonal.front());
        if (all || i % kRitzEvery == 0) {
            ritz = largest(diagonal, beside);
            if (all || ritz.error <= kTolerance * ritz.value) break;
        }
        before = v;
        v = w;
        scale(1.0 / beside.back(), v);
    }
    s.du.assign(s.du.size(), 0.0);
    s.stress.assign(s.stress.size(), 0.0);
    return std::sqrt(ritz.value);
}

double largest_frequency(const StepTables& t, WallState<double>& s)
{
    MassRoots roots;
    for (const double inverse : s.laws.inv_mass) roots.modes.push_back(std::sqrt(inverse));
    return largest_frequency(t, roots, s);
}

double step_over_limit(const StepTables& t, WallState<double>& s, const SolverOptions& options)
{
    return 0.5 * std::sqrt(1.0 + options.damping_factor) * largest_frequency(t, s);
}

double step_over_limit(const Model& model, const WallMaterials& wall,
                       const SolverOptions& options)
{
    const StepTables tables = step_tables(model);
    WallState<double> state = unloaded<double>(model, tables, {&wall, 1}, options);
    return step_over_limit(tables, state, options);
}

} // namespace dem
