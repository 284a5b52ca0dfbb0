#include "dem/contact/pack.hpp"
#include "tests/dem/bits.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

using dem::any;
using dem::multiply_add;
using dem::Pack;
using dem::select;

/// Zeros of both signs, NaNs of both signs, infinities, the ends of the range, and plain
/// numbers.
std::vector<double> values()
{
    using limits = std::numeric_limits<double>;
    std::vector<double> v{0.0,
                          limits::quiet_NaN(),
                          limits::infinity(),
                          limits::denorm_min(),
                          limits::min(),
                          limits::max(),
                          limits::epsilon(),
                          1.0,
                          1.0 / 3.0,
                          1e-6,
                          8.08e9};
    for (std::size_t i = 0, n = v.size(); i < n; ++i) v.push_back(-v[i]);
    return v;
}

/// A pack of numbers drawn from `from`, and the same numbers one by one.
struct Drawn {
    Pack pack{};
    std::vector<double> one;
    Drawn(const std::vector<double>& from, std::mt19937_64& random)
    {
        for (int i = 0; i < dem::lanes<Pack>; ++i) {
            one.push_back(from[random() % from.size()]);
            pack.set(i, one.back());
        }
    }
};

constexpr int kDraws = 4000; // of the 22^3 triples of values, in each lane

/// Calls check(a, b, c) with packs of all kinds of numbers, drawn lane by lane.
template <class Check> void for_many(Check check)
{
    std::mt19937_64 random(7);
    const auto from = values();
    for (int k = 0; k < kDraws; ++k) {
        const Drawn a(from, random), b(from, random), c(from, random);
        check(a, b, c);
    }
}

/// Every lane of f(a, b, c) has the bits of f on the numbers of that lane.
template <class F> void check_lanes(F f, bool (*same)(double, double))
{
    int different = 0;
    for_many([&](const Drawn& a, const Drawn& b, const Drawn& c) {
        const Pack together = f(a.pack, b.pack, c.pack);
        for (int i = 0; i < dem::lanes<Pack>; ++i)
            if (!same(together[i], f(a.one[i], b.one[i], c.one[i]))) {
                if (different++ == 0)
                    UNSCOPED_INFO("first: " << a.one[i] << ", " << b.one[i] << ", "
                                            << c.one[i]);
            }
    });
    CHECK(different == 0);
}

} // namespace

TEST_CASE("pack: select, min, max and abs pick the bits that the scalar ones pick",
          "[dem][pack]")
{
    check_lanes([](auto a, auto b, auto) { return dem::min(a, b); }, bits::same<double>);
    check_lanes([](auto a, auto b, auto) { return dem::max(a, b); }, bits::same<double>);
    check_lanes([](auto a, auto, auto) { return dem::abs(a); }, bits::same<double>);
    check_lanes([](auto a, auto b, auto c) { return select(a < b, b, c); }, bits::same<double>);
    check_lanes([](auto a, auto b, auto c) { return select(a > b, b, c); }, bits::same<double>);
    check_lanes([](auto a, auto b, auto c) { return select((a < b) & (b < c), a, c); },
                bits::same<double>);
    check_lanes([](auto a, auto b, auto c) { return select((a > b) | (b > c), a, c); },
                bits::same<double>);
    check_lanes([](auto a, auto, auto) { return -a; }, bits::same<double>);
}

TEST_CASE("pack: min keeps its first number where the second is not smaller, max likewise",
          "[dem][pack]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), zero = 0, one = 1;
    for (const auto pick : {dem::min<double>, dem::max<double>}) {
        CHECK(bits::same(pick(zero, -zero), zero));
        CHECK(bits::same(pick(-zero, zero), -zero));
        CHECK(bits::same(pick(one, nan), one));
        CHECK(std::isnan(pick(nan, one)));
    }
    CHECK(dem::min(zero, -one) == -one);
    CHECK(dem::max(zero, one) == one);
}

TEST_CASE("pack: each lane adds, multiplies and divides as a number does", "[dem][pack]")
{
    const auto same = bits::same_number<double>;
    check_lanes([](auto a, auto b, auto) { return a + b; }, same);
    check_lanes([](auto a, auto b, auto) { return a - b; }, same);
    check_lanes([](auto a, auto b, auto) { return a * b; }, same);
    check_lanes([](auto a, auto b, auto) { return a / b; }, same);
    check_lanes([](auto a, auto b, auto) { return a += b; }, same);
    check_lanes([](auto a, auto b, auto) { return a -= b; }, same);
    check_lanes([](auto a, auto b, auto c) { return multiply_add(a, b, c); }, same);
    check_lanes([](auto a, auto b, auto c) { return a * b + c; }, same);
}

TEMPLATE_TEST_CASE("pack: multiply_add rounds once, a product and a sum twice", "[dem][pack]",
                   double, Pack)
{
    const double e = std::numeric_limits<double>::epsilon();
    TestType a{}, b{}, c{};
    for (int i = 0; i < dem::lanes<TestType>; ++i) {
        dem::set_lane(a, i, 1 + e);
        dem::set_lane(b, i, 1 - e);
        dem::set_lane(c, i, -1);
    }
    const TestType once = multiply_add(a, b, c), twice = a * b + c;
    for (int i = 0; i < dem::lanes<TestType>; ++i) {
        CHECK(dem::lane(once, i) == -e * e); // (1 + e)(1 - e) - 1
        CHECK(dem::lane(twice, i) == 0.0);
    }
}

TEST_CASE("pack: a number for all lanes is in all lanes, one for a lane in that lane alone",
          "[dem][pack]")
{
    const double third = 1.0 / 3.0;
    for (int k = 0; k < dem::lanes<Pack>; ++k) {
        Pack x(third);
        for (int i = 0; i < dem::lanes<Pack>; ++i) REQUIRE(bits::same(x[i], third));
        x.set(k, -third);
        for (int i = 0; i < dem::lanes<Pack>; ++i)
            REQUIRE(bits::same(x[i], i == k ? -third : third));
        dem::set_lane(x, k, 2.0);
        for (int i = 0; i < dem::lanes<Pack>; ++i)
            REQUIRE(dem::lane(x, i) == (i == k ? 2.0 : third));
    }
    CHECK(dem::lanes<Pack> * sizeof(double) == sizeof(Pack));
}

TEST_CASE("pack: what is not a number in one lane stays there", "[dem][pack]")
{
    std::mt19937_64 random(3);
    const auto from = values();
    const auto mixed = [](Pack a, Pack b, Pack c) {
        const Pack law = dem::max(-c, dem::min(c, multiply_add(a, b, c)));
        return select(dem::abs(a) > b, law, a * c - b / a) + law;
    };
    for (int k = 0; k < dem::lanes<Pack>; ++k)
        for (int draw = 0; draw < 100; ++draw) {
            Drawn a(from, random), b(from, random), c(from, random);
            const Pack before = mixed(a.pack, b.pack, c.pack);
            for (Pack* x : {&a.pack, &b.pack, &c.pack})
                x->set(k, std::numeric_limits<double>::quiet_NaN());
            const Pack after = mixed(a.pack, b.pack, c.pack);
            CHECK(std::isnan(after[k]));
            for (int i = 0; i < dem::lanes<Pack>; ++i)
                if (i != k) REQUIRE(bits::same_number(before[i], after[i]));
        }
}

TEST_CASE("pack: any holds where a single lane does, and a NaN compares false", "[dem][pack]")
{
    const Pack zero(0), one(1);
    CHECK_FALSE(any(zero < zero));
    CHECK_FALSE(any(one < zero));
    CHECK_FALSE(any(zero > one));
    CHECK(any(zero < one));
    CHECK(any(one > zero));
    for (int k = 0; k < dem::lanes<Pack>; ++k) {
        Pack x = zero, nan = zero;
        x.set(k, -1);
        nan.set(k, std::numeric_limits<double>::quiet_NaN());
        CHECK(any(x < zero));
        CHECK(any(zero > x));
        CHECK_FALSE(any(x > zero));
        CHECK(any((x < zero) | (one < zero)));
        CHECK(any((x < zero) & (zero < one)));
        CHECK_FALSE(any((x < zero) & (one < zero)));
        CHECK_FALSE(any((nan < zero) | (nan > zero)));
    }
    CHECK(any(true));
    CHECK_FALSE(any(false));
}
