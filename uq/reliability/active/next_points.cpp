#include "uq/reliability/active/doubtful_points.hpp"
#include "uq/reliability/limit_state/pick.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace uq {
namespace {

constexpr Eigen::Index kCandidates = 300; ///< tuned: more of them gain nothing
constexpr Eigen::Index kExplored = 200;   ///< directions looked at
constexpr Eigen::Index kFewPoints = 4;    ///< that leave none for exploring

/// passing (1 - passing) less its expectation once a share r of the variance is known:
///
///   (1 / 2 pi) int_0^asin(r) exp(-a^2 / (1 + sin t)) dt,   a = mean / standard deviation
///
/// by three points of Gauss and Legendre.
double taken_away(double a2, double r)
{
    constexpr std::array<double, 3> kAt = {0.1127016653792583, 0.5, 0.8872983346207417};
    constexpr std::array<double, 3> kWeight = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    const double end = std::asin(std::clamp(r, 0.0, 1.0));
    double sum = 0.0;
    for (std::size_t k = 0; k < kAt.size(); ++k)
        sum += kWeight[k] * std::exp(-a2 / (1.0 + std::sin(end * kAt[k])));
    return sum * end / (2.0 * std::numbers::pi);
}

/// Some of the points, each with the same share of the doubt.
struct Candidates {
    Eigen::MatrixXd u;
    Eigen::VectorXd mean;
    Eigen::VectorXd doubt;      ///< passing (1 - passing), > 0
    Eigen::MatrixXd covariance; ///< of the process, given what is asked already
    double noise;
    double least; ///< variance below which all is rounding
};

Candidates candidates(const GaussianProcess& g, const WeighedPoints& p, Stream& random)
{
    const Eigen::ArrayXd doubt = p.passing.array() * (1.0 - p.passing.array());
    const Eigen::VectorXd share = p.weight.array() * doubt;
    if (!(share.sum() > 0.0)) return {};
    const std::vector<Eigen::Index> rows = pick_evenly(share, kCandidates, random);
    Candidates c{p.u(rows, Eigen::all), p.mean(rows),
                 doubt(rows),           {},
                 g.parameters.noise,    1e-12 * g.parameters.variance};
    c.covariance = predict_covariance(g, c.u);
    return c;
}

/// Share of the doubt that each candidate would take away.
Eigen::VectorXd gains(const Candidates& c)
{
    const Eigen::Index n = c.mean.size();
    Eigen::VectorXd gain = Eigen::VectorXd::Zero(n);
    const Eigen::ArrayXd variance = (c.covariance.diagonal().array() + c.noise).max(c.least);
    for (Eigen::Index j = 0; j < n; ++j) {
        const double a2 = c.mean(j) * c.mean(j) / variance(j);
        for (Eigen::Index i = 0; i < n; ++i) {
            const double r =
                c.covariance(i, j) * c.covariance(i, j) / (variance(i) * variance(j));
            gain(i) += taken_away(a2, r) / c.doubt(j);
        }
    }
    return gain / static_cast<double>(n);
}

/// Leaves the covariance that remains once candidate `i` is known.
void know(Candidates& c, Eigen::Index i)
{
    const double variance = c.covariance(i, i) + c.noise;
    if (!(variance > c.least)) return;
    const Eigen::VectorXd column = c.covariance.col(i);
    c.covariance -= column * column.transpose() / variance;
    c.covariance.diagonal() = c.covariance.diagonal().cwiseMax(0.0).eval();
}

/// The least known of some directions, as far out as one of the points.
Eigen::RowVectorXd least_known(const GaussianProcess& g, const Eigen::MatrixXd& doubtful,
                               Stream& random)
{
    Eigen::MatrixXd u(kExplored, g.data.x.cols());
    for (Eigen::Index i = 0; i < u.rows(); ++i) {
        for (double& v : u.row(i)) v = random.normal();
        const auto k = random.below(static_cast<std::uint64_t>(doubtful.rows()));
        u.row(i) *= doubtful.row(static_cast<Eigen::Index>(k)).norm() / u.row(i).norm();
    }
    Eigen::Index least = 0;
    predict(g, u).variance.maxCoeff(&least);
    return u.row(least);
}

} // namespace

NextPoints next_points(const GaussianProcess& g, const WeighedPoints& points,
                       Eigen::Index count, std::uint64_t seed)
{
    Stream random(seed, 1, Purpose::bootstrap);
    Candidates c = candidates(g, points, random);
    NextPoints next{Eigen::MatrixXd(count, g.data.x.cols()), 0.0};
    if (c.mean.size() == 0) { // no doubt at all
        for (Eigen::Index k = 0; k < count; ++k)
            next.u.row(k) = least_known(g, points.u, random);
        return next;
    }
    const Eigen::Index explored = count < kFewPoints ? 0 : 1;
    for (Eigen::Index k = 0; k < count - explored; ++k) {
        Eigen::Index best = 0;
        next.gain += gains(c).maxCoeff(&best);
        next.u.row(k) = c.u.row(best);
        know(c, best);
    }
    for (Eigen::Index k = count - explored; k < count; ++k)
        next.u.row(k) = least_known(g, c.u, random);
    next.gain = std::min(next.gain, 1.0);
    return next;
}

} // namespace uq
