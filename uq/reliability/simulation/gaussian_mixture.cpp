#include "uq/reliability/simulation/gaussian_mixture.hpp"

#include "core/eigen_pairs.hpp"
#include "core/matrix_factors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace uq {
namespace {

constexpr int kRounds = 20;           ///< of expectation and maximisation; tuned
constexpr int kMostParts = 8;         ///< tuned
constexpr double kLeastShare = 0.02;  ///< a part with fewer points is dropped; tuned
constexpr double kLeastWeight = 1e-6; ///< added to the diagonal of a covariance while fitting

/// ln of share x density over the standard normal one.
double log_part(const MixturePart& p, const Eigen::VectorXd& u)
{
    const Eigen::VectorXd white = p.factor.triangularView<Eigen::Lower>().solve(u - p.mean);
    return std::log(p.share) - p.factor.diagonal().array().log().sum() -
           0.5 * (white.squaredNorm() - u.squaredNorm());
}

Eigen::VectorXd log_parts(const GaussianMixture& m, const Eigen::VectorXd& u)
{
    Eigen::VectorXd all(static_cast<Eigen::Index>(m.size()));
    for (std::size_t k = 0; k < m.size(); ++k)
        all(static_cast<Eigen::Index>(k)) = log_part(m[k], u);
    return all;
}

double log_sum(const Eigen::VectorXd& logs)
{
    const double most = logs.maxCoeff();
    return most + std::log((logs.array() - most).exp().sum());
}

/// Centres far from each other: each is drawn in proportion to its squared distance from the
/// nearest before it (Arthur and Vassilvitskii 2007).
std::vector<Eigen::Index> far_rows(const Eigen::MatrixXd& u, int parts, Stream& random)
{
    std::vector<Eigen::Index> rows = {
        static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(u.rows())))};
    Eigen::VectorXd nearest =
        Eigen::VectorXd::Constant(u.rows(), std::numeric_limits<double>::infinity());
    while (std::cmp_less(rows.size(), parts)) {
        nearest = nearest.cwiseMin((u.rowwise() - u.row(rows.back())).rowwise().squaredNorm());
        double left = random.uniform() * nearest.sum();
        Eigen::Index i = 0;
        while (i + 1 < u.rows() && left >= nearest(i)) left -= nearest(i++);
        rows.push_back(i);
    }
    return rows;
}

/// Mean and covariance of weighted points; none if there are too few of them.
std::optional<MixturePart> part_of(const Eigen::MatrixXd& u, const Eigen::VectorXd& weight)
{
    const double sum = weight.sum(), share = sum / static_cast<double>(u.rows());
    if (!(share > kLeastShare)) return {};
    MixturePart p{share, u.transpose() * weight / sum, {}};
    const Eigen::MatrixXd off = u.rowwise() - p.mean.transpose();
    Eigen::MatrixXd c = off.transpose() * weight.asDiagonal() * off / sum;
    c.diagonal().array() += kLeastWeight;
    const auto factor = core::cholesky(c);
    if (factor.info() != Eigen::Success) return {};
    p.factor = factor.matrixL();
    return p;
}

GaussianMixture mixture_of(const Eigen::MatrixXd& u, const Eigen::MatrixXd& weights)
{
    GaussianMixture m;
    double all = 0.0;
    for (Eigen::Index k = 0; k < weights.cols(); ++k)
        if (std::optional<MixturePart> p = part_of(u, weights.col(k))) {
            all += p->share;
            m.push_back(std::move(*p));
        }
    for (MixturePart& p : m) p.share /= all;
    return m;
}

GaussianMixture fitted(const Eigen::MatrixXd& u, int parts, std::uint64_t seed)
{
    Stream random(seed, static_cast<std::uint64_t>(parts), Purpose::search);
    const std::vector<Eigen::Index> centres = far_rows(u, parts, random);
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(u.rows(), parts);
    for (Eigen::Index i = 0; i < u.rows(); ++i) {
        Eigen::Index nearest = 0;
        (u(centres, Eigen::all).rowwise() - u.row(i))
            .rowwise()
            .squaredNorm()
            .minCoeff(&nearest);
        weights(i, nearest) = 1.0;
    }
    GaussianMixture m = mixture_of(u, weights);
    for (int round = 0; round < kRounds && m.size() > 1; ++round) {
        weights.resize(u.rows(), static_cast<Eigen::Index>(m.size()));
        for (Eigen::Index i = 0; i < u.rows(); ++i) {
            const Eigen::VectorXd logs = log_parts(m, u.row(i).transpose());
            weights.row(i) = (logs.array() - log_sum(logs)).exp().transpose();
        }
        m = mixture_of(u, weights);
    }
    return m;
}

double mean_log_density(const GaussianMixture& m, const Eigen::MatrixXd& u)
{
    double sum = 0.0;
    for (Eigen::Index i = 0; i < u.rows(); ++i)
        sum += log_sum(log_parts(m, u.row(i).transpose()));
    return sum / static_cast<double>(u.rows());
}

/// Covariance as fit_mixture promises.
void widen(MixturePart& p, double points)
{
    const auto d = static_cast<double>(p.mean.size());
    const double noise = std::sqrt(d / std::max(1.0, points));
    const double low = std::pow(std::max(0.0, 1.0 - noise), 2), high = std::pow(1.0 + noise, 2);
    auto [vectors, variance] = core::eigen_pairs(p.factor * p.factor.transpose());
    for (double& v : variance)
        v = v > low && v < high ? 1.0 : std::max(v, std::min(1.0, 4.0 * v));
    p.factor = core::cholesky(vectors * variance.asDiagonal() * vectors.transpose()).matrixL();
}

} // namespace

GaussianMixture fit_mixture(const Eigen::MatrixXd& u, std::uint64_t seed)
{
    const Eigen::Index half = u.rows() / 2;
    int best = 1;
    double most = -std::numeric_limits<double>::infinity();
    for (int parts = 1; parts <= kMostParts && half >= 10 * parts; parts *= 2) {
        const GaussianMixture m = fitted(u.topRows(half), parts, seed);
        const double density = m.empty() ? most : mean_log_density(m, u.bottomRows(half));
        if (!(density > most)) continue;
        most = density;
        best = parts;
    }
    GaussianMixture m = fitted(u, best, seed);
    if (m.empty()) m = mixture_of(u, Eigen::MatrixXd::Ones(u.rows(), 1));
    for (MixturePart& p : m) widen(p, p.share * static_cast<double>(u.rows()));
    return m;
}

Eigen::VectorXd draw(const GaussianMixture& m, Stream& random)
{
    double left = random.uniform();
    std::size_t k = 0;
    while (k + 1 < m.size() && left >= m[k].share) left -= m[k++].share;
    Eigen::VectorXd z(m[k].mean.size());
    for (double& v : z) v = random.normal();
    return m[k].mean + m[k].factor.triangularView<Eigen::Lower>() * z;
}

double relative_density(const GaussianMixture& m, const Eigen::VectorXd& u)
{
    return std::exp(log_sum(log_parts(m, u)));
}

} // namespace uq
