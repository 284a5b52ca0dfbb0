#include "fragility/curve/limit_states.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

using fragility::Reading;
using fragility::UserLimitState;

namespace {

/// Up to 10 at 1, level to 4, down to 2 at 8: d_y = 1 (straight up to the peak), peak at 1,
/// drop to 80 % at 5.
constexpr std::array kX{0.0, 1.0, 4.0, 8.0}, kF{0.0, 10.0, 10.0, 2.0};

fragility::LimitDisplacement read(const UserLimitState& s, double end = 8.0)
{
    std::vector<double> x(kX.begin(), kX.end()), f(kF.begin(), kF.end());
    if (end < 8.0) {
        x.resize(3);
        f.resize(3);
        x.back() = end; // stops on the plateau
    }
    return fragility::read_limit_states({x, f}, std::array{s}).front().limit;
}

UserLimitState rule(double yield, double peak, double ultimate)
{
    UserLimitState s;
    s.name = "own";
    s.yield = yield;
    s.peak = peak;
    s.ultimate = ultimate;
    return s;
}

} // namespace

TEST_CASE("user limit states: a sum takes its displacements as often as asked for",
          "[fragility][user_limit_states]")
{
    CHECK(read(rule(0.0, 0.0, 1.0)).displacement == Approx(5.0).epsilon(1e-14));
    CHECK(read(rule(0.0, 2.0, 0.5)).displacement == Approx(4.5).epsilon(1e-14));
    // equal energy up to 5: (5 + 30 + 9) = 10 ... of k = 10: d_y = 5 - sqrt(25 - 2 * 44 / 10)
    const double yield = 5.0 - std::sqrt(25.0 - 2.0 * (5.0 + 30.0 + 9.0) / 10.0);
    CHECK(read(rule(0.7, 0.0, 0.0)).displacement == Approx(0.7 * yield).epsilon(1e-12));
}

TEST_CASE("user limit states: a sum with a part that was not reached is a lower bound",
          "[fragility][user_limit_states]")
{
    const auto limit = read(rule(0.0, 1.0, 1.0), 3.0);
    CHECK(limit.reading == Reading::censored);
    CHECK(limit.displacement == Approx(1.0 + 3.0).epsilon(1e-14));
}

TEST_CASE("user limit states: shares of the peak are read before and after it",
          "[fragility][user_limit_states]")
{
    UserLimitState s;
    s.name = "own";
    s.rise = 0.5;
    CHECK(read(s).displacement == Approx(0.5).epsilon(1e-14));
    s.rise.reset();
    s.drop = 0.5;
    CHECK(read(s).displacement == Approx(6.5).epsilon(1e-14));
    CHECK(read(s, 3.0).reading == Reading::censored);
}

TEST_CASE("user limit states: a cap counts where it comes first, and is reached only where the "
          "curve gets so far",
          "[fragility][user_limit_states]")
{
    UserLimitState s = rule(0.0, 0.0, 1.0);
    s.at_most = 3.5;
    CHECK(read(s).displacement == 3.5);
    CHECK(read(s).reading == Reading::observed);
    CHECK(read(s, 3.0).reading == Reading::censored);
    CHECK(read(s, 3.0).displacement == 3.0);
    s.at_most = 6.0;
    CHECK(read(s).displacement == Approx(5.0).epsilon(1e-14));
    s = {};
    s.name = "cap alone";
    s.at_most = 2.0;
    CHECK(read(s).displacement == 2.0);
    CHECK(read(s).reading == Reading::observed);
}

TEST_CASE("user limit states: a state without rule, with two, or with shares out of range is "
          "refused by name",
          "[fragility][user_limit_states]")
{
    UserLimitState none, two = rule(1.0, 0.0, 0.0), share;
    none.name = "none";
    two.drop = 0.5;
    share.name = "share";
    share.drop = 1.0;
    UserLimitState cap;
    cap.name = "cap";
    cap.at_most = -1.0;
    for (const UserLimitState& s : {none, two, share, cap})
        CHECK_THROWS_WITH(read(s), Catch::Contains("\"" + s.name + "\""));
}
