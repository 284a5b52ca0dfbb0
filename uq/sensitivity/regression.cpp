#include "uq/sensitivity/regression.hpp"

#include "core/critical.hpp"
#include "uq/sensitivity/correlation_measures.hpp"
#include "uq/sensitivity/regression_bootstrap.hpp"
#include "uq/sensitivity/regression_fit.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

/// Delta method: what each sample moves the coefficient by, through the regression and through
/// the two sampled standard deviations.
double standardised_error(const RegressionFit& f, Eigen::Index j)
{
    const auto n = static_cast<double>(f.y.size());
    const Eigen::ArrayXd moved =
        n * f.inverse.row(j).transpose().array() * f.residual.array() +
        0.5 * f.beta[j] * (f.x.col(j).array().square() - f.y.array().square());
    const double freedom = n - 1.0 - static_cast<double>(f.rank);
    return std::sqrt(moved.square().sum() / (n * freedom));
}

/// `extra`: what the variance of the partial coefficient's z grows by with r^2.
RegressionCoefficient coefficient(const RegressionFit& f, Eigen::Index j, double extra,
                                  std::size_t failed, double confidence)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto n = static_cast<std::size_t>(f.y.size());
    const bool identifiable = std::abs(f.inverse.row(j).dot(f.x.col(j)) - 1.0) < 1e-6;
    if (!identifiable)
        return {{f.beta[j], infinite, n, failed, {-infinite, infinite, confidence}},
                {0.0, infinite, n, failed, {-1.0, 1.0, confidence}},
                false};
    const double freedom = static_cast<double>(f.y.size()) - 1.0 - static_cast<double>(f.rank);
    const double error = standardised_error(f, j),
                 half = core::student_factor(confidence, freedom) * error;
    const double r = partial_correlation(f, j),
                 z_error = std::sqrt((1.0 + extra * r * r) / (freedom - 1.0));
    return {{f.beta[j], error, n, failed, {f.beta[j] - half, f.beta[j] + half, confidence}},
            {r, (1.0 - r * r) * z_error, n, failed, fisher_interval(r, z_error, confidence)},
            true};
}

} // namespace

std::optional<Regression> regress(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                  const RegressionOptions& options)
{
    core::check_confidence(options.confidence);
    const SoundRows rows = sound_rows(x, y);
    if (rows.y.size() < x.cols() + 4)
        throw std::invalid_argument("a regression on " + std::to_string(x.cols()) +
                                    " inputs needs at least " + std::to_string(x.cols() + 4) +
                                    " sound samples, got " + std::to_string(rows.y.size()));
    if (rows.y.maxCoeff() == rows.y.minCoeff()) return {};
    const RegressionFit f = fit_standardised(rows.x, rows.y, options.scale);
    const auto n = static_cast<double>(f.y.size());
    Regression r{{},
                 1.0 - f.residual.squaredNorm() / n,
                 f.rank,
                 static_cast<std::size_t>(f.y.size()),
                 rows.failed};
    const double extra = options.scale == RegressionScale::ranks ? kRankVariance : 0.0;
    for (Eigen::Index j = 0; j < x.cols(); ++j)
        r.inputs.push_back(coefficient(f, j, extra, rows.failed, options.confidence));
    if (options.bootstrap > 0) bootstrap_intervals(r, rows.x, rows.y, options);
    return r;
}

} // namespace uq
