#include "uq/sensitivity/regression_bootstrap.hpp"

#include "core/moments.hpp"
#include "uq/designs/stream.hpp"
#include "uq/sensitivity/regression_fit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

/// `order`-th part of sorted values, in between linearly.
double percentile(const std::vector<double>& sorted, double p)
{
    const double place = p * static_cast<double>(sorted.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), sorted.size() - 2);
    return sorted[below] +
           (place - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

void set_from(Estimate& e, std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const double tail = 0.5 * (1.0 - e.interval.confidence);
    e.std_error = core::moments(values).sd;
    e.interval.lower = percentile(values, tail);
    e.interval.upper = percentile(values, 1.0 - tail);
}

std::vector<Eigen::Index> resample(const Eigen::VectorXd& y, Stream& stream)
{
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(y.size()));
    bool varies = false;
    while (!varies) {
        for (Eigen::Index& i : rows)
            i = static_cast<Eigen::Index>(stream.below(static_cast<std::uint64_t>(y.size())));
        for (const Eigen::Index i : rows) varies = varies || y[i] != y[rows[0]];
    }
    return rows;
}

} // namespace

void bootstrap_intervals(Regression& r, const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                         const RegressionOptions& options)
{
    if (options.bootstrap < 20)
        throw std::invalid_argument("number of resamples is " +
                                    std::to_string(options.bootstrap) +
                                    ", must be 0 or at least 20");
    const std::size_t d = r.inputs.size();
    std::vector<std::vector<double>> standardised(d), partial(d);
    for (std::uint64_t b = 0; b < options.bootstrap; ++b) {
        Stream stream(options.seed, b, Purpose::bootstrap);
        const std::vector<Eigen::Index> rows = resample(y, stream);
        const RegressionFit f = fit_standardised(x(rows, Eigen::all), y(rows), options.scale);
        for (std::size_t j = 0; j < d; ++j) {
            standardised[j].push_back(f.beta[static_cast<Eigen::Index>(j)]);
            partial[j].push_back(partial_correlation(f, static_cast<Eigen::Index>(j)));
        }
    }
    for (std::size_t j = 0; j < d; ++j) {
        if (!r.inputs[j].identifiable) continue;
        set_from(r.inputs[j].standardised, std::move(standardised[j]));
        set_from(r.inputs[j].partial, std::move(partial[j]));
    }
}

} // namespace uq
