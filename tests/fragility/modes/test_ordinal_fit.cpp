#include "fragility/modes/ordinal_fit.hpp"

#include "core/interval.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fragility;

namespace {

auto near(double value, double tolerance = 1e-9)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

/// Baker (2015), data of the example of the published tools.
const std::vector<StateCounts> kBaker{{0.2, {40, 0}},  {0.3, {40, 0}}, {0.4, {40, 0}},
                                      {0.6, {36, 4}},  {0.7, {34, 6}}, {0.8, {27, 13}},
                                      {0.9, {28, 12}}, {1.0, {24, 16}}};

const std::vector<StateCounts> kStates{{0.1, {38, 2, 0}},  {0.2, {30, 9, 1}},
                                       {0.3, {20, 16, 4}}, {0.4, {11, 20, 9}},
                                       {0.6, {4, 17, 19}}, {0.8, {1, 10, 29}}};

} // namespace

TEST_CASE("ordinal fit: stripes of Baker's example by maximum likelihood",
          "[fragility][ordinal_fit]")
{
    const OrdinalFit f = fit_ordinal(kBaker);
    REQUIRE(f.outcome == ModelOutcome::converged);
    CHECK(f.medians[0] == near(1.0761157943, 1e-10));
    CHECK(f.dispersion == near(0.4292372038, 2e-10));
    CHECK(f.deviance == near(2.81972829233, 1e-10));
    CHECK(f.freedom == 6.0);
    CHECK(std::sqrt(f.covariance(0, 0)) == near(0.071659541824932, 1e-11));
    CHECK(std::sqrt(f.covariance(1, 1)) == near(0.083870649281066, 1e-11));
    CHECK(f.covariance(0, 1) / std::sqrt(f.covariance(0, 0) * f.covariance(1, 1)) ==
          near(0.810492, 1e-6));
}

TEST_CASE("ordinal fit: another unit scales the median and nothing else",
          "[fragility][ordinal_fit]")
{
    auto data = kBaker;
    for (StateCounts& s : data) s.intensity *= 9.81;
    const OrdinalFit f = fit_ordinal(kBaker);
    const OrdinalFit g = fit_ordinal(data);
    CHECK(g.medians[0] == near(9.81 * f.medians[0], 1e-12));
    CHECK(g.dispersion == near(f.dispersion, 1e-12));
    CHECK(g.covariance(0, 0) == near(f.covariance(0, 0), 1e-10));
}

TEST_CASE("ordinal fit: the error of a probability is that of the median at the median, and "
          "moves with the parameters",
          "[fragility][ordinal_fit]")
{
    const OrdinalFit f = fit_ordinal(kStates);
    const StateProbability middle = probability(f, 2, f.medians[1]);
    CHECK(middle.probability == near(0.5, 1e-15));
    CHECK(middle.probit_error == near(std::sqrt(f.covariance(1, 1)) / f.dispersion, 1e-12));
    // away from it: second moments of the linear change of the probit
    const double x = 0.3, h = 1e-6;
    const auto probit = [&](double ln_median, double dispersion) {
        return (std::log(x) - ln_median) / dispersion;
    };
    const double m = std::log(f.medians[0]), b = f.dispersion;
    const Eigen::Vector2d g((probit(m + h, b) - probit(m - h, b)) / (2 * h),
                            (probit(m, b + h) - probit(m, b - h)) / (2 * h));
    Eigen::Matrix2d c;
    c << f.covariance(0, 0), f.covariance(0, 2), f.covariance(2, 0), f.covariance(2, 2);
    CHECK(probability(f, 1, x).probit_error == near(std::sqrt(g.dot(c * g)), 1e-8));
}

TEST_CASE("ordinal fit: three states as polr (R)", "[fragility][ordinal_fit]")
{
    const OrdinalFit f = fit_ordinal(kStates);
    REQUIRE(f.outcome == ModelOutcome::converged);
    CHECK(f.medians[0] == near(0.286848992, 2e-9));
    CHECK(f.medians[1] == near(0.604556304, 2e-9));
    CHECK(f.dispersion == near(0.564745168, 2e-9));
    CHECK(1.0 / f.dispersion == near(1.77071014947, 1e-9));
    CHECK(std::log(f.medians[0]) / f.dispersion == near(-2.21126170275, 1e-9));
    CHECK(std::log(f.medians[1]) / f.dispersion == near(-0.891128423812, 2e-9));
    CHECK(-2.0 * f.log_likelihood == near(356.429407995, 1e-11));
    // from second differences of the likelihood written in R
    CHECK(std::sqrt(f.covariance(0, 0)) == near(0.05844062340, 1e-6));
    CHECK(std::sqrt(f.covariance(1, 1)) == near(0.06459076940, 1e-6));
    CHECK(std::sqrt(f.covariance(2, 2)) == near(0.05256974469, 1e-6));
    CHECK(f.covariance(0, 2) == near(-0.00069363929, 1e-5));
}

TEST_CASE("ordinal fit: separate probits of the same counts", "[fragility][ordinal_fit]")
{
    const OrdinalFit one = fit_ordinal(reaching(kStates, 1));
    const OrdinalFit two = fit_ordinal(reaching(kStates, 2));
    CHECK(one.medians[0] == near(0.286746592, 2e-9));
    CHECK(one.dispersion == near(0.575814551, 2e-9));
    CHECK(two.medians[0] == near(0.598889961, 2e-9));
    CHECK(two.dispersion == near(0.537204834, 2e-9));
}

TEST_CASE("ordinal fit: data without curves are named", "[fragility][ordinal_fit]")
{
    using enum ModelOutcome;
    const std::vector<std::pair<std::vector<StateCounts>, ModelOutcome>> cases{
        {{}, no_data},
        {{{1, {40, 0}}, {2, {40, 0}}}, absent_mode},
        {{{1, {0, 40}}, {2, {0, 40}}}, absent_mode},
        {{{1, {37, 3}}, {1, {35, 5}}}, no_contrast},
        {{{1, {40, 0}}, {2, {0, 40}}}, separated},
        {{{1, {40, 0}}, {2, {20, 20}}, {3, {0, 40}}}, separated},
        {{{1, {20, 20}}, {2, {37, 3}}}, wrong_slope},
        {{{0, {39, 1}}, {2, {37, 3}}}, invalid_value},
        {{{1, {std::nan(""), 4}}, {2, {37, 3}}}, invalid_value},
        {{{1, {3, 0, 2}}, {2, {1, 0, 4}}}, absent_mode},
        {{{1, {3, 1, 2}}, {1, {1, 3, 4}}}, no_contrast},
        {{{1, {3, 0, 0}}, {2, {0, 3, 0}}, {3, {0, 0, 3}}}, separated},
        {{{1, {1, 3, 9}}, {2, {9, 3, 1}}}, wrong_slope},
        {{{1, {3, 1}}, {2, {1, 3, 4}}}, invalid_value},
        {{{1, {3}}, {2, {1}}}, invalid_value},
        {{{1, {3, -1}}, {2, {1, 2}}}, invalid_value}};
    for (const auto& [data, outcome] : cases) {
        const OrdinalFit f = fit_ordinal(data);
        CHECK(f.outcome == outcome);
        CHECK(f.medians.empty());
        CHECK_FALSE(f.reason.empty());
    }
}

TEST_CASE("ordinal fit: intervals of median and dispersion lie evenly about them on the "
          "logarithmic axis",
          "[fragility][ordinal_fit]")
{
    constexpr double kZ = 1.6448536269514722; // 90 %
    const OrdinalFit f = fit_ordinal(kStates);
    for (const LogEstimate& e : {median(f, 1, 0.9), median(f, 2, 0.9), dispersion(f, 0.9)}) {
        CHECK(e.log_error == near(e.std_error / e.value, 1e-14));
        CHECK(std::log(e.interval.upper / e.value) == near(kZ * e.log_error, 1e-12));
        CHECK(std::log(e.value / e.interval.lower) == near(kZ * e.log_error, 1e-12));
    }
    CHECK(median(f, 2).value == f.medians[1]);
    CHECK(dispersion(f).std_error == std::sqrt(f.covariance(2, 2)));
}

TEST_CASE("ordinal fit: the band at the median ends where that of the median does",
          "[fragility][ordinal_fit]")
{
    const OrdinalFit f = fit_ordinal(kStates);
    const LogEstimate m = median(f, 1);
    const core::Interval b = band(probability(f, 1, m.value));
    CHECK(b.lower == near(probability(f, 1, m.value * m.value / m.interval.upper).probability));
    CHECK(b.upper == near(probability(f, 1, m.interval.upper).probability));
}

TEST_CASE("ordinal fit: the p-value is that of the deviance, and there is none without freedom",
          "[fragility][ordinal_fit]")
{
    OrdinalFit f = fit_ordinal(kBaker);
    CHECK(p_value(f) ==
          near(0.8311089125341314, 1e-9)); // exp(-x) (1 + x + x^2 / 2), x = deviance / 2
    f.deviance = 2.0;
    f.freedom = 2.0;
    CHECK(p_value(f) == near(std::exp(-1.0), 1e-12));
    f.freedom = 0.0;
    CHECK(std::isnan(p_value(f)));
}
