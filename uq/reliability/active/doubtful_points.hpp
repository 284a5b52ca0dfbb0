#pragma once
/// Where a Gaussian process of a limit state doubts on which side a point lies.

#include "uq/surrogates/gaussian_process.hpp"

#include <cstdint>
#include <vector>

namespace uq {

/// Points drawn where the event and the doubt about it are, with weights that make means over
/// the standard normal distribution of sums: E f(u) = sum_j weight_j f(u_j).
struct WeighedPoints {
    Eigen::MatrixXd u;
    Eigen::VectorXd weight;   ///< > 0
    Eigen::VectorXd mean;     ///< of the process, unit of g
    Eigen::VectorXd variance; ///< of the process, without its noise
    Eigen::VectorXd passing;  ///< probability that g <= 0, noise included [-]
    double probability = 0.0; ///< sum of weight x passing
    double std_error = 0.0;   ///< of the probability, since the points are few
};

/// Finds the region by subset simulation of the process (Papaioannou et al. 2015), as far as
/// two standard deviations beyond its own limit state, and draws from a mixture of normal
/// densities fitted to it and, one in ten, from the standard normal distribution.
/// @param count >= 100; the points are a function of all that is passed
[[nodiscard]] WeighedPoints weighed_points(const GaussianProcess& g, Eigen::Index count,
                                           std::uint64_t seed);

/// Points to ask next, and their worth.
struct NextPoints {
    Eigen::MatrixXd u;
    double gain; ///< share of the doubt that they take away [-], as the process sees it
};

/// Points one after the other, each of which takes away most of the doubt sum_j weight_j
/// passing_j (1 - passing_j) in expectation (Bect et al. 2012, J4; its closed form: Chevalier
/// et al. 2014). After each the process knows that it will know the point, not what it will be.
/// The last of more than three is the one that the process knows least about, in some direction
/// from the origin, as far out as the doubt.
/// @param count >= 1
[[nodiscard]] NextPoints next_points(const GaussianProcess& g, const WeighedPoints& points,
                                     Eigen::Index count, std::uint64_t seed);

} // namespace uq
