#include "bits.hpp"
#include "dem/contact/pack.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

using dem::any;
using dem::FloatPack;
using dem::multiply_add;
using dem::Number;
using dem::Pack;
using dem::select;

/// Zeros of both signs, NaNs of both signs, infinities, the ends of the range, and plain numbers.
template <class T> std::vector<T> values()
{
    using limits = std::numeric_limits<T>;
    std::vector<T> v{T(0),
                     limits::quiet_NaN(),
                     limits::infinity(),
                     limits::denorm_min(),
                     limits::min(),
                     limits::max(),
                     limits::epsilon(),
                     T(1),
                     T(1) / T(3),
                     T(1e-6),
                     T(8.08e9)};
    for (std::size_t i = 0, n = v.size(); i < n; ++i) v.push_back(-v[i]);
    return v;
}

/// A pack of numbers drawn from `from`, and the same numbers one by one.
template <class P> struct Drawn {
    P pack{};
    std::vector<Number<P>> one;
    Drawn(const std::vector<Number<P>>& from, std::mt19937_64& random)
    {
        for (int i = 0; i < dem::lanes<P>; ++i) {
            one.push_back(from[random() % from.size()]);
            pack.set(i, one.back());
        }
    }
};

constexpr int kDraws = 4000; // of the 22^3 triples of values, in each lane

/// Calls check(a, b, c) with packs of all kinds of numbers, drawn lane by lane.
template <class P, class Check> void for_many(Check check)
{
    std::mt19937_64 random(7);
    const auto from = values<Number<P>>();
    for (int k = 0; k < kDraws; ++k) {
        const Drawn<P> a(from, random), b(from, random), c(from, random);
        check(a, b, c);
    }
}

/// Every lane of f(a, b, c) has the bits of f on the numbers of that lane.
template <class P, class F> void check_lanes(F f, bool (*same)(Number<P>, Number<P>))
{
    int different = 0;
    for_many<P>([&](const Drawn<P>& a, const Drawn<P>& b, const Drawn<P>& c) {
        const P together = f(a.pack, b.pack, c.pack);
        for (int i = 0; i < dem::lanes<P>; ++i)
            if (!same(together[i], f(a.one[i], b.one[i], c.one[i]))) {
                if (different++ == 0)
                    UNSCOPED_INFO("first: " << a.one[i] << ", " << b.one[i] << ", "
                                            << c.one[i]);
            }
    });
    CHECK(different == 0);
}

} // namespace

TEMPLATE_TEST_CASE("pack: select, min, max and abs pick the bits that the scalar ones pick",
                   "[dem][pack]", Pack, FloatPack)
{
    using T = Number<TestType>;
    check_lanes<TestType>([](auto a, auto b, auto) { return dem::min(a, b); }, bits::same<T>);
    check_lanes<TestType>([](auto a, auto b, auto) { return dem::max(a, b); }, bits::same<T>);
    check_lanes<TestType>([](auto a, auto, auto) { return dem::abs(a); }, bits::same<T>);
    check_lanes<TestType>([](auto a, auto b, auto c) { return select(a < b, b, c); },
                          bits::same<T>);
    check_lanes<TestType>([](auto a, auto b, auto c) { return select(a > b, b, c); },
                          bits::same<T>);
    check_lanes<TestType>(
        [](auto a, auto b, auto c) { return select((a < b) & (b < c), a, c); }, bits::same<T>);
    check_lanes<TestType>(
        [](auto a, auto b, auto c) { return select((a > b) | (b > c), a, c); }, bits::same<T>);
    check_lanes<TestType>([](auto a, auto, auto) { return -a; }, bits::same<T>);
}

TEMPLATE_TEST_CASE(
    "pack: min keeps its first number where the second is not smaller, max likewise",
    "[dem][pack]", double, float)
{
    const TestType nan = std::numeric_limits<TestType>::quiet_NaN(), zero = 0, one = 1;
    for (const auto pick : {dem::min<TestType>, dem::max<TestType>}) {
        CHECK(bits::same(pick(zero, -zero), zero));
        CHECK(bits::same(pick(-zero, zero), -zero));
        CHECK(bits::same(pick(one, nan), one));
        CHECK(std::isnan(pick(nan, one)));
    }
    CHECK(dem::min(zero, -one) == -one);
    CHECK(dem::max(zero, one) == one);
}

TEMPLATE_TEST_CASE("pack: each lane adds, multiplies and divides as a number does",
                   "[dem][pack]", Pack, FloatPack)
{
    using T = Number<TestType>;
    const auto same = bits::same_number<T>;
    check_lanes<TestType>([](auto a, auto b, auto) { return a + b; }, same);
    check_lanes<TestType>([](auto a, auto b, auto) { return a - b; }, same);
    check_lanes<TestType>([](auto a, auto b, auto) { return a * b; }, same);
    check_lanes<TestType>([](auto a, auto b, auto) { return a / b; }, same);
    check_lanes<TestType>([](auto a, auto b, auto) { return a += b; }, same);
    check_lanes<TestType>([](auto a, auto b, auto) { return a -= b; }, same);
    check_lanes<TestType>([](auto a, auto b, auto c) { return multiply_add(a, b, c); }, same);
    check_lanes<TestType>([](auto a, auto b, auto c) { return a * b + c; }, same);
}

TEMPLATE_TEST_CASE("pack: multiply_add rounds once, a product and a sum twice", "[dem][pack]",
                   double, float, Pack, FloatPack)
{
    using T = Number<TestType>;
    const T e = std::numeric_limits<T>::epsilon();
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

TEMPLATE_TEST_CASE(
    "pack: a number for all lanes is in all lanes, one for a lane in that lane alone",
    "[dem][pack]", Pack, FloatPack)
{
    using T = Number<TestType>;
    const T third = T(1) / T(3);
    for (int k = 0; k < dem::lanes<TestType>; ++k) {
        TestType x(third);
        for (int i = 0; i < dem::lanes<TestType>; ++i) REQUIRE(bits::same(x[i], third));
        x.set(k, -third);
        for (int i = 0; i < dem::lanes<TestType>; ++i)
            REQUIRE(bits::same(x[i], i == k ? -third : third));
        dem::set_lane(x, k, 2.0);
        for (int i = 0; i < dem::lanes<TestType>; ++i)
            REQUIRE(dem::lane(x, i) == (i == k ? 2.0 : third));
    }
    CHECK(dem::lanes<TestType> * sizeof(T) == sizeof(TestType));
}

TEMPLATE_TEST_CASE("pack: what is not a number in one lane stays there", "[dem][pack]", Pack,
                   FloatPack)
{
    using T = Number<TestType>;
    std::mt19937_64 random(3);
    const auto from = values<T>();
    const auto mixed = [](TestType a, TestType b, TestType c) {
        const TestType law = dem::max(-c, dem::min(c, multiply_add(a, b, c)));
        return select(dem::abs(a) > b, law, a * c - b / a) + law;
    };
    for (int k = 0; k < dem::lanes<TestType>; ++k)
        for (int draw = 0; draw < 100; ++draw) {
            Drawn<TestType> a(from, random), b(from, random), c(from, random);
            const TestType before = mixed(a.pack, b.pack, c.pack);
            for (TestType* x : {&a.pack, &b.pack, &c.pack})
                x->set(k, std::numeric_limits<T>::quiet_NaN());
            const TestType after = mixed(a.pack, b.pack, c.pack);
            CHECK(std::isnan(after[k]));
            for (int i = 0; i < dem::lanes<TestType>; ++i)
                if (i != k) REQUIRE(bits::same(before[i], after[i]));
        }
}

TEMPLATE_TEST_CASE("pack: any holds where a single lane does, and a NaN compares false",
                   "[dem][pack]", Pack, FloatPack)
{
    using T = Number<TestType>;
    const TestType zero(0), one(1);
    CHECK_FALSE(any(zero < zero));
    CHECK_FALSE(any(one < zero));
    CHECK_FALSE(any(zero > one));
    CHECK(any(zero < one));
    CHECK(any(one > zero));
    for (int k = 0; k < dem::lanes<TestType>; ++k) {
        TestType x = zero, nan = zero;
        x.set(k, -1);
        nan.set(k, std::numeric_limits<T>::quiet_NaN());
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
