#pragma once
/// Values of one level that share an unknown: y_j = x + e_j, x ~ N(mu, prior), e_j ~ N(0, v_j).
///
/// With x integrated out, ln p = -n / 2 ln 2 pi - log_scale - ln(shrink) / 2 - misfit / 2. The
/// misfit, squares about mu less prior (sum - mu precision)^2 / shrink, is left to the caller.
/// It is a difference: where v_j is below 1e-12 of y_j^2, rounding is all that is left of it.

namespace core {

/// Sums over the values of a level.
struct LevelSums {
    double precision = 0.0; ///< of 1 / v_j
    double sum = 0.0;       ///< of y_j / v_j
    double squares = 0.0;   ///< of y_j^2 / v_j
    double log_scale = 0.0; ///< of ln(v_j) / 2
};

/// x given the values.
struct LevelNormal {
    double mean, variance;
    double shrink; ///< 1 + prior * precision
};

[[nodiscard]] inline LevelNormal level_normal(const LevelSums& s, double mu, double prior)
{
    const double shrink = 1.0 + prior * s.precision;
    return {(mu + prior * s.sum) / shrink, prior / shrink, shrink};
}

} // namespace core
