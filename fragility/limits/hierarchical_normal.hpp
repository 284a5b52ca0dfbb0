#pragma once
/// Hierarchical normal model of logarithms of test over prediction: walls of one level share an
/// error of the model, repeats of a level scatter about it, and levels about the common mean:
///     y_ij = mu + d_i + e_ij,   d_i ~ N(0, tau^2),   e_ij ~ N(0, s^2)
/// Rubin (1981), J. Educ. Stat. 6, 377-401; Gelman (2006), Bayesian Analysis 1, 515-534 (half-t
/// priors of scales). The posterior is integrated by quadrature, without random numbers.

#include "core/interval.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace fragility {

struct LevelledValue {
    std::size_t level;     ///< values of one level share d; levels count from 0
    double value;          ///< y, such as ln(test / prediction)
    bool at_least = false; ///< right-censored: y is larger
    double error = 0.0; ///< known standard deviation of e; 0: the common s, which is not known
};

/// Prior of tau, and of s: flat on (0, infinity), or half-t with four degrees of freedom, whose
/// mean and standard deviation are its scale. Its tail, unlike that of a half-normal prior,
/// gives way to values that scatter widely. The prior of mu is flat.
struct ScalePrior {
    double half_t = 0.0; ///< scale of the half-t prior; 0: flat
};

/// The joint posterior as weighted points; the weights sum to 1.
struct HierarchicalPosterior {
    struct Point {
        double weight, mu, tau, s;
    };
    std::vector<Point> points; ///< panels of 16, along each of which mu rises
    /// A node of the scatter r = sqrt(tau^2 + s^2), in panels of 16.
    struct Scatter {
        double at; ///< u of r = unit u / (1 - u)
        double weight;
    };
    std::vector<Scatter> scatters;
    double unit = 0.0;
    std::vector<double> level_means; ///< posterior means of mu + d_i
    double mu = 0.0, mu_error = 0.0; ///< mean and standard deviation
    double tau = 0.0, tau_error = 0.0;
    double scatter =
        0.0; ///< root of the mean of tau^2 + s^2: of a new wall of a new level, mu being known
};

/// @throws std::invalid_argument for fewer than three values that are not censored, values that
/// are no numbers, an error below 0, a level
/// without values, values with a known error beside others without, or a flat prior of s or of
/// tau with fewer than three levels
[[nodiscard]] HierarchicalPosterior hierarchical_posterior(std::span<const LevelledValue> data,
                                                           const ScalePrior& prior);

/// Quantile of mu, or of the scatter sqrt(tau^2 + s^2), as exact as the quadrature.
/// @param p in (0, 1)
[[nodiscard]] double mu_quantile(const HierarchicalPosterior& posterior, double p);
[[nodiscard]] double scatter_quantile(const HierarchicalPosterior& posterior, double p);

/// Interval of y of one further wall of a further level.
/// @param confidence in (0, 1)
[[nodiscard]] core::Interval predictive_interval(const HierarchicalPosterior& posterior,
                                                 double confidence);

} // namespace fragility
