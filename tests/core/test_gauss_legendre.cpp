#include "core/gauss_legendre.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace core;

namespace {

/// Relative error of the integral of x^degree over [-1, 1], for an even degree.
template <std::size_t Half> double error(const GaussRule<Half>& rule, int degree)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < Half; ++i)
        sum += 2.0 * rule.weight[i] * std::pow(rule.node[i], degree);
    return sum * (degree + 1) / 2.0 - 1.0;
}

template <std::size_t Half> void check(const GaussRule<Half>& rule)
{
    constexpr int kFirstWrong = static_cast<int>(4 * Half);
    for (int degree = 0; degree < kFirstWrong; degree += 2)
        CHECK(std::abs(error(rule, degree)) < 4e-15 * (1 + degree));
}

} // namespace

TEST_CASE("gauss_legendre: exact for polynomials up to twice the number of points",
          "[core][gauss_legendre]")
{
    check(kGauss16);
    check(kGauss20);
    check(kGauss30);
    CHECK(std::abs(error(kGauss16, 32)) > 1e-13);
}
