#include "bench/active/problems.hpp"

#include "core/normal.hpp"
#include "tests/uq/reliability/reliability_problems.hpp"
#include "uq/designs/sobol.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace active_bench {
namespace {

using Eigen::VectorXd;

double tail(double x) { return 0.5 * std::erfc(x / std::numbers::sqrt2); }

/// int f phi over the line, by the rule of the trapezium, which is exact here.
template <class F> double over_normal(F f)
{
    constexpr double kStep = 1e-3;
    double sum = 0.0;
    for (int i = -10000; i <= 10000; ++i) {
        const double x = kStep * i;
        sum += f(x) * std::exp(-0.5 * x * x);
    }
    return sum * kStep / std::sqrt(2.0 * std::numbers::pi);
}

/// Waarts (2000) with another distance of the straight branches, as Echard et al. (2011) use
/// it. In p = (a + b) / sqrt 2, q = (a - b) / sqrt 2: safe where |p| < 3 + 0.2 q^2 and
/// |q| < cut / 2.
BenchProblem four_branches(double k)
{
    const double cut = k / std::numbers::sqrt2;
    auto g = [cut](const VectorXd& u) {
        const double off = u(0) - u(1), bend = 3.0 + 0.1 * off * off,
                     sum = (u(0) + u(1)) / std::numbers::sqrt2;
        return std::min({bend - sum, bend + sum, off + cut, cut - off});
    };
    const double half = cut / std::numbers::sqrt2;
    const double exact = 2.0 * tail(half) + over_normal([&](double q) {
                             return std::abs(q) < half ? 2.0 * tail(3.0 + 0.2 * q * q) : 0.0;
                         });
    return {"four branches, k " + std::to_string(static_cast<int>(k)),
            "Waarts 2000; Echard et al. 2011", problems::limit_state(2, g), exact};
}

/// Convex or straight, in ten dimensions: beta + kappa / 4 (u_1 - u_2)^2 - sum u / sqrt 10.
BenchProblem ten(double beta, double kappa)
{
    auto g = [=](const VectorXd& u) {
        return beta + 0.25 * kappa * (u(0) - u(1)) * (u(0) - u(1)) - u.sum() / std::sqrt(10.0);
    };
    const double exact =
        over_normal([&](double w) { return tail(beta + 0.5 * kappa * w * w); });
    char name[80];
    std::snprintf(name, sizeof name, "10 inputs, beta %.4g, curvature %g", beta, kappa);
    return {name, "Papaioannou et al. 2016", problems::limit_state(10, g), exact};
}

BenchProblem two_sided_ten(double beta)
{
    auto g = [=](const VectorXd& u) { return beta - std::abs(u.sum()) / std::sqrt(10.0); };
    return {"10 inputs, two sides", "closed form", problems::limit_state(10, g),
            2.0 * tail(beta), true};
}

/// Undamped oscillator under a rectangular pulse (Schueremans and Van Gemert 2005; Echard et
/// al. 2011 and 2013), with or without a scatter that is a function of the point alone.
struct Oscillator {
    double force, force_sd, noise;

    /// Largest displacement.
    [[nodiscard]] double sway(const VectorXd& u) const
    {
        const double m = 1.0 + 0.05 * u(0), c1 = 1.0 + 0.1 * u(1), c2 = 0.1 + 0.01 * u(2),
                     f = force + force_sd * u(3), t = 1.0 + 0.2 * u(4);
        const double w2 = (c1 + c2) / m;
        return std::abs(2.0 * f / (m * w2) * std::sin(0.5 * std::sqrt(w2) * t));
    }
    [[nodiscard]] double scatter(const VectorXd& u) const
    {
        return noise * std::sin(1e5 * (u(0) + 2.0 * u(1) + 3.0 * u(3) + 5.0 * u(4)));
    }
};

/// The resistance is integrated in closed form, the rest by points of Sobol' whose force is
/// drawn two standard deviations up.
double exact_probability(const Oscillator& o)
{
    constexpr Eigen::Index kPoints = 1 << 17;
    constexpr double kUp = 2.0;
    const Eigen::MatrixXd cube = uq::sobol(0, kPoints, 5, 1);
    double sum = 0.0;
    VectorXd u(5);
    for (Eigen::Index i = 0; i < kPoints; ++i) {
        for (int j = 0; j < 5; ++j) u(j) = core::normal_quantile(cube(i, j));
        u(3) += kUp;
        sum +=
            std::exp(kUp * (0.5 * kUp - u(3))) * tail((1.5 - o.sway(u) + o.scatter(u)) / 0.15);
    }
    return sum / kPoints;
}

BenchProblem oscillator(const std::string& name, const Oscillator& o)
{
    auto g = [o](const VectorXd& u) {
        return 3.0 * (0.5 + 0.05 * u(5)) - o.sway(u) + o.scatter(u);
    };
    return {name, "Schueremans and Van Gemert 2005; Echard et al. 2011, 2013",
            problems::limit_state(6, g), exact_probability(o)};
}

BenchProblem published(problems::Problem p)
{
    return {p.name, "uq reference values", p.limit, p.exact};
}

} // namespace

std::vector<BenchProblem> bench_problems()
{
    return {four_branches(6.0),
            four_branches(7.0),
            published(problems::rp22()),
            published(problems::difference_7_2()),
            published(problems::steel_section()),
            oscillator("oscillator", {1.0, 0.2, 0.0}),
            oscillator("oscillator that scatters", {1.0, 0.2, 0.05}),
            oscillator("oscillator, weak force", {0.6, 0.1, 0.0}),
            ten(3.0902, 0.0),
            ten(3.5, 5.0),
            ten(4.7534, 0.0),
            two_sided_ten(4.0)};
}

} // namespace active_bench
