#include "uq/inference/bounded_normal.hpp"

#include "core/normal.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

struct Moments {
    double log_probability, mean, deviation;
};

/// By the trapezoidal rule with a million steps over all of d that counts.
Moments by_trapezia(const std::vector<uq::NoisyBound>& bounds, double mean, double variance)
{
    constexpr int kSteps = 1000000;
    const double sd = std::sqrt(variance);
    double most = mean;
    for (const uq::NoisyBound& b : bounds) most = std::max(most, b.at);
    const double from = mean - 10.0 * sd, width = (most + 10.0 * sd - from) / kSteps;
    const auto log_at = [&](double d) {
        const double x = (d - mean) / sd;
        double sum = -0.5 * (x * x + std::log(2.0 * std::numbers::pi * variance));
        for (const uq::NoisyBound& b : bounds) {
            const double z = (b.at - d) / b.deviation;
            sum += z < 37.0 ? std::log(core::normal_survival(z))
                            : -0.5 * (z * z + std::log(2.0 * std::numbers::pi)) - std::log(z);
        }
        return sum;
    };
    double highest = log_at(from);
    for (int i = 1; i <= kSteps; ++i) highest = std::max(highest, log_at(from + i * width));
    double zero = 0.0, one = 0.0, two = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double d = from + i * width, p = std::exp(log_at(d) - highest);
        zero += p;
        one += p * d;
        two += p * d * d;
    }
    const double m = one / zero;
    return {highest + std::log(zero * width), m, std::sqrt(two / zero - m * m)};
}

} // namespace

TEST_CASE("bounded normal: several bounds by panels, near and far, with errors large and small",
          "[uq][calibration]")
{
    const std::vector<std::vector<uq::NoisyBound>> all = {
        {{0.1, 0.1}, {-0.2, 0.2}},                // within the scatter
        {{0.3, 0.01}, {0.35, 0.01}},              // errors far below the scatter
        {{0.3, 0.002}, {0.5, 0.3}},               // and of two sizes
        {{0.02, 1e-4}, {0.0, 1e-4}, {0.01, 0.5}}, //
        {{1.2, 0.05}, {1.2, 0.05}},               // four deviations away
        {{2.3, 0.1}, {2.3, 0.1}, {2.0, 0.3}},     // eight
        {{4.0, 0.02}, {4.2, 0.05}},               // fourteen
    };
    for (const std::vector<uq::NoisyBound>& bounds : all) {
        INFO(bounds[0].at << ' ' << bounds[0].deviation);
        CHECK(uq::log_beyond(bounds, -0.05, 0.09) ==
              Approx(by_trapezia(bounds, -0.05, 0.09).log_probability).margin(1e-6));
    }
}

TEST_CASE("bounded normal: draws have the mean and the scatter of what the bounds leave, "
          "however rare it is",
          "[uq][calibration]")
{
    constexpr int kDraws = 4000;
    for (const std::vector<uq::NoisyBound>& bounds :
         {std::vector<uq::NoisyBound>{{0.2, 0.1}}, std::vector<uq::NoisyBound>{{1.5, 0.1}},
          std::vector<uq::NoisyBound>{{2.5, 0.01}, {2.4, 0.2}}}) {
        const Moments exact = by_trapezia(bounds, 0.0, 0.09);
        uq::Stream random(3, 0, uq::Purpose::prediction);
        double one = 0.0, two = 0.0;
        for (int i = 0; i < kDraws; ++i) {
            const double d = uq::draw_beyond(bounds, 0.0, 0.09, random) - exact.mean;
            one += d / kDraws;
            two += d * d / kDraws;
        }
        INFO(bounds[0].at << ' ' << exact.mean << ' ' << exact.deviation);
        CHECK(std::abs(one) < 4.0 * exact.deviation / std::sqrt(kDraws));
        CHECK(std::sqrt(two) == Approx(exact.deviation).epsilon(0.06));
    }
}
