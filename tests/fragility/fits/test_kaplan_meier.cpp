#include "fragility/fits/kaplan_meier.hpp"

#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace fragility;

namespace {

auto near(double value) { return Approx(value).epsilon(1e-9).margin(0.0); }

} // namespace

TEST_CASE("Kaplan-Meier: steps, Greenwood errors and bands as survfit (R, log-log)",
          "[fragility][kaplan_meier]")
{
    const std::vector<Observation> data{observed(3),       observed(5), right_censored(5),
                                        observed(6),       observed(8), observed(8),
                                        right_censored(9), observed(12)};
    const KaplanMeier k = kaplan_meier(data);
    REQUIRE(k.steps.size() == 5);
    const double survival[] = {0.875, 0.75, 0.6, 0.3};
    const double error[] = {0.1169267933, 0.1530931089, 0.1816590212, 0.1753567792};
    const double lower[] = {0.38700001403, 0.31480711371, 0.19549586608, 0.04424730793};
    const double upper[] = {0.9813929659, 0.9308983171, 0.8522543458, 0.6281957938};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(k.steps[i].probability == near(1.0 - survival[i]));
        CHECK(k.steps[i].std_error == near(error[i]));
        CHECK(1.0 - k.steps[i].band.upper == near(lower[i]));
        CHECK(1.0 - k.steps[i].band.lower == near(upper[i]));
    }
    CHECK(k.steps[4].probability == 1.0);
    CHECK(k.steps[4].std_error == 0.0);
    CHECK(k.steps[4].band.upper == 1.0);
    CHECK(k.end == 12.0);
}

TEST_CASE("Kaplan-Meier: without censoring it is the share of walls, with binomial errors",
          "[fragility][kaplan_meier]")
{
    const KaplanMeier k = kaplan_meier(fit_data::all_observed(fit_data::lognormal350));
    for (const KaplanMeierStep& s : k.steps) {
        const double p = 1.0 - (s.at_risk - s.failed) / 350.0;
        CHECK(s.probability == Approx(p).margin(1e-12));
        CHECK(s.std_error == Approx(std::sqrt(p * (1.0 - p) / 350.0)).margin(1e-12));
    }
}

TEST_CASE("Kaplan-Meier: what it cannot judge is refused", "[fragility][kaplan_meier]")
{
    CHECK_THROWS_AS(kaplan_meier(std::vector{left_censored(1)}), std::invalid_argument);
    CHECK_THROWS_AS(kaplan_meier(std::vector{Observation{1, 2}}), std::invalid_argument);
    CHECK_THROWS_AS(kaplan_meier(std::vector{observed(std::nan(""))}), std::invalid_argument);
    CHECK(kaplan_meier({}).steps.empty());
    CHECK(kaplan_meier(std::vector(4, right_censored(2))).end == 2.0);
}
