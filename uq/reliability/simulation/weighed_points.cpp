#include "uq/reliability/active/doubtful_points.hpp"
#include "uq/reliability/limit_state/pick.hpp"
#include "uq/reliability/simulation/gaussian_mixture.hpp"
#include "uq/reliability/simulation/subset_simulation_chains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace uq {
namespace {

constexpr std::size_t kLevel = 1000; ///< points of a level, the seeds of the next: a tenth
constexpr int kMostLevels = 14;      ///< down to about 1e-13
constexpr double kBeyond = 2.0;      ///< [standard deviations] of the process and its noise
constexpr double kPlain = 0.1;       ///< share of points from the standard normal distribution

double passing_probability(double mean, double variance)
{
    if (!(variance > 0.0)) return mean <= 0.0 ? 1.0 : 0.0;
    return 0.5 * std::erfc(mean / std::sqrt(2.0 * variance));
}

/// Least value that the process finds likely, as a limit state.
LimitState least_likely_value(const GaussianProcess& g)
{
    LimitState s;
    s.dimension = g.data.x.cols();
    s.model = [&g](const Samples& samples) {
        const ProcessPrediction p = predict(g, samples.x);
        Responses r{p.mean, std::vector<std::string>(samples.id.size())};
        r.y.col(0).array() -= kBeyond * (p.variance.array() + g.parameters.noise).sqrt();
        return r;
    };
    return s;
}

std::vector<Eigen::Index> lowest(const Eigen::VectorXd& g, std::size_t count)
{
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(g.size()));
    std::iota(rows.begin(), rows.end(), Eigen::Index{0});
    std::ranges::stable_sort(rows, {}, [&](Eigen::Index i) { return g(i); });
    rows.resize(count);
    return rows;
}

/// Seeds spread over all that lie at or below zero.
std::vector<Eigen::Index> spread_rows(const Eigen::VectorXd& g, std::size_t count)
{
    const auto below = static_cast<std::size_t>((g.array() <= 0.0).count());
    const std::vector<Eigen::Index> rows = lowest(g, below);
    std::vector<Eigen::Index> some;
    for (std::size_t i = 0; i < count; ++i) some.push_back(rows[i * below / count]);
    return some;
}

/// Points of the standard normal distribution that the process finds likely to pass; the
/// lowest it reaches where it finds none.
Eigen::MatrixXd likely_points(const GaussianProcess& g, std::uint64_t seed)
{
    const LimitState s = least_likely_value(g);
    ChainState state{.seed = seed};
    Ledger unused;
    Population p = first_population(s, kLevel, FailedAs::safe, state, unused);
    for (int level = 1; level < kMostLevels; ++level) {
        const std::vector<Eigen::Index> seeds = lowest(p.g, kLevel / 10);
        const double threshold = p.g(seeds.back());
        if (threshold <= 0.0) break;
        p = next_population(s, p, seeds, threshold, FailedAs::safe, state, unused);
    }
    if (std::cmp_less((p.g.array() <= 0.0).count(), kLevel / 10)) return p.u;
    return next_population(s, p, spread_rows(p.g, kLevel / 10), 0.0, FailedAs::safe, state,
                           unused)
        .u;
}

/// The likely points, taken as often as their doubt and their probability deserve.
Eigen::MatrixXd deserving_points(const GaussianProcess& g, std::uint64_t seed)
{
    const Eigen::MatrixXd u = likely_points(g, seed);
    const ProcessPrediction p = predict(g, u);
    Eigen::VectorXd worth(u.rows());
    for (Eigen::Index i = 0; i < u.rows(); ++i)
        worth(i) =
            std::sqrt(passing_probability(p.mean(i), p.variance(i) + g.parameters.noise));
    if (!(worth.sum() > 0.0)) return u;
    Stream random(seed, 0, Purpose::bootstrap);
    return u(pick_evenly(worth, u.rows(), random), Eigen::all);
}

} // namespace

WeighedPoints weighed_points(const GaussianProcess& g, Eigen::Index count, std::uint64_t seed)
{
    const GaussianMixture near = fit_mixture(deserving_points(g, seed), seed);
    WeighedPoints p{Eigen::MatrixXd(count, g.data.x.cols()),
                    Eigen::VectorXd(count),
                    {},
                    {},
                    Eigen::VectorXd(count),
                    0.0,
                    0.0};
    const auto plain = static_cast<Eigen::Index>(kPlain * static_cast<double>(count));
    const double share = static_cast<double>(plain) / static_cast<double>(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        Stream random(seed, 1 + static_cast<std::uint64_t>(i), Purpose::importance);
        if (i < plain)
            for (double& v : p.u.row(i)) v = random.normal();
        else
            p.u.row(i) = draw(near, random).transpose();
        p.weight(i) =
            1.0 / (static_cast<double>(count) *
                   (share + (1.0 - share) * relative_density(near, p.u.row(i).transpose())));
    }
    ProcessPrediction f = predict(g, p.u);
    p.mean = std::move(f.mean);
    p.variance = std::move(f.variance);
    for (Eigen::Index i = 0; i < count; ++i)
        p.passing(i) = passing_probability(p.mean(i), p.variance(i) + g.parameters.noise);
    const Eigen::ArrayXd part = p.weight.array() * p.passing.array();
    p.probability = part.sum();
    const auto n = static_cast<double>(count);
    p.std_error = std::sqrt((part - part.mean()).square().sum() * n / (n - 1.0));
    return p;
}

} // namespace uq
