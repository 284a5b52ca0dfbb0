#include "app/input/study/distribution_text.hpp"
#include "app/input/study/units.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

using app::parse_distribution;

namespace {

std::string complaint(const std::string& text, const std::string& unit)
{
    try {
        (void)parse_distribution(text, unit);
    } catch (const app::BadValue& bad) {
        return bad.what();
    }
    return "none";
}

} // namespace

TEST_CASE("distribution text: moments come out as written, in SI", "[app][distribution_text]")
{
    const std::string name = GENERATE("normal", "lognormal", "gumbel", "gamma", "weibull");
    const uq::Marginal m = parse_distribution(name + "(mean 3.7 MPa, cov 0.30)", "MPa");
    CHECK(uq::mean(m) == Approx(3.7e6).epsilon(1e-9));
    CHECK(uq::sd(m) == Approx(0.30 * 3.7e6).epsilon(1e-9));
    const uq::Marginal by_sd = parse_distribution(name + "(sd 1110 kPa, mean 3.7 MPa)", "MPa");
    CHECK(uq::quantile(by_sd, 0.2) == Approx(uq::quantile(m, 0.2)).epsilon(1e-12));
}

TEST_CASE(
    "distribution text: a cov in percent is the same cov, and one of 2 or more is refused",
    "[app][distribution_text]")
{
    const std::string name = GENERATE("normal", "lognormal", "gumbel", "gamma", "weibull");
    const uq::Marginal m = parse_distribution(name + "(mean 3.7 MPa, cov 0.30)", "MPa");
    const std::string percent = GENERATE("cov 30 %", "cov 30%");
    const uq::Marginal same =
        parse_distribution(name + "(mean 3.7 MPa, " + percent + ")", "MPa");
    CHECK(uq::quantile(same, 0.1) == uq::quantile(m, 0.1));
    CHECK(complaint(name + "(mean 3.7 MPa, cov 30)", "MPa") ==
          "cov 30 is a scatter of 30 times the mean; write \"cov 30 %\" if that was meant, and "
          "less than 2 otherwise");
    CHECK(complaint(name + "(mean 3.7 MPa, cov 200 %)", "MPa") ==
          "cov 200 % is out of range; write less than 200 %");
    CHECK(complaint(name + "(mean 3.7 MPa, sd 30 %)", "MPa") != "none");
}

TEST_CASE("distribution text: the lognormal of Table 5 in both its forms",
          "[app][distribution_text]")
{
    const double median = 3.7 / std::sqrt(1.0 + 0.09);
    const uq::Marginal m = parse_distribution("lognormal(mean 3.7 MPa, cov 0.30)", "MPa");
    CHECK(uq::quantile(m, 0.5) == Approx(median * 1e6).epsilon(1e-12));
    const uq::Marginal same =
        parse_distribution("lognormal(median 3.5 MPa, sigma_log 0.294)", "MPa");
    CHECK(uq::quantile(same, 0.5) == Approx(3.5e6).epsilon(1e-12));
}

TEST_CASE("distribution text: bounded shapes keep to their bounds", "[app][distribution_text]")
{
    const double deg = std::numbers::pi / 180.0;
    const std::string text = GENERATE("uniform(lower 20 deg, upper 40 deg)",
                                      "triangular(lower 20 deg, mode 35 deg, upper 40 deg)",
                                      "beta(mean 31 deg, cov 0.1, lower 20 deg, upper 40 deg)",
                                      "normal(mean 31 deg, cov 0.2, from 20 deg, to 40 deg)");
    const uq::Marginal m = parse_distribution(text, "deg");
    CHECK(uq::quantile(m, 1e-12) == Approx(20.0 * deg).epsilon(2e-3));
    CHECK(uq::quantile(m, 1e-12) >= 20.0 * deg);
    CHECK(uq::upper_quantile(m, 1e-12) == Approx(40.0 * deg).epsilon(2e-3));
}

TEST_CASE("distribution text: observations are a distribution", "[app][distribution_text]")
{
    const uq::Marginal m = parse_distribution("empirical(4.0, 3.1, 3.4 MPa)", "MPa");
    CHECK(uq::mean(m) == Approx(3.5e6));
}

TEST_CASE("distribution text: what is wrong is said, with what to write",
          "[app][distribution_text]")
{
    CHECK(complaint("normal(mean 3 MPa, cov 0.1, cov 0.2)", "MPa")
              .find("does not have the parameters") != std::string::npos);
    CHECK(complaint("normal(mean 3 MPa, mean 4 MPa)", "MPa").find("given twice") !=
          std::string::npos);
    CHECK(complaint("normal(mean 3 MPa, cov -0.1)", "MPa").find("cov") != std::string::npos);
    CHECK(complaint("normal(mean 3 MPa, cov 0.1 MPa)", "MPa").find("none belongs") !=
          std::string::npos);
    CHECK(complaint("normal(mean 3 MPa, cov 0.1, from 5 MPa, to 4 MPa)", "MPa") != "none");
    CHECK(complaint("empirical()", "MPa") != "none");
    CHECK_FALSE(app::is_distribution("3.7 MPa"));
    CHECK_FALSE(app::is_distribution("running"));
    CHECK(app::is_distribution("normal(mean 1, cov 0.1)"));
}

TEST_CASE("distribution text: a decimal comma and numbers in SI are told", "[app][units]")
{
    CHECK_THROWS_WITH(app::parse_distribution("normal(mean 31,8 deg, cov 0.2)", "deg"),
                      Catch::Contains("write a decimal point, \"normal(mean 31.8 deg, cov"));
    CHECK_THROWS_WITH(app::parse_distribution("uniform(lower 5 MPa, upper 3 MPa)", "MPa"),
                      Catch::Contains("upper end is 3e+06") &&
                          Catch::Contains("(numbers in Pa)"));
}

TEST_CASE("distribution text: a cut that leaves next to nothing is refused",
          "[app][distribution_text]")
{
    // 80 deg lies 8.0 standard deviations above the mean
    CHECK(complaint("normal(mean 31.8 deg, sd 6 deg, from 80 deg, to 89 deg)", "deg")
              .find("leaves 4.7e-16 of the distribution") != std::string::npos);
    CHECK(complaint("lognormal(mean 30 deg, cov 0.05, to 10 deg)", "deg")
              .find("next to nothing; write from and to") != std::string::npos);
    CHECK(complaint("normal(mean 30 deg, sd 3 deg, from 50 deg)", "deg") != "none"); // 1.3e-11
    // 4.4 standard deviations: 5e-6 of it is left
    CHECK(complaint("normal(mean 31.8 deg, sd 3 deg, from 45 deg)", "deg") == "none");
    CHECK(complaint("normal(mean 31.8 deg, sd 3 deg, from 1 deg)", "deg") == "none");
}
