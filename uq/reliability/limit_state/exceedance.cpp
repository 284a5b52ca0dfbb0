#include "uq/reliability/limit_state/exceedance.hpp"

#include "core/binomial.hpp"
#include "core/critical.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace uq {

double coefficient_of_variation(const Estimate& e)
{
    return e.value > 0.0 ? e.std_error / e.value : std::numeric_limits<double>::infinity();
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
    const auto k = static_cast<double>(passed);
    const double p = k / sound;
    e.estimate.value = p;
    e.estimate.std_error = std::sqrt(p * (1.0 - p) / sound);
    e.lower = k / all;
    e.upper = static_cast<double>(passed + failed) / all;
    constexpr auto kExact = core::BinomialInterval::clopper_pearson;
    e.estimate.interval.lower = core::binomial_interval(kExact, k, all, confidence).lower;
    e.estimate.interval.upper =
        core::binomial_interval(kExact, k + static_cast<double>(failed), all, confidence).upper;
    e.outcome = passed == 0            ? SamplingOutcome::none_passed
                : passed == n - failed ? SamplingOutcome::all_passed
                                       : SamplingOutcome::limit_reached;
    return e;
}

core::Interval log_interval(double value, double std_error, double confidence, double freedom)
{
    const double z = std::isinf(freedom) ? core::normal_factor(confidence)
                                         : core::student_factor(confidence, freedom);
    const double factor = std::exp(z * std::sqrt(std::log1p(std::pow(std_error / value, 2))));
    return {value / factor, std::min(1.0, value * factor), confidence};
}

} // namespace uq
