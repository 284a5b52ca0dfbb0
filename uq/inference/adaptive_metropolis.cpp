#include "uq/inference/adaptive_metropolis.hpp"

#include "core/matrix_factors.hpp"
#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {
namespace {

constexpr double kFirstStep = 0.1;  ///< standard deviation, before anything is learned
constexpr double kForgetting = 0.6; ///< weight of step t is t^-0.6 (Andrieu and Thoms 2008)
constexpr double kRegular = 1e-8;   ///< added to the diagonal of a covariance, relative

/// The walk of one chain and what it has learned.
struct Walker {
    Eigen::VectorXd at;
    double log_density;
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd factor;
    double log_scale = 0.0;
    Stream random;

    Walker(const Eigen::VectorXd& start, double density, std::uint64_t seed, int k)
        : at(start), log_density(density), mean(start),
          covariance(kFirstStep * kFirstStep *
                     Eigen::MatrixXd::Identity(start.size(), start.size())),
          random(seed, static_cast<std::uint64_t>(k), Purpose::markov_chain)
    {
        refactor();
    }

    void refactor()
    {
        Eigen::MatrixXd c = covariance;
        c.diagonal().array() += kRegular * covariance.trace() / static_cast<double>(at.size());
        const auto llt = core::cholesky(c);
        if (llt.info() == Eigen::Success) factor = llt.matrixL();
    }

    /// @return the probability with which the step was accepted
    double step(const LogDensity& f)
    {
        Eigen::VectorXd z(at.size());
        for (double& v : z) v = random.normal();
        const double scale =
            2.38 / std::sqrt(static_cast<double>(at.size())) * std::exp(0.5 * log_scale);
        const Eigen::VectorXd to = at + scale * (factor * z);
        const double there = f(to), u = random.uniform();
        const double chance = std::exp(std::min(0.0, there - log_density));
        if (u < chance) {
            at = to;
            log_density = there;
        }
        return chance;
    }

    void learn(int t, double chance)
    {
        const double aim = at.size() == 1 ? 0.44 : 0.234;
        const double weight = std::pow(t + 1.0, -kForgetting);
        log_scale += weight * (chance - aim);
        const Eigen::VectorXd off = at - mean;
        mean += weight * off;
        covariance += weight * (off * off.transpose() - covariance);
        refactor();
    }
};

void check_metropolis(const Eigen::MatrixXd& starts, const MetropolisOptions& o)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("adaptive metropolis: " + what);
    };
    require(o.chains >= 2, "chains must be at least 2");
    require(o.warm_up >= 100, "warm_up must be at least 100");
    require(o.draws >= 100, "draws must be at least 100");
    require(starts.rows() == o.chains && starts.cols() >= 1,
            "starts must have a row for each chain");
}

} // namespace

std::vector<Chain> adaptive_metropolis(const LogDensity& f, const Eigen::MatrixXd& starts,
                                       const MetropolisOptions& o)
{
    check_metropolis(starts, o);
    std::vector<Chain> chains;
    for (int k = 0; k < o.chains; ++k) {
        const Eigen::VectorXd start = starts.row(k).transpose();
        const double density = f(start);
        if (!std::isfinite(density))
            throw std::invalid_argument("adaptive metropolis: chain " + std::to_string(k) +
                                        " starts where the density is zero");
        Walker w(start, density, o.seed, k);
        for (int t = 0; t < o.warm_up; ++t) w.learn(t, w.step(f));
        Chain c{Eigen::MatrixXd(o.draws, starts.cols()), Eigen::VectorXd(o.draws)};
        for (int t = 0; t < o.draws; ++t) {
            c.acceptance += w.step(f) / o.draws;
            c.draws.row(t) = w.at.transpose();
            c.log_density(t) = w.log_density;
        }
        chains.push_back(std::move(c));
    }
    return chains;
}

} // namespace uq
