#pragma once
/// A mixture of normal densities fitted to points, to draw more like them.

#include "uq/designs/stream.hpp"

#include <Eigen/Core>

#include <vector>

namespace uq {

struct MixturePart {
    double share; ///< of the points [-]; the shares add up to 1
    Eigen::VectorXd mean;
    Eigen::MatrixXd factor; ///< lower, of the covariance
};

using GaussianMixture = std::vector<MixturePart>;

/// One, two, four or eight parts, as points that were kept apart ask for, by expectation and
/// maximisation (Dempster, Laird, Rubin 1977). The covariances are those of points of a
/// standard normal population cut by a limit state: variances that the number of points cannot
/// tell from 1 are 1 (Marchenko and Pastur 1967), and smaller ones are widened to twice their
/// standard deviation, so that no weight of what is drawn grows in the tail.
/// @param u rows are points, at least two
[[nodiscard]] GaussianMixture fit_mixture(const Eigen::MatrixXd& u, std::uint64_t seed);

[[nodiscard]] Eigen::VectorXd draw(const GaussianMixture& mixture, Stream& random);

/// Density over that of the standard normal distribution.
[[nodiscard]] double relative_density(const GaussianMixture& mixture, const Eigen::VectorXd& u);

} // namespace uq
