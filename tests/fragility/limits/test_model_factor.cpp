#include "core/interval.hpp"
#include "fragility/laws/standard_law.hpp"
#include "fragility/limits/model_factor.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace fragility;

namespace {

constexpr double kZ84 = 0.994457883209753, kZ975 = 1.959963984540054;
constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

core::Interval around(double median, double error)
{
    return {median * std::exp(-kZ975 * error), median * std::exp(kZ975 * error), 0.95};
}

} // namespace

TEST_CASE("model factor: a lognormal drift times a lognormal factor is lognormal",
          "[fragility][model_factor]")
{
    const ModelFactor factor{0.8, 0.3, 0.2};
    const auto walls = drift_distribution(Distribution{Law::lognormal, std::log(2.0), 0.5});
    const DoubtedLimit limit = with_model_doubt(walls, around(2.0, 0.1), 0.1, factor);
    const double total = std::sqrt(0.25 + 0.09 + 0.04 + 0.01);
    CHECK(limit.dispersion.material == Approx(0.5).epsilon(3e-3)); // by 1000 values
    CHECK(limit.dispersion.sampling == 0.1);
    CHECK(limit.dispersion.model == Approx(std::sqrt(0.13)).epsilon(1e-12));
    CHECK(limit.dispersion.total == Approx(total).epsilon(3e-3));
    CHECK(limit.quantiles[1].lower == Approx(1.6).epsilon(1e-3));
    CHECK(limit.quantiles[0].lower == Approx(1.6 * std::exp(-kZ84 * total)).epsilon(2e-3));
    CHECK(limit.quantiles[2].upper == Approx(1.6 * std::exp(kZ84 * total)).epsilon(2e-3));
    const double error = std::sqrt(0.01 + 0.04);
    CHECK(limit.median_interval.lower == Approx(1.6 * std::exp(-kZ975 * error)).epsilon(1e-3));
    CHECK(limit.median_interval.upper == Approx(1.6 * std::exp(kZ975 * error)).epsilon(1e-3));
}

TEST_CASE("model factor: none leaves the quantiles of the walls", "[fragility][model_factor]")
{
    const DriftDistribution walls{{1.0, 2.0, 3.0, 9.0}, {0.25, 0.25, 0.25, 0.25}};
    const DoubtedLimit limit = with_model_doubt(walls, {1.0, 3.0, 0.95}, 0.0, {});
    CHECK(limit.quantiles[0].lower == 1.0);
    CHECK(limit.quantiles[1].lower == 2.0);
    CHECK(limit.quantiles[2].upper == 9.0);
    CHECK(limit.median_interval.lower == Approx(1.0));
    CHECK(limit.median_interval.upper == Approx(3.0));
    CHECK(limit.dispersion.model == 0.0);
}

TEST_CASE("model factor: two heaps of walls are a mixture of two lognormal laws",
          "[fragility][model_factor]")
{
    const DriftDistribution walls{{1.5, 9.0}, {0.7, 0.3}};
    for (const double p : {0.16, 0.5, 0.84}) {
        const double x = factored_quantile(walls, 0.8, 0.4, p).lower / 0.8;
        const auto cdf = [&](double at) { return StandardNormal::cdf(std::log(x / at) / 0.4); };
        CHECK(0.7 * cdf(1.5) + 0.3 * cdf(9.0) == Approx(p).epsilon(1e-9));
    }
}

TEST_CASE("model factor: what lies beyond the end of the push leaves a bound",
          "[fragility][model_factor]")
{
    const DriftDistribution walls{{1.0, 2.0}, {0.3, 0.3}, 0.4, 2.7};
    const QuantileBounds median = factored_quantile(walls, 1.0, 0.3, 0.5);
    const QuantileBounds high = factored_quantile(walls, 1.0, 0.3, 0.84);
    CHECK(median.lower < median.upper);
    CHECK(std::isfinite(median.upper));
    CHECK(std::isinf(high.upper));
    // the lower end is that of walls that all fall right there
    const DriftDistribution there{{1.0, 2.0, 2.7}, {0.3, 0.3, 0.4}};
    CHECK(high.lower == Approx(factored_quantile(there, 1.0, 0.3, 0.84).lower).epsilon(1e-12));
    CHECK(factored_quantile(walls, 0.5, 0.0, 0.84).lower == Approx(0.5 * 2.7));
    CHECK(std::isinf(factored_quantile(walls, 0.5, 0.0, 0.84).upper));
}

TEST_CASE("model factor: a share observed gives weights that sum to one",
          "[fragility][model_factor]")
{
    const std::vector<Observation> data = {observed(1.0), observed(2.0), right_censored(2.5),
                                           right_censored(2.5)};
    const DriftDistribution walls = drift_distribution(kaplan_meier(data));
    REQUIRE(walls.drifts == std::vector{1.0, 2.0});
    CHECK(walls.weights[0] == Approx(0.25));
    CHECK(walls.weights[1] == Approx(0.25));
    CHECK(walls.beyond == Approx(0.5));
    CHECK(walls.end == 2.5);
}

TEST_CASE("model factor: the sampling error comes from the side of the interval that is known",
          "[fragility][model_factor]")
{
    const DriftDistribution walls{{1.0, 2.0, 3.0}, {0.3, 0.4, 0.3}};
    const auto sampling = [&](core::Interval median) {
        return with_model_doubt(walls, median, kNotKnown, {}).dispersion.sampling;
    };
    CHECK(sampling(around(2.0, 0.2)) == Approx(0.2).epsilon(1e-9));
    CHECK(sampling({2.0 * std::exp(-kZ975 * 0.2), core::kInfinity, 0.95}) ==
          Approx(0.2).epsilon(1e-9));
    CHECK(sampling({0.0, 2.0 * std::exp(kZ975 * 0.2), 0.95}) == Approx(0.2).epsilon(1e-9));
    CHECK(std::isnan(sampling({0.0, core::kInfinity, 0.95})));
}

TEST_CASE("model factor: weights that only just reach a share have no upper end there",
          "[fragility][model_factor]")
{
    // ten of twenty walls, whose weights the sum rounds to one half and a bit
    const DriftDistribution walls{{1.0, 2.0}, {0.25, 0.25 + 1.2e-16}, 0.5, 2.7};
    REQUIRE(walls.weights[0] + walls.weights[1] > 0.5);
    const QuantileBounds median = factored_quantile(walls, 0.8, 0.4, 0.5);
    CHECK(std::isfinite(median.lower));
    CHECK(std::isinf(median.upper));
}

TEST_CASE("model factor: of a lognormal law all is exact, whatever its dispersion rests on",
          "[fragility][model_factor]")
{
    const ModelFactor factor{0.8, 0.3, 0.2};
    const Distribution law{Law::lognormal, std::log(2.0), 0.5};
    const DoubtedLimit known = with_model_doubt(law, around(2.0, 0.1), 0.1, factor);
    const double total = std::sqrt(0.25 + 0.01 + 0.09 + 0.04);
    CHECK(known.dispersion.material == 0.5);
    CHECK(known.dispersion.total == Approx(total).epsilon(1e-12));
    CHECK(known.quantiles[1].lower == Approx(1.6).epsilon(1e-12));
    CHECK(known.quantiles[0].upper == Approx(1.6 * std::exp(-kZ84 * total)).epsilon(1e-12));
    // two walls: Student's quantile with one degree of freedom is tan(0.34 pi)
    const DoubtedLimit two = with_model_doubt(law, around(2.0, 0.1), 0.1, factor, 1.0);
    const double deviate = std::hypot(std::tan(0.34 * 3.141592653589793) * std::hypot(0.5, 0.1),
                                      kZ84 * std::hypot(0.3, 0.2));
    CHECK(two.quantiles[2].lower == Approx(1.6 * std::exp(deviate)).epsilon(1e-9));
    CHECK(two.dispersion.total == known.dispersion.total);
}

TEST_CASE("model factor: a bound of the median is times the factor's median, and no more",
          "[fragility][model_factor]")
{
    const DoubtedLimit limit = bounded_with_model_doubt(0.35, 0.95, {0.8, 0.4, 0.2});
    CHECK(limit.quantiles[1].lower == Approx(0.28));
    CHECK(std::isinf(limit.quantiles[1].upper));
    CHECK(limit.quantiles[0].lower == 0.0);
    CHECK(limit.quantiles[2].lower == 0.0);
    CHECK(std::isnan(limit.dispersion.total));
}
