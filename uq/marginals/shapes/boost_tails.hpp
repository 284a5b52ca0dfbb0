#pragma once
/// Tails by Boost.Math (in long double), their inverses polished.

#include <boost/math/policies/policy.hpp>

#include <cmath>
#include <limits>

namespace uq::boost_tails {

namespace bm = boost::math;
using bm::policies::ignore_error;

/// Nothing throws: ends of the support are met as 0 and infinity.
constexpr bm::policies::policy<
    bm::policies::domain_error<ignore_error>, bm::policies::pole_error<ignore_error>,
    bm::policies::overflow_error<ignore_error>, bm::policies::evaluation_error<ignore_error>>
    kQuiet{};

/// Newton for ln tail(x) = ln p over ln x: exact where the tail is a power of x.
/// @param tail P, @param slope dP/dx; of x
template <class Tail, class Slope> double solved(double x, double p, Tail tail, Slope slope)
{
    constexpr int kSteps = 100; // 3 do from a start good to half the digits
    for (int i = 0; i < kSteps; ++i) {
        const double value = tail(x);
        const double step = std::log(value / p) * (value / (x * slope(x)));
        if (!std::isfinite(step)) break; // x is 0 or beyond what double holds
        x *= std::exp(-step);
        if (std::abs(step) < 4.0 * std::numeric_limits<double>::epsilon()) break;
    }
    return x;
}

} // namespace uq::boost_tails
