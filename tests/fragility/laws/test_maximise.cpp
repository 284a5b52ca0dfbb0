#include "fragility/laws/maximise.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fragility;
using Eigen::VectorXd;

namespace {

/// x^2 / 2 - x^4 / 4: maxima at -1 and 1, a minimum at 0.
Local two_hills(const VectorXd& x)
{
    const double v = x[0];
    Local l{0.5 * v * v - 0.25 * v * v * v * v, VectorXd(1), Eigen::MatrixXd(1, 1)};
    l.gradient << v - v * v * v;
    l.hessian << 1.0 - 3.0 * v * v;
    return l;
}

/// ln x - x, allowed for x > 0 only.
Local one_sided(const VectorXd& x)
{
    Local l{-std::numeric_limits<double>::infinity(), VectorXd(1), Eigen::MatrixXd(1, 1)};
    if (!(x[0] > 0.0)) return l;
    l.value = std::log(x[0]) - x[0];
    l.gradient << 1.0 / x[0] - 1.0;
    l.hessian << -1.0 / (x[0] * x[0]);
    return l;
}

VectorXd at(double x) { return VectorXd::Constant(1, x); }

} // namespace

TEST_CASE("maximise: climbs from where the function is not concave", "[fragility][maximise]")
{
    const double start = GENERATE(0.05, 0.5, 3.0);
    const Maximum m = maximise(two_hills, at(start));
    CHECK(m.converged);
    CHECK(m.at[0] == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("maximise: a minimum is no maximum", "[fragility][maximise]")
{
    CHECK_FALSE(maximise(two_hills, at(0.0)).converged);
}

TEST_CASE("maximise: stays where the function is defined", "[fragility][maximise]")
{
    // a full step from 3 would end at -3
    const Maximum m = maximise(one_sided, at(3.0));
    CHECK(m.converged);
    CHECK(m.at[0] == Approx(1.0).epsilon(1e-12));
    CHECK_FALSE(maximise(one_sided, at(-1.0)).converged);
}
