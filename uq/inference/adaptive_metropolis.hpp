#pragma once
/// Draws from a density that is known up to a factor, by a random walk that learns its steps.

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace uq {

/// ln of a density over R^d, up to a constant; minus infinity where it is zero, never NaN.
using LogDensity = std::function<double(const Eigen::VectorXd&)>;

struct MetropolisOptions {
    int chains = 4;     ///< >= 2, so that they can be compared
    int warm_up = 5000; ///< steps of each chain in which its steps are learned, >= 100
    int draws = 10000;  ///< of each chain that are kept, >= 100
    std::uint64_t seed = 1;
};

struct Chain {
    Eigen::MatrixXd draws;       ///< rows
    Eigen::VectorXd log_density; ///< of each row
    double acceptance = 0.0;     ///< of the steps that are kept [-]
};

/// Steps have 2.38^2 / d times the covariance of the past of their chain and a scale that aims
/// at an acceptance of 0.234, 0.44 in one dimension (Haario, Saksman, Tamminen 2001; Andrieu
/// and Thoms 2008, algorithm 4), learned in the warm-up alone: what is kept is a Markov chain.
/// Chain k has random numbers of its own, a function of seed and k.
/// @param starts a row for each chain, of finite density; apart from each other, else the
/// comparison of chains says nothing
/// @throws std::invalid_argument naming what is out of range
[[nodiscard]] std::vector<Chain> adaptive_metropolis(const LogDensity& log_density,
                                                     const Eigen::MatrixXd& starts,
                                                     const MetropolisOptions& o = {});

} // namespace uq
