#include "fragility/fits/share.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fragility {

Share share(double count, double n, double failed, core::BinomialInterval kind,
            double confidence, const Undecided& undecided)
{
    if (!(failed >= 0.0 && std::isfinite(failed)))
        throw std::invalid_argument("share: failed walls must be >= 0, are " +
                                    std::to_string(failed));
    Share s{count, n, failed, 0.0, {0.0, 1.0, confidence}};
    if (n == 0.0 && count == 0.0) return s;
    if (!(count <= n))
        throw std::invalid_argument("share: " + std::to_string(count) + " of " +
                                    std::to_string(n) + " walls is no share");
    const auto& [of_this, of_other] = undecided;
    if (!(of_this >= 0.0 && of_this <= count && of_other >= 0.0 && of_other <= n - count))
        throw std::invalid_argument("share: " + std::to_string(of_this) + " and " +
                                    std::to_string(of_other) + " undecided walls are not " +
                                    "among the " + std::to_string(n));
    s.value = count / n;
    const double all = n + failed, most = count + of_other + failed;
    s.interval.lower = core::binomial_interval(kind, count - of_this, all, confidence).lower;
    s.interval.upper = core::binomial_interval(kind, most, all, confidence).upper;
    return s;
}

} // namespace fragility
