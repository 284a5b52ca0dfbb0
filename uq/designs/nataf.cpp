#include "uq/designs/nataf.hpp"

#include "core/normal.hpp"
#include "uq/marginals/normal_rule.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace uq {
namespace {

constexpr int kTerms = 1000;
constexpr double kNothing = 1e-14; // of a coefficient: rounding of the quadrature

/// h_k at many points, one k after the other:
///   sqrt(k + 1) h_{k+1} = z h_k - sqrt(k) h_{k-1}
class Hermite {
  public:
    explicit Hermite(std::vector<double> z)
        : z_(std::move(z)), h_(z_.size(), 1.0), before_(z_.size())
    {
    }
    void advance()
    {
        const double k = k_++;
        for (std::size_t i = 0; i < z_.size(); ++i) {
            const double next =
                (z_[i] * h_[i] - std::sqrt(k) * before_[i]) / std::sqrt(k + 1.0);
            before_[i] = h_[i];
            h_[i] = next;
        }
    }
    [[nodiscard]] std::span<const double> values() const { return h_; }
    [[nodiscard]] std::span<const double> before() const { return before_; }

  private:
    std::vector<double> z_, h_, before_;
    int k_ = 0;
};

Eigen::VectorXd kept(const std::vector<double>& a)
{
    return Eigen::Map<const Eigen::VectorXd>(a.data(), static_cast<Eigen::Index>(a.size()));
}

/// Where phi is above 1e-130: polynomials of the 1000th order grow no faster than it falls.
NormalRule inner_rule(const Marginal& m)
{
    constexpr double kEnd = 24.0;
    const NormalRule all = normal_rule(kinks(m));
    NormalRule inner;
    for (std::size_t i = 0; i < all.z.size(); ++i) {
        if (std::abs(all.z[i]) > kEnd) continue;
        inner.z.push_back(all.z[i]);
        inner.weight.push_back(all.weight[i]);
    }
    return inner;
}

Eigen::VectorXd smooth_coefficients(const Marginal& m)
{
    const NormalRule rule = inner_rule(m);
    const double centre = mean(m), spread = sd(m);
    std::vector<double> weighted(rule.z.size());
    for (std::size_t i = 0; i < weighted.size(); ++i)
        weighted[i] = rule.weight[i] * ((from_normal(m, rule.z[i]) - centre) / spread);
    Hermite h(rule.z);
    std::vector<double> a;
    int small = 0; // one after the other; odd variables have every other coefficient zero
    while (small < 4 && a.size() < kTerms) {
        h.advance();
        double sum = 0.0;
        for (std::size_t i = 0; i < weighted.size(); ++i) sum += weighted[i] * h.values()[i];
        a.push_back(sum);
        small = std::abs(sum) < kNothing ? small + 1 : 0;
    }
    return kept(a);
}

/// Integral of h_k phi up to z is -h_{k-1}(z) phi(z) / sqrt(k): a sum over the steps.
Eigen::VectorXd step_coefficients(const Marginal& m)
{
    std::vector<double> values;
    std::ranges::copy_if(std::get<Empirical>(m.shape).sorted, std::back_inserter(values),
                         [&](double x) { return m.lower <= x && x <= m.upper; });
    const auto n = static_cast<double>(values.size());
    std::vector<double> z, step;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (values[i] == values[i - 1]) continue;
        z.push_back(core::normal_quantile(static_cast<double>(i) / n));
        step.push_back((values[i] - values[i - 1]) * std::exp(-0.5 * z.back() * z.back()) *
                       (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2) / sd(m));
    }
    Hermite h(z);
    std::vector<double> a;
    for (int k = 1; k <= kTerms; ++k) {
        h.advance();
        double sum = 0.0;
        for (std::size_t i = 0; i < z.size(); ++i) sum += step[i] * h.before()[i];
        a.push_back(sum / std::sqrt(static_cast<double>(k)));
    }
    return kept(a);
}

} // namespace

Eigen::VectorXd hermite_coefficients(const Marginal& m)
{
    if (sd(m) == 0.0) return {};
    return std::holds_alternative<Empirical>(m.shape) ? step_coefficients(m)
                                                      : smooth_coefficients(m);
}

double pearson_of_normals(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double rho_z)
{
    double sum = 0.0; // Horner
    for (Eigen::Index k = std::min(a.size(), b.size()); k > 0; --k)
        sum = (sum + a[k - 1] * b[k - 1]) * rho_z;
    return sum;
}

double normal_correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double rho)
{
    if (rho == 0.0) return 0.0;
    const double least = pearson_of_normals(a, b, -1.0), most = pearson_of_normals(a, b, 1.0);
    if (!(rho > least && rho < most)) {
        std::ostringstream text;
        text.precision(6);
        text << "correlation " << rho
             << " is not attainable by these marginals; allowed: inside (" << least << ", "
             << most << ")";
        throw std::invalid_argument(text.str());
    }
    std::uintmax_t steps = 200;
    const auto bracket = boost::math::tools::toms748_solve(
        [&](double r) { return pearson_of_normals(a, b, r) - rho; }, -1.0, 1.0, least - rho,
        most - rho, boost::math::tools::eps_tolerance<double>(52), steps);
    return 0.5 * (bracket.first + bracket.second);
}

} // namespace uq
