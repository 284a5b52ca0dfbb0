#include "uq/reliability/exceedance.hpp"

#include "uq/marginals/boost_quantiles.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace uq {

namespace {

void check_confidence(double confidence)
{
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("confidence is " + std::to_string(confidence) +
                                    ", must be in (0, 1)");
}

} // namespace

double coefficient_of_variation(const Estimate& e)
{
    return e.value > 0.0 ? e.std_error / e.value : std::numeric_limits<double>::infinity();
}

Interval binomial_interval(std::size_t successes, std::size_t n, double confidence)
{
    check_confidence(confidence);
    if (n < 1 || successes > n)
        throw std::invalid_argument("binomial interval: " + std::to_string(successes) + " of " +
                                    std::to_string(n) + " is not a share");
    const double tail = 0.5 * (1.0 - confidence);
    const auto k = static_cast<double>(successes), all = static_cast<double>(n);
    return {successes == 0 ? 0.0 : beta_quantile(k, all - k + 1.0, tail),
            successes == n ? 1.0 : upper_beta_quantile(k + 1.0, all - k, tail), confidence};
}

Exceedance count_exceedance(std::size_t passed, std::size_t failed, std::size_t n,
                            double confidence)
{
    Exceedance e;
    e.estimate.interval = {0.0, 1.0, confidence};
    e.estimate.failed = failed;
    e.estimate.n = n - failed;
    if (n == failed) return e;
    const auto sound = static_cast<double>(n - failed), all = static_cast<double>(n);
    const double p = static_cast<double>(passed) / sound;
    e.estimate.value = p;
    e.estimate.std_error = std::sqrt(p * (1.0 - p) / sound);
    e.lower = static_cast<double>(passed) / all;
    e.upper = static_cast<double>(passed + failed) / all;
    e.estimate.interval.lower = binomial_interval(passed, n, confidence).lower;
    e.estimate.interval.upper = binomial_interval(passed + failed, n, confidence).upper;
    e.outcome = passed == 0            ? SamplingOutcome::none_passed
                : passed == n - failed ? SamplingOutcome::all_passed
                                       : SamplingOutcome::limit_reached;
    return e;
}

Interval log_interval(double value, double std_error, double confidence)
{
    check_confidence(confidence);
    const double z = gsl_cdf_ugaussian_Qinv(0.5 * (1.0 - confidence));
    const double factor = std::exp(z * std::sqrt(std::log1p(std::pow(std_error / value, 2))));
    return {value / factor, std::min(1.0, value * factor), confidence};
}

} // namespace uq
