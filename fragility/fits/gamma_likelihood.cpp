#include "fragility/fits/gamma_likelihood.hpp"

#include "core/gauss_legendre.hpp"

#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>

#include <algorithm>
#include <cmath>

namespace fragility {
namespace {

constexpr double kDrop = 45.0; ///< of the log density: less than rounding remains outside

/// Sums of w exp(phi - top) times powers of s - origin and e^s - e^origin.
struct Sums {
    double one = 0.0, s = 0.0, ss = 0.0, e = 0.0, ee = 0.0, se = 0.0;
};

/// In d = s - origin: far out in the tail its steps are smaller than the rounding of s.
class LogGammaDensity {
  public:
    LogGammaDensity(double a, double origin) : a_(a), origin_(origin), exp_(std::exp(origin)) {}

    /// From the highest point outwards to `end`, as far as it matters.
    void integrate(double end, Sums& sums) const
    {
        const double last = end - origin_;
        const double sign = last > 0.0 ? 1.0 : -1.0;
        double d = 0.0;
        while (d != last && fall(d) > -kDrop) {
            const double s = origin_ + d;
            const double e = std::exp(sign > 0.0 ? s + 0.5 : s);
            double width = 4.0 / (std::abs(a_ - std::exp(s)) + 2.0 * std::sqrt(e));
            if (sign > 0.0) width = std::min(width, 0.5);
            const double next = std::abs(last - d) <= width ? last : d + sign * width;
            panel(std::min(d, next), std::max(d, next), sums);
            d = next;
        }
    }
    [[nodiscard]] double origin() const { return origin_; }
    [[nodiscard]] double top() const { return a_ * origin_ - exp_; }

  private:
    /// phi - top, phi = a s - e^s.
    [[nodiscard]] double fall(double d) const { return a_ * d - exp_ * std::expm1(d); }
    void point(double d, double weight, Sums& sums) const
    {
        const double p = weight * std::exp(fall(d));
        const double de = exp_ * std::expm1(d);
        sums.one += p;
        sums.s += p * d;
        sums.ss += p * d * d;
        sums.e += p * de;
        sums.ee += p * de * de;
        sums.se += p * d * de;
    }
    void panel(double lo, double hi, Sums& sums) const
    {
        const double middle = 0.5 * (lo + hi);
        const double half = 0.5 * (hi - lo);
        for (std::size_t i = 0; i < core::kGauss16.node.size(); ++i) {
            const double x = half * core::kGauss16.node[i];
            point(middle + x, half * core::kGauss16.weight[i], sums);
            point(middle - x, half * core::kGauss16.weight[i], sums);
        }
    }
    double a_, origin_, exp_;
};

/// Derivatives for the shape a and the shift of s.
struct ShapeShift {
    double value, a, s, aa, as, ss;
};

ShapeShift observed_term(double shape, double s)
{
    const double e = std::exp(s);
    return {shape * s - e - std::lgamma(shape),
            s - boost::math::digamma(shape),
            shape - e,
            -boost::math::trigamma(shape),
            1.0,
            -e};
}

/// A shift of both ends is one of the variable of integration.
ShapeShift censored_term(double shape, double lo, double hi)
{
    const LogGammaMoments m = log_gamma_moments(shape, lo, hi);
    return {m.log_integral - std::lgamma(shape),
            m.mean - boost::math::digamma(shape),
            shape - m.mean_exp,
            m.variance - boost::math::trigamma(shape),
            1.0 - m.covariance,
            m.variance_exp - m.mean_exp};
}

} // namespace

LogGammaMoments log_gamma_moments(double a, double lo, double hi)
{
    const LogGammaDensity density(a, std::clamp(std::log(a), lo, hi));
    Sums sums;
    density.integrate(hi, sums);
    density.integrate(lo, sums);
    const double s = sums.s / sums.one;
    const double e = sums.e / sums.one;
    return {density.top() + std::log(sums.one), density.origin() + s,
            sums.ss / sums.one - s * s,         std::exp(density.origin()) + e,
            sums.ee / sums.one - e * e,         sums.se / sums.one - s * e};
}

Likelihood gamma_term(const Working& theta, double lo, double hi)
{
    const double a = std::exp(-2.0 * theta[1]); // 1 / cv^2
    const double log_scale = theta[0] + 2.0 * theta[1];
    const ShapeShift t = lo == hi ? observed_term(a, lo - log_scale)
                                  : censored_term(a, lo - log_scale, hi - log_scale);
    // a' = -2 a, a'' = 4 a for ln cv; s' = -1 for ln mean, -2 for ln cv
    Likelihood l;
    l.value = t.value;
    l.gradient << -t.s, -2.0 * a * t.a - 2.0 * t.s;
    const double mixed = 2.0 * a * t.as + 2.0 * t.ss;
    l.hessian << t.ss, mixed, mixed,
        4.0 * a * a * t.aa + 8.0 * a * t.as + 4.0 * t.ss + 4.0 * a * t.a;
    return l;
}

} // namespace fragility
