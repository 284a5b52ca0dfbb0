#include "ground/intensity.hpp"
#include "ground/oscillator.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace {
constexpr double kPi = std::numbers::pi;
}

TEST_CASE("oscillator: a linear force moves it as the closed form says", "[ground][oscillator]")
{
    const double omega = GENERATE(0.5, 6.0, 90.0), zeta = GENERATE(0.0, 0.05, 0.7), rate = 3.0;
    const double step = 0.01, wd = omega * std::sqrt(1.0 - zeta * zeta);
    ground::Oscillator o(omega, zeta, step);
    constexpr int kSteps = 100;
    for (int i = 0; i < kSteps; ++i) o.advance(rate * step * i, rate * step * (i + 1));
    // p = r t from rest: u = r / w^2 (t - 2 z / w + e^(-z w t) (2 z / w cos wd t + (2 z^2 - 1)
    // / wd sin wd t))
    const double t = kSteps * step, k = omega * omega;
    const double wanted =
        rate / k *
        (t - 2.0 * zeta / omega +
         std::exp(-zeta * omega * t) * (2.0 * zeta / omega * std::cos(wd * t) +
                                        (2.0 * zeta * zeta - 1.0) / wd * std::sin(wd * t)));
    CHECK(o.u == Approx(wanted).epsilon(1e-9));
}

TEST_CASE("oscillator: free motion decays by exp(-2 pi zeta / sqrt(1 - zeta^2)) in a period",
          "[ground][oscillator]")
{
    const double zeta = 0.05, omega = 2.0 * kPi, damped = std::sqrt(1.0 - zeta * zeta);
    ground::Oscillator o(omega, zeta, 1.0 / damped / 50.0);
    o.u = 1.0;
    for (int i = 0; i < 50; ++i) o.advance(0.0, 0.0);
    CHECK(o.u == Approx(std::exp(-2.0 * kPi * zeta / damped)).epsilon(1e-12));
    CHECK(std::abs(o.v) < 1e-12);
}

TEST_CASE("oscillator: a low-pass keeps a slow sine, halves the power at its cut-off, stops a "
          "fast one",
          "[ground][oscillator]")
{
    const auto gain = [](double frequency) {
        constexpr double kStep = 0.001;
        std::vector<double> a;
        for (int i = 0; i < 60'000; ++i)
            a.push_back(std::sin(2.0 * kPi * frequency * kStep * i));
        double most = 0.0;
        const std::vector<double> passed = ground::low_passed(a, kStep, 1.0);
        for (std::size_t i = 40'000; i < passed.size(); ++i) most = std::max(most, passed[i]);
        return most;
    };
    CHECK(gain(0.1) == Approx(1.0 / std::sqrt(1.0 + 1e-4)).epsilon(1e-4));
    CHECK(gain(1.0) == Approx(std::sqrt(0.5)).epsilon(1e-4));
    CHECK(gain(10.0) == Approx(1.0 / std::sqrt(1.0 + 1e4)).epsilon(1e-2));
}
