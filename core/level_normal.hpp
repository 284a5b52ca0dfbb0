#pragma once
/// Values of one level that share an unknown: y_j = x + e_j, x ~ N(mu, prior), e_j ~ N(0, v_j).

#include <cmath>

namespace core {

/// Sums over the values of a level.
struct LevelSums {
    double precision = 0.0, sum = 0.0, squares = 0.0, log_scale = 0.0;
    int n = 0;

    /// @param variance of the value, > 0
    void add(double value, double variance)
    {
        ++n;
        precision += 1.0 / variance;
        sum += value / variance;
        squares += value * value / variance;
        log_scale += 0.5 * std::log(variance);
    }
};

/// x given the values, and what remains of their likelihood once x is integrated out:
///   ln p = -n / 2 ln 2 pi - log_scale - ln(shrink) / 2 - misfit / 2
struct LevelNormal {
    double mean, variance; ///< of x
    double shrink;         ///< 1 + prior * precision
    double misfit;         ///< squares about mu, less what x explains
};

[[nodiscard]] inline LevelNormal level_normal(const LevelSums& s, double mu, double prior)
{
    const double shrink = 1.0 + prior * s.precision, off = s.sum - mu * s.precision;
    return {(mu + prior * s.sum) / shrink, prior / shrink, shrink,
            s.squares - 2.0 * mu * s.sum + mu * mu * s.precision - prior * off * off / shrink};
}

} // namespace core
