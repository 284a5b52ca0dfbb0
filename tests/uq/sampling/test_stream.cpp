#include "uq/designs/stream.hpp"

#include "core/normal.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <vector>

using uq::Purpose;
using uq::Stream;

TEST_CASE("stream: is Philox 4x64-10, by the known answers of Random123", "[uq][stream]")
{
    // kat_vectors of Random123 1.14: philox4x64 10, counter and key all zero.
    CHECK(uq::bits(0, 0, Purpose{0}, 0) == 0x16554d9eca36314cULL);
    CHECK(uq::bits(0, 0, Purpose{0}, 1) == 0xdb20fe9d672d0fdcULL);
    CHECK(uq::bits(0, 0, Purpose{0}, 2) == 0xd7e772cee186176bULL);
    CHECK(uq::bits(0, 0, Purpose{0}, 3) == 0x7e68b68aec7ba23bULL);
}

TEST_CASE("stream: draw i is the same read in order and reached at once", "[uq][stream]")
{
    Stream s(7, 17, Purpose::monte_carlo);
    for (std::uint64_t i = 0; i < 50; ++i)
        CHECK(s.bits() == uq::bits(7, 17, Purpose::monte_carlo, i));
}

TEST_CASE("stream: seed, sample and purpose each give another stream", "[uq][stream]")
{
    std::set<std::uint64_t> first;
    for (std::uint64_t seed : {0, 1, 2})
        for (std::uint64_t sample : {0, 1, 2, 1000000})
            for (Purpose p : {Purpose::monte_carlo, Purpose::strata, Purpose::bootstrap})
                first.insert(Stream(seed, sample, p).bits());
    CHECK(first.size() == 36);
}

TEST_CASE("stream: uniform is inside (0, 1) and its mean and variance are 1/2 and 1/12",
          "[uq][stream]")
{
    Stream s(1, 2, Purpose::monte_carlo);
    const int n = 200000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < n; ++i) {
        const double u = s.uniform();
        REQUIRE(u > 0.0);
        REQUIRE(u < 1.0);
        sum += u;
        squares += (u - 0.5) * (u - 0.5);
    }
    CHECK(std::abs(sum / n - 0.5) < 4.0 * std::sqrt(1.0 / 12.0 / n));
    CHECK(std::abs(squares / n - 1.0 / 12.0) < 4.0 * std::sqrt(1.0 / 180.0 / n));
}

TEST_CASE("stream: many uniforms at once are those read one by one, wherever they start",
          "[uq][stream]")
{
    const std::size_t before = GENERATE(0u, 1u, 2u, 3u, 4u, 5u), n = GENERATE(0u, 1u, 4u, 11u);
    Stream one(1, 2, Purpose::field), many(1, 2, Purpose::field);
    for (std::size_t i = 0; i < before; ++i) CHECK(one.uniform() == many.uniform());
    std::vector<double> u(n);
    many.fill_uniform(u);
    for (const double x : u) CHECK(x == one.uniform());
    CHECK(many.bits() == one.bits()); // and both go on alike
    CHECK(many.normal() == core::normal_quantile(one.uniform()));
}

TEST_CASE("stream: below(n) gives each of 0 .. n - 1 equally often", "[uq][stream]")
{
    Stream s(3, 0, Purpose::strata);
    const std::uint64_t n = GENERATE(1, 2, 3, 7, 10);
    std::vector<int> count(n);
    for (int i = 0; i < 70000; ++i) ++count.at(s.below(n));
    const double expected = 70000.0 / static_cast<double>(n);
    double chi2 = 0.0;
    for (const int c : count) chi2 += (c - expected) * (c - expected) / expected;
    CHECK(chi2 < static_cast<double>(n) - 1.0 + 5.0 * std::sqrt(2.0 * static_cast<double>(n)));
}

TEST_CASE("stream: replicate 0 is the study itself, others differ", "[uq][stream]")
{
    CHECK(uq::replicate_seed(5, 0) == 5);
    CHECK(uq::replicate_seed(5, 1) != uq::replicate_seed(5, 2));
    CHECK(uq::replicate_seed(5, 1) != uq::replicate_seed(6, 1));
}
