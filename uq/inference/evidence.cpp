#include "uq/inference/evidence.hpp"

#include "core/matrix_factors.hpp"
#include "uq/designs/stream.hpp"
#include "uq/inference/chain_diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace uq {
namespace {

constexpr int kRounds = 1000;
constexpr double kSettled = 1e-10;

struct NormalDensity {
    Eigen::VectorXd mean;
    Eigen::MatrixXd factor;

    [[nodiscard]] double log(const Eigen::VectorXd& x) const
    {
        const Eigen::VectorXd z = factor.triangularView<Eigen::Lower>().solve(x - mean);
        return -0.5 * (z.squaredNorm() +
                       static_cast<double>(x.size()) * std::log(2.0 * std::numbers::pi)) -
               factor.diagonal().array().log().sum();
    }
};

NormalDensity fitted(const std::vector<Chain>& chains)
{
    const Eigen::Index d = chains.front().draws.cols();
    const Eigen::Index half = chains.front().draws.rows() / 2;
    Eigen::MatrixXd all(half * static_cast<Eigen::Index>(chains.size()), d);
    for (std::size_t k = 0; k < chains.size(); ++k)
        all.middleRows(static_cast<Eigen::Index>(k) * half, half) =
            chains[k].draws.topRows(half);
    NormalDensity g{all.colwise().mean().transpose(), {}};
    const Eigen::MatrixXd off = all.rowwise() - g.mean.transpose();
    const auto llt =
        core::cholesky(off.transpose() * off / static_cast<double>(all.rows() - 1));
    if (llt.info() != Eigen::Success || !(llt.matrixLLT().diagonal().minCoeff() > 0.0))
        throw std::invalid_argument("evidence: the draws have no covariance");
    g.factor = llt.matrixL();
    return g;
}

/// Mean and variance of the mean, of values that have an effective size.
struct Mean {
    double value, relative_variance;
};
Mean mean_of(const Eigen::ArrayXd& y, double effective)
{
    const double m = y.mean(), v = (y - m).square().mean();
    return {m, v / (m * m * effective)};
}

} // namespace

Evidence bridge_evidence(const LogDensity& f, const std::vector<Chain>& chains,
                         std::uint64_t seed)
{
    const NormalDensity g = fitted(chains);
    const Eigen::Index n = chains.front().draws.rows() - chains.front().draws.rows() / 2;
    const auto m = static_cast<Eigen::Index>(chains.size());
    Eigen::MatrixXd drawn(n, m); // ln f - ln g at the draws, a column for each chain
    for (Eigen::Index k = 0; k < m; ++k) {
        const Chain& c = chains[static_cast<std::size_t>(k)];
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::Index row = c.draws.rows() - n + i;
            drawn(i, k) = c.log_density(row) - g.log(c.draws.row(row).transpose());
        }
    }
    Eigen::ArrayXd proposed(n * m);
    for (Eigen::Index i = 0; i < proposed.size(); ++i) {
        Stream random(seed, static_cast<std::uint64_t>(i), Purpose::importance);
        Eigen::VectorXd z(g.mean.size());
        for (double& v : z) v = random.normal();
        const Eigen::VectorXd x = g.mean + g.factor.triangularView<Eigen::Lower>() * z;
        proposed(i) = f(x) - g.log(x);
    }
    const double effective = diagnose(drawn).effective;
    const double all = static_cast<double>(proposed.size());
    const double s1 = effective / (effective + all), s2 = all / (effective + all);
    const Eigen::ArrayXd from = drawn.reshaped().array();
    // over exp(shift): no overflow
    const double shift = from.mean();
    const Eigen::ArrayXd a = (from - shift).exp(), b = (proposed - shift).exp();
    double r = 1.0;
    for (int round = 0; round < kRounds; ++round) {
        const double next = (b / (s1 * b + s2 * r)).mean() / (1.0 / (s1 * a + s2 * r)).mean();
        const bool settled = std::abs(next - r) <= kSettled * next;
        r = next;
        if (settled) break;
    }
    const Mean up = mean_of(b / (s1 * b + s2 * r), all);
    const Mean down = mean_of(1.0 / (s1 * a + s2 * r), effective);
    return {shift + std::log(r), std::sqrt(up.relative_variance + down.relative_variance)};
}

} // namespace uq
