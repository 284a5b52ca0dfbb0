#include "uq/fields/kernel.hpp"

#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_gamma.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

void require(bool ok, const char* what, double value, const char* allowed)
{
    if (!ok)
        throw std::invalid_argument(std::string(what) + " is " + std::to_string(value) +
                                    ", must be " + allowed);
}

void check_length(const char* what, double length)
{
    require(std::isfinite(length) && length > 0.0, what, length, "finite and > 0 m");
}

void check(const Exponential& k) { check_length("correlation length", k.length); }
void check(const SquaredExponential& k) { check_length("correlation length", k.length); }
void check(const ExponentialL1& k)
{
    check_length("correlation length in x", k.length_x);
    check_length("correlation length in z", k.length_z);
}
void check(const Matern& k)
{
    check_length("correlation length", k.length);
    require(k.nu >= 0.05 && k.nu <= 50.0, "smoothness nu", k.nu, "in [0.05, 50]");
}
void check(const GroupCorrelation& k)
{
    require(k.correlation >= 0.0 && k.correlation <= 1.0, "correlation", k.correlation,
            "in [0, 1]");
}

double distance(const Site& a, const Site& b) { return std::hypot(a.x - b.x, a.z - b.z); }

double between(const Exponential& k, const Site& a, const Site& b)
{
    return std::exp(-distance(a, b) / k.length);
}

double between(const SquaredExponential& k, const Site& a, const Site& b)
{
    const double s = distance(a, b) / k.length;
    return std::exp(-s * s);
}

double between(const ExponentialL1& k, const Site& a, const Site& b)
{
    return std::exp(-std::abs(a.x - b.x) / k.length_x - std::abs(a.z - b.z) / k.length_z);
}

/// In logarithms: s^nu and K_nu leave the range of a double long before their product does.
double between(const Matern& k, const Site& a, const Site& b)
{
    const double s = std::sqrt(2.0 * k.nu) * distance(a, b) / k.length;
    if (s == 0.0) return 1.0;
    if (s > 1500.0) return 0.0; // below 1e-400 for every nu allowed
    const double ln = (1.0 - k.nu) * std::numbers::ln2 - gsl_sf_lngamma(k.nu) +
                      k.nu * std::log(s) + gsl_sf_bessel_lnKnu(k.nu, s);
    return std::min(1.0, std::exp(ln));
}

double between(const GroupCorrelation& k, const Site& a, const Site& b)
{
    const bool same = k.group == Group::all || (k.group == Group::unit && a.unit == b.unit) ||
                      (k.group == Group::course && a.course == b.course);
    return same ? k.correlation : 0.0;
}

} // namespace

void check(const Kernel& kernel)
{
    if (kernel.factors.empty())
        throw std::invalid_argument("a kernel needs at least one factor");
    for (const KernelFactor& f : kernel.factors) std::visit([](const auto& k) { check(k); }, f);
}

double correlation(const Kernel& kernel, const Site& a, const Site& b)
{
    double product = 1.0;
    for (const KernelFactor& f : kernel.factors)
        product *= std::visit([&](const auto& k) { return between(k, a, b); }, f);
    return product;
}

Eigen::MatrixXd correlation_matrix(const Kernel& kernel, std::span<const Site> sites)
{
    check(kernel);
    if (sites.empty()) throw std::invalid_argument("a field needs at least one site");
    for (const Site& s : sites)
        require(std::isfinite(s.x) && std::isfinite(s.z), "coordinate of a site",
                std::isfinite(s.x) ? s.z : s.x, "finite");
    const auto p = static_cast<Eigen::Index>(sites.size());
    Eigen::MatrixXd r = Eigen::MatrixXd::Identity(p, p);
    for (Eigen::Index j = 0; j < p; ++j)
        for (Eigen::Index i = 0; i < j; ++i)
            r(i, j) = r(j, i) = correlation(kernel, sites[static_cast<std::size_t>(i)],
                                            sites[static_cast<std::size_t>(j)]);
    return r;
}

} // namespace uq
