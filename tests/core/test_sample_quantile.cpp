#include "core/sample_quantile.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace core;

TEST_CASE("sample quantile: linear between sorted values", "[core][sample_quantile]")
{
    const std::vector<double> v{1, 2, 4, 8};
    CHECK(sample_quantile(v, 0.0) == 1.0);
    CHECK(sample_quantile(v, 0.5) == 3.0);
    CHECK(sample_quantile(v, 1.0) == 8.0);
}

TEST_CASE("sample quantile: the unbiased one as R's type 8", "[core][sample_quantile]")
{
    // quantile(c(1, 2, 4, 8), p, type = 8)
    const std::vector<double> v{1, 2, 4, 8};
    CHECK(unbiased_quantile(v, 0.0) == 1.0);
    CHECK(unbiased_quantile(v, 0.25) == Approx(1.0 + 5.0 / 12.0).epsilon(1e-15));
    CHECK(unbiased_quantile(v, 0.5) == 3.0);
    CHECK(unbiased_quantile(v, 1.0) == 8.0);
    CHECK(unbiased_quantile(std::vector<double>{5.0}, 0.3) == 5.0);
}
