#include "core/fit_factors.hpp"

#include "core/critical.hpp"
#include "core/normal.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>

using namespace core;

TEST_CASE("fit factors: those of core/critical.hpp but for the last digits",
          "[core][fit_factors]")
{
    const double confidence = GENERATE(0.5, 0.8, 0.9, 0.95, 0.99);
    const auto same = [](double x) { return Approx(x).epsilon(4e-15).margin(0.0); };
    CHECK(fit_normal_factor(confidence) == same(normal_factor(confidence)));
    CHECK(fit_student_factor(confidence, 7.0) == same(student_factor(confidence, 7.0)));
    CHECK(normal_quantile_by_erf(0.5 * confidence) == same(normal_quantile(0.5 * confidence)));
}

TEST_CASE("fit factors: no confidence outside (0, 1)", "[core][fit_factors]")
{
    const double bad = GENERATE(0.0, 1.0, -0.5, 2.0);
    CHECK_THROWS_AS(fit_normal_factor(bad), std::invalid_argument);
    CHECK_THROWS_AS(fit_student_factor(bad, 3.0), std::invalid_argument);
}
