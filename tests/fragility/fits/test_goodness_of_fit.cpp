#include "fragility/fits/bootstrap_random.hpp"
#include "fragility/fits/goodness_of_fit.hpp"
#include "fragility/fits/kaplan_meier.hpp"

#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fragility;

namespace {

auto near(double value) { return Approx(value).epsilon(1e-9).margin(0.0); }
const RandomBits kBits = fit_data::bits;

/// n times the integral of (F_n - F)^2 w(F) dF up to `end`, w = 1 or 1 / (F (1 - F)); F_n by
/// Kaplan and Meier.
template <class Weight>
double integrated(const Distribution& law, const std::vector<Observation>& data, double end,
                  Weight weight)
{
    const int panels = 2000000;
    const KaplanMeier km = kaplan_meier(data);
    double sum = 0.0;
    std::size_t k = 0;
    double share = 0.0;
    for (int i = 0; i < panels; ++i) {
        const double f = (i + 0.5) * end / panels;
        while (k < km.steps.size() && cdf(law, km.steps[k].at) <= f)
            share = km.steps[k++].probability;
        sum += std::pow(share - f, 2) * weight(f);
    }
    return static_cast<double>(data.size()) * sum * end / panels;
}

/// Walls of a law whose runs end a little apart, as those of a study do.
std::vector<Observation> stopped_about(const Distribution& law, std::uint64_t study,
                                       std::size_t n, double from, double to)
{
    std::vector<Observation> data;
    for (std::size_t k = 0; k < n; ++k) {
        const double x = quantile(law, uniform(fit_data::bits(study, 2 * k)));
        const double end = from + (to - from) * uniform(fit_data::bits(study, 2 * k + 1));
        data.push_back(x < end ? observed(x) : right_censored(end));
    }
    return data;
}

} // namespace

TEST_CASE("goodness of fit: distances of the 350 as nortest", "[fragility][goodness_of_fit]")
{
    const auto data = fit_data::all_observed(fit_data::lognormal350);
    const Fit f = fit(Law::lognormal, data);
    CHECK(distances(f.law, data)->kolmogorov_smirnov == near(0.0295087763479));
    // nortest divides by n - 1
    const Distribution unbiased{Law::lognormal, -4.43578971603651, 0.476473225106621};
    const auto d = distances(unbiased, data);
    REQUIRE(d);
    CHECK(d->kolmogorov_smirnov == near(0.0292246753938));
    CHECK(d->anderson_darling == near(0.189502084652));
    CHECK(d->cramer_von_mises == near(0.03252415013));
}

TEST_CASE("goodness of fit: right-censored distances are the integrals up to the limit",
          "[fragility][goodness_of_fit]")
{
    const auto data = fit_data::stopped_at({0.4, 0.9, 1.1, 1.7, 2.6, 3.5, 4.1, 5.0}, 3.0);
    const Distribution law{Law::weibull, 0.9, 0.7};
    const auto d = distances(law, data);
    REQUIRE(d);
    const double end = cdf(law, 3.0);
    CHECK(d->cramer_von_mises ==
          Approx(integrated(law, data, end, [](double) { return 1.0; })).epsilon(1e-5));
    CHECK(d->anderson_darling == Approx(integrated(law, data, end, [](double f) {
                                     return 1.0 / (f * (1.0 - f));
                                 })).epsilon(1e-5));
    CHECK(d->kolmogorov_smirnov >= std::abs(end - 5.0 / 8.0));
}

TEST_CASE("goodness of fit: distances hardly change where runs end a little apart",
          "[fragility][goodness_of_fit]")
{
    const std::vector<double> values{0.4, 0.9, 1.1, 1.7, 2.6, 3.5, 4.1, 5.0};
    const Distribution law{Law::weibull, 0.9, 0.7};
    const auto common = distances(law, fit_data::stopped_at(values, 3.0));
    auto apart = fit_data::stopped_at(values, 3.0);
    for (std::size_t i = 5; i < 8; ++i) apart[i].lower = 3.0 + 1e-9 * static_cast<double>(i);
    const auto d = distances(law, apart);
    REQUIRE(common);
    REQUIRE(d);
    CHECK(d->kolmogorov_smirnov == Approx(common->kolmogorov_smirnov).epsilon(1e-7));
    CHECK(d->cramer_von_mises == Approx(common->cramer_von_mises).epsilon(1e-7));
    CHECK(d->anderson_darling == Approx(common->anderson_darling).epsilon(1e-7));
}

TEST_CASE("goodness of fit: where runs end far apart the distances are the integrals of Kaplan "
          "and Meier's estimate",
          "[fragility][goodness_of_fit]")
{
    const Distribution law{Law::weibull, 0.9, 0.7};
    for (const bool last_failed : {false, true}) {
        auto data = fit_data::all_observed({0.4, 1.1, 1.7, 2.6, 3.0});
        for (const double end : {0.7, 1.4, 2.9}) data.push_back(right_censored(end));
        if (!last_failed) data[4] = right_censored(3.0);
        const double end = last_failed ? 1.0 : cdf(law, 3.0);
        const auto d = distances(law, data);
        REQUIRE(d);
        CHECK(d->cramer_von_mises ==
              Approx(integrated(law, data, end, [](double) { return 1.0; })).epsilon(1e-5));
        CHECK(d->anderson_darling == Approx(integrated(law, data, end, [](double f) {
                                         return 1.0 / (f * (1.0 - f));
                                     })).epsilon(1e-5));
    }
}

TEST_CASE(
    "goodness of fit: where runs end a little apart, p of the right law is even in (0, 1)",
    "[fragility][goodness_of_fit][repeats]")
{
    const Distribution truth{Law::lognormal, 0.5, 0.6};
    constexpr int kStudies = 400;
    int below_tenth = 0, below_half = 0;
    for (std::uint64_t i = 0; i < kStudies; ++i) {
        const auto data = stopped_about(truth, 1000 + i, 40, 2.60, 2.73); // 22 % stopped
        const RandomBits bits = [i](std::uint64_t replicate, std::uint64_t draw) {
            return fit_data::bits(50'000'000 + 1'000 * i + replicate, draw);
        };
        const auto g = goodness_of_fit(fit(Law::lognormal, data), data, bits, 99);
        REQUIRE(g.available);
        below_tenth += g.p_anderson_darling <= 0.1;
        below_half += g.p_cramer_von_mises <= 0.5;
    }
    const auto even = [](double p) {
        return Approx(p).margin(3.0 * std::sqrt(p * (1.0 - p) / kStudies)).epsilon(0);
    };
    CHECK(below_tenth / double(kStudies) == even(0.1));
    CHECK(below_half / double(kStudies) == even(0.5));
}

TEST_CASE("goodness of fit: a wrong law is refused although runs end a little apart",
          "[fragility][goodness_of_fit]")
{
    const Distribution truth{Law::lognormal, 0.5, 0.6};
    const auto data = stopped_about(truth, 7, 200, 3.0, 3.2);
    const auto wrong = goodness_of_fit(fit(Law::normal, data), data, kBits, 500);
    CHECK(wrong.p_anderson_darling < 0.01);
    CHECK(wrong.p_cramer_von_mises < 0.01);
}

TEST_CASE("goodness of fit: p of the 350 by refits is that of the tables",
          "[fragility][goodness_of_fit]")
{
    const auto data = fit_data::all_observed(fit_data::lognormal350);
    const GoodnessOfFit g = goodness_of_fit(fit(Law::lognormal, data), data, kBits, 2000);
    REQUIRE(g.available);
    CHECK(g.replicates == 2000);
    // ad.test: 0.8995; lillie.test: 0.662 by formula, 0.678 by simulation; error 0.011
    CHECK(g.p_anderson_darling == Approx(0.8995).margin(0.03));
    CHECK(g.p_kolmogorov_smirnov == Approx(0.678).margin(0.04));
}

TEST_CASE("goodness of fit: a wrong law is refused, its own data are not",
          "[fragility][goodness_of_fit]")
{
    auto data = fit_data::all_observed(fit_data::lognormal350);
    data.resize(150);
    const GoodnessOfFit wrong = goodness_of_fit(fit(Law::normal, data), data, kBits, 500);
    CHECK(wrong.p_anderson_darling < 0.005);
    CHECK(wrong.p_cramer_von_mises < 0.005);
    auto stopped = fit_data::stopped_at(fit_data::lognormal350, 0.018);
    const GoodnessOfFit right =
        goodness_of_fit(fit(Law::lognormal, stopped), stopped, kBits, 200);
    CHECK(right.p_anderson_darling > 0.05);
    CHECK(right.p_kolmogorov_smirnov > 0.05);
}

TEST_CASE("goodness of fit: what cannot be judged says why", "[fragility][goodness_of_fit]")
{
    auto data = fit_data::all_observed({1, 2, 3, 4, 5});
    data.push_back(Observation{2, 3});
    const GoodnessOfFit g = goodness_of_fit(fit(Law::lognormal, data), data, kBits, 10);
    CHECK_FALSE(g.available);
    CHECK_FALSE(g.reason.empty());
    CHECK_FALSE(goodness_of_fit(fit(Law::lognormal, {}), {}, kBits, 10).available);
}
