#include "fragility/fits/fit_intervals.hpp"

#include "core/fit_factors.hpp"
#include "core/interval.hpp"
#include "fragility/fits/gamma_likelihood.hpp"
#include "fragility/laws/standard_law.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fragility {
namespace {

constexpr double kFurthest = 40.0; ///< end of the search [standard errors]

void check(const Fit& fit, double confidence)
{
    if (fit.outcome != FitOutcome::converged)
        throw std::invalid_argument("interval: the fit has not converged: " + fit.reason);
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("interval: confidence must be in (0, 1), is " +
                                    std::to_string(confidence));
}

double standard_quantile(const Distribution& d, double p)
{
    return d.law == Law::weibull ? SmallestExtreme::quantile(p) : StandardNormal::quantile(p);
}

bool logarithmic(const Distribution& d, Quantity q)
{
    return q.kind == Quantity::Kind::dispersion ||
           (q.kind == Quantity::Kind::quantile && positive(d.law));
}

/// The quantity on its axis.
double on_axis(const Distribution& d, Quantity q)
{
    const double x = value(d, q);
    return logarithmic(d, q) ? std::log(x) : x;
}

/// Derivatives of on_axis for (location, ln dispersion).
Eigen::Vector2d gradient(const Distribution& d, Quantity q)
{
    if (q.kind == Quantity::Kind::location) return {1.0, 0.0};
    if (q.kind == Quantity::Kind::dispersion) return {0.0, 1.0};
    if (d.law != Law::gamma) return {1.0, d.dispersion * standard_quantile(d, q.p)};
    // ln F at the quantile does not change: d ln x / d theta = - F_theta / F_lnx
    const Likelihood below = gamma_term(working(d), -core::kInfinity, std::log(value(d, q)));
    const double slope = -below.gradient[0]; // ln x and -ln mean are one
    return {1.0, -below.gradient[1] / slope};
}

/// Location that puts the quantity at `target` (on its axis) with this dispersion.
double location_for(Law law, Quantity q, double target, double dispersion)
{
    const Distribution d{law, 0.0, dispersion};
    return target - on_axis(d, q); // every location shifts the axis of quantiles
}

/// Largest log-likelihood with the quantity held.
class Profile {
  public:
    Profile(const Fit& fit, std::span<const Observation> data, Quantity q)
        : sample_(prepare(fit.law.law, data)), q_(q),
          best_(working(fit.law)), spread_{std::sqrt(fit.covariance(0, 0)),
                                           std::sqrt(fit.covariance(1, 1))}
    {
    }

    [[nodiscard]] double operator()(double target) const
    {
        const bool free_location = q_.kind == Quantity::Kind::dispersion;
        const auto negative = [&](double free) {
            Working theta(free, target);
            if (q_.kind == Quantity::Kind::location) theta = {target, free};
            if (q_.kind == Quantity::Kind::quantile)
                theta = {location_for(sample_.law, q_, target, std::exp(free)), free};
            const double l = log_likelihood(sample_, theta).value;
            return std::isfinite(l) ? -l : 1e300;
        };
        const double middle = free_location ? best_[0] : best_[1];
        const double unit = free_location ? spread_[0] : spread_[1];
        return -smallest(negative, middle, unit);
    }

  private:
    /// Least value of a function with one minimum: goes downhill from the middle until it is
    /// bracketed.
    template <class F> static double smallest(F f, double middle, double unit)
    {
        double lo = middle - unit;
        double hi = middle + unit;
        double at = f(middle);
        double left = f(lo);
        double right = f(hi);
        for (double step = 2.0 * unit; left < at && step < 1e4 * unit; step *= 2.0) {
            hi = middle, right = at, middle = lo, at = left;
            left = f(lo -= step);
        }
        for (double step = 2.0 * unit; right < at && step < 1e4 * unit; step *= 2.0) {
            lo = middle, left = at, middle = hi, at = right;
            right = f(hi += step);
        }
        return boost::math::tools::brent_find_minima(f, lo, hi, 26).second;
    }

    CensoredSample sample_;
    Quantity q_;
    Working best_;
    std::array<double, 2> spread_;
};

/// Where the profile has fallen by `drop`, going by `step` (signed, a standard error).
double profile_end(const Profile& profile, double start, double top, double drop, double step)
{
    const auto excess = [&](double t) { return profile(t) - top + drop; };
    double inside = start;
    double outside = start + step;
    double f_inside = drop;
    double f_outside = excess(outside);
    while (f_outside > 0.0) {
        if (std::abs(outside - start) > kFurthest * std::abs(step))
            return step > 0.0 ? core::kInfinity : -core::kInfinity;
        inside = outside;
        f_inside = f_outside;
        outside += 0.5 * (outside - start);
        f_outside = excess(outside);
    }
    std::uintmax_t iterations = 60;
    const auto done = [&](double a, double b) {
        return std::abs(b - a) < 1e-9 * std::abs(step);
    };
    const bool up = inside < outside;
    const auto root = boost::math::tools::toms748_solve(
        excess, up ? inside : outside, up ? outside : inside, up ? f_inside : f_outside,
        up ? f_outside : f_inside, done, iterations);
    return 0.5 * (root.first + root.second);
}

} // namespace

double value(const Distribution& d, Quantity q)
{
    switch (q.kind) {
    case Quantity::Kind::location:
        return d.location;
    case Quantity::Kind::dispersion:
        return d.dispersion;
    case Quantity::Kind::quantile:
        break;
    }
    return quantile(d, q.p);
}

Uncertain uncertain(const Fit& fit, Quantity q)
{
    check(fit, 0.5);
    const Eigen::Vector2d g = gradient(fit.law, q);
    return {value(fit.law, q), std::sqrt(g.dot(fit.covariance * g)), logarithmic(fit.law, q)};
}

core::Interval profile_interval(const Fit& fit, std::span<const Observation> data, Quantity q,
                                double confidence)
{
    check(fit, confidence);
    const Profile profile(fit, data, q);
    const Uncertain u = uncertain(fit, q);
    const double z = core::fit_normal_factor(confidence);
    const double start = on_axis(fit.law, q);
    const auto end = [&](double sign) {
        const double t = profile_end(profile, start, fit.log_likelihood, 0.5 * z * z,
                                     sign * z * u.axis_error);
        return u.logarithmic ? std::exp(t) : t;
    };
    return {end(-1.0), end(1.0), confidence};
}

} // namespace fragility
