#include "uq/reliability/design_point/sorm.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace uq {

namespace {

using Complex = std::complex<double>;

/// Derivative of the exponent s^2/2 - s beta - sum log(1 + s kappa)/2 - log s: rises with s.
double slope(double s, double beta, const Eigen::VectorXd& kappa)
{
    return s - beta - 1.0 / s - (0.5 * kappa.array() / (1.0 + s * kappa.array())).sum();
}

/// Largest real s the integrand can have: at the first branch point.
double right_end(const Eigen::VectorXd& kappa)
{
    const double least = kappa.size() > 0 ? kappa.minCoeff() : 0.0;
    return least < 0.0 ? -1.0 / least : std::numeric_limits<double>::infinity();
}

/// Where the exponent is least between the pole at 0 and the first branch point.
double saddle_point(double beta, const Eigen::VectorXd& kappa)
{
    double low = 0.0, high = right_end(kappa);
    if (!std::isfinite(high))
        for (high = 1.0; slope(high, beta, kappa) < 0.0;) high *= 2.0;
    for (int i = 0; i < 100; ++i) { // bisection: to rounding, and safe next to the ends
        const double middle = 0.5 * (low + high);
        (slope(middle, beta, kappa) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

Complex exponent(Complex s, double beta, const Eigen::VectorXd& kappa)
{
    Complex sum = 0.5 * s * s - s * beta - std::log(s);
    for (const double k : kappa) sum -= 0.5 * std::log(1.0 + s * k);
    return sum;
}

} // namespace

double paraboloid_probability(double beta, const Eigen::VectorXd& kappa)
{
    if (!std::isfinite(beta) || !kappa.allFinite())
        throw std::invalid_argument("paraboloid: beta and curvatures must be finite");
    if (beta < 0.0) return 1.0 - paraboloid_probability(-beta, -kappa);
    const double s = saddle_point(beta, kappa);
    // The trapezoidal rule errs by exp(-2 pi w / h), w the distance to the nearest singularity.
    const double width = std::min(s, right_end(kappa) - s);
    const double h = std::min(0.25, width) / 6.0;
    const double top = exponent(s, beta, kappa).real();
    double sum = 0.5;
    for (double t = h;; t += h) {
        const Complex e = exponent({s, t}, beta, kappa) - top;
        sum += (std::exp(e)).real();
        if (e.real() < -40.0) break;
    }
    return std::exp(top) * sum * h / std::numbers::pi;
}

} // namespace uq
