#include "core/normal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace core {

namespace {

constexpr double kCentral = 0.425; ///< |p - 1/2| up to which no logarithm is needed
constexpr double kFar = 5.0;       ///< sqrt(-ln of the tail), beyond exp(-25) = 1.4e-11

/// Four values side by side; lanes never meet, so that each has the bits it has alone.
using Lanes = double __attribute__((vector_size(4 * sizeof(double))));

using Coefficients = std::array<double, 8>; ///< of a polynomial, ascending

// Named as in the paper: quotients a / b, c / d, e / f.
constexpr Coefficients kA{3.3871328727963666080e0, 1.3314166789178437745e2,
                          1.9715909503065514427e3, 1.3731693765509461125e4,
                          4.5921953931549871457e4, 6.7265770927008700853e4,
                          3.3430575583588128105e4, 2.5090809287301226727e3};
constexpr Coefficients kB{1.0,
                          4.2313330701600911252e1,
                          6.8718700749205790830e2,
                          5.3941960214247511077e3,
                          2.1213794301586595867e4,
                          3.9307895800092710610e4,
                          2.8729085735721942674e4,
                          5.2264952788528545610e3};
constexpr Coefficients kC{1.42343711074968357734e0,  4.63033784615654529590e0,
                          5.76949722146069140550e0,  3.64784832476320460504e0,
                          1.27045825245236838258e0,  2.41780725177450611770e-1,
                          2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr Coefficients kD{1.0,
                          2.05319162663775882187e0,
                          1.67638483018380384940e0,
                          6.89767334985100004550e-1,
                          1.48103976427480074590e-1,
                          1.51986665636164571966e-2,
                          5.47593808499534494600e-4,
                          1.05075007164441684324e-9};
constexpr Coefficients kE{6.65790464350110377720e0,  5.46378491116411436990e0,
                          1.78482653991729133580e0,  2.96560571828504891230e-1,
                          2.65321895265761230930e-2, 1.24266094738807843860e-3,
                          2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr Coefficients kF{1.0,
                          5.99832206555887937690e-1,
                          1.36929880922735805310e-1,
                          1.48753612908506148525e-2,
                          7.86869131145613259100e-4,
                          1.84631831751005468180e-5,
                          1.42151175831644588870e-7,
                          2.04426310338993978564e-15};

template <class Real> Real polynomial(const Coefficients& k, const Real& r)
{
    return ((((((k[7] * r + k[6]) * r + k[5]) * r + k[4]) * r + k[3]) * r + k[2]) * r + k[1]) *
               r +
           k[0];
}

template <class Real>
Real quotient(const Coefficients& above, const Coefficients& below, const Real& r)
{
    return polynomial(above, r) / polynomial(below, r);
}

/// |q| <= 0.425, q = p - 1/2; of no meaning outside.
template <class Real> Real central(const Real& q)
{
    return q * quotient<Real>(kA, kB, 0.180625 - q * q);
}

[[noreturn]] void refuse(double p)
{
    std::ostringstream text;
    text << "normal quantile: probability " << p << " is not in (0, 1)";
    throw std::invalid_argument(text.str());
}

bool is_central(double p) { return std::abs(p - 0.5) <= kCentral; }

/// Outside the central region.
double tail_quantile(double p)
{
    if (!(p > 0.0 && p < 1.0)) refuse(p);
    const double tail = p < 0.5 ? p : 1.0 - p; // 1 - p is exact above 1/2
    const double s = std::sqrt(-std::log(tail));
    const double x = s <= kFar ? quotient(kC, kD, s - 1.6) : quotient(kE, kF, s - kFar);
    return p < 0.5 ? -x : x;
}

constexpr std::size_t kBlock = 256; ///< values whose tails are gathered, then done in one loop
constexpr std::size_t kStep = 8;    ///< two registers at a time hide each other's latency

/// `x` to quantiles, right where central.
void set_central(std::array<double, kBlock>& x, std::size_t n)
{
    for (std::size_t i = 0; i < n; i += kStep) {
        Lanes left, right;
        std::memcpy(&left, &x[i], sizeof left);
        std::memcpy(&right, &x[i + kStep / 2], sizeof right);
        const Lanes a = central<Lanes>(left - 0.5), b = central<Lanes>(right - 0.5);
        std::memcpy(&x[i], &a, sizeof a);
        std::memcpy(&x[i + kStep / 2], &b, sizeof b);
    }
}

} // namespace

double normal_density(double z)
{
    return std::exp(-0.5 * z * z) * (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2);
}
double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }
double normal_survival(double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); }

double normal_quantile(double p) { return is_central(p) ? central(p - 0.5) : tail_quantile(p); }

double upper_normal_quantile(double q) { return -normal_quantile(q); }

void to_normal_quantiles(std::span<double> p)
{
    std::array<double, kBlock> x{};
    std::array<std::size_t, kBlock> tails{};
    while (!p.empty()) {
        const std::size_t n = std::min(kBlock, p.size());
        std::copy_n(p.begin(), n, x.begin());
        set_central(x, n);
        std::size_t n_tails = 0;
        for (std::size_t i = 0; i < n; ++i) { // without a branch: which are tails is chance
            tails[n_tails] = i;
            n_tails += is_central(p[i]) ? 0 : 1;
        }
        for (std::size_t k = 0; k < n_tails; ++k) x[tails[k]] = tail_quantile(p[tails[k]]);
        std::copy_n(x.begin(), n, p.begin());
        p = p.subspan(n);
    }
}

} // namespace core
