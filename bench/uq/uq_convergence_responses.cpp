#include "bench/uq/uq_convergence.hpp"

#include "uq/marginals/marginal.hpp"

#include <gsl/gsl_cdf.h>

#include <array>
#include <cmath>
#include <numbers>

namespace bench {

namespace {

std::array<uq::Marginal, 5> marginals()
{
    return {uq::Marginal{uq::normal_from_moments(1.0, 0.25)},
            uq::Marginal{uq::normal_from_moments(1.0, 0.25)},
            uq::Marginal{uq::lognormal_from_moments(3.7, 0.30)},
            uq::Marginal{uq::normal_from_moments(35.0, 0.20)},
            uq::Marginal{uq::normal_from_moments(31.8, 0.20)}};
}

const double kLogVariance = std::log1p(0.30 * 0.30); ///< of ft_unit

/// Weighted sum of the standardised variables: standard normal. Weights as Fig. 12 of the paper
/// ranks them: joint friction leads.
Eigen::ArrayXd score(const Eigen::MatrixXd& x)
{
    const Eigen::ArrayXd ln_ft =
        (x.col(2).array().log() - std::log(3.7) + 0.5 * kLogVariance) / std::sqrt(kLogVariance);
    const Eigen::ArrayXd sum = 0.3 * (x.col(0).array() - 1.0) / 0.25 +
                               0.2 * (x.col(1).array() - 1.0) / 0.25 + 0.4 * ln_ft +
                               0.2 * (x.col(3).array() / 35.0 - 1.0) / 0.20 +
                               0.8 * (x.col(4).array() / 31.8 - 1.0) / 0.20;
    return sum / std::sqrt(0.09 + 0.04 + 0.16 + 0.04 + 0.64);
}

constexpr double kLimit = 0.6; ///< of the score: 27 % above

Eigen::VectorXd smooth(const Eigen::MatrixXd& x)
{
    return (1.0 + 0.3 * (x.col(0).array() - 1.0)) * x.col(4).array() / 31.8 +
           0.5 * (x.col(2).array() / 3.7).sqrt() *
               (0.5 * (x.col(3).array() / 35.0 - 1.0)).exp() * (x.col(1).array() - 1.0).cos();
}

Eigen::VectorXd kinked(const Eigen::MatrixXd& x) { return 1.0 + 0.2 * score(x).min(0.0); }

Eigen::VectorXd indicator(const Eigen::MatrixXd& x)
{
    return (score(x) > kLimit).cast<double>();
}

} // namespace

Eigen::MatrixXd table5(const Eigen::MatrixXd& unit_cube)
{
    const auto m = marginals();
    Eigen::MatrixXd x(unit_cube.rows(), 5);
    for (Eigen::Index j = 0; j < 5; ++j)
        for (Eigen::Index i = 0; i < x.rows(); ++i)
            x(i, j) = uq::quantile(m[static_cast<std::size_t>(j)], unit_cube(i, j));
    return x;
}

std::vector<KnownResponse> known_responses()
{
    // E exp(t z) = exp(t^2 / 2); E cos(s z) = exp(-s^2 / 2); E sqrt(f / mean) = exp(-s^2 / 8)
    const double product = std::exp(-kLogVariance / 8.0 + 0.1 * 0.1 / 2.0 - 0.25 * 0.25 / 2.0);
    return {{"smooth", smooth, 1.0 + 0.5 * product},
            {"kinked", kinked, 1.0 - 0.2 / std::sqrt(2.0 * std::numbers::pi)},
            {"indicator", indicator, gsl_cdf_ugaussian_Q(kLimit)}};
}

} // namespace bench
