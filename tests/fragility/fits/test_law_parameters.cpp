#include "fragility/fits/law_parameters.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace fragility;

namespace {

Fit fitted(Law law)
{
    std::vector<Observation> data;
    for (const double x : {0.8, 1.1, 1.3, 1.9, 2.6}) data.push_back(observed(x));
    data.push_back(right_censored(2.0));
    return fit(law, data);
}

/// Standard error of ln value.
double relative(const LawParameter& p) { return p.std_error / p.value; }

} // namespace

TEST_CASE("law parameters: location and dispersion of normal and lognormal laws keep their "
          "errors",
          "[fragility][law_parameters]")
{
    for (const Law law : {Law::lognormal, Law::normal}) {
        const Fit f = fitted(law);
        const LawParameters p = law_parameters(f);
        CHECK(p.first.name == (law == Law::normal ? "mean" : "ln median"));
        CHECK(p.first.value == f.law.location);
        CHECK(p.first.std_error == Approx(f.location_error).epsilon(1e-14));
        CHECK(p.second.value == f.law.dispersion);
        CHECK(p.second.std_error == Approx(f.dispersion_error).epsilon(1e-14));
        CHECK(std::abs(p.correlation) < 1.0);
    }
}

TEST_CASE(
    "law parameters: shape and scale give the location and the dispersion of the fit back, "
    "with their errors",
    "[fragility][law_parameters]")
{
    for (const Law law : {Law::weibull, Law::gamma}) {
        const Fit f = fitted(law);
        const LawParameters p = law_parameters(f);
        const double power = law == Law::weibull ? 1.0 : 2.0;
        CHECK(p.first.value == shape(f.law));
        CHECK(p.second.value == scale(f.law));
        CHECK(relative(p.first) ==
              Approx(power * f.dispersion_error / f.law.dispersion).epsilon(1e-12));
        // location: ln scale of Weibull, ln (shape x scale) of gamma
        const double a = law == Law::weibull ? 0.0 : relative(p.first), b = relative(p.second);
        CHECK(std::sqrt(a * a + b * b + 2.0 * p.correlation * a * b) ==
              Approx(f.location_error).epsilon(1e-10));
    }
}

TEST_CASE("law parameters: none without a fit", "[fragility][law_parameters]")
{
    CHECK_THROWS_AS(law_parameters(Fit{}), std::invalid_argument);
}
