#include "fragility/curve/limit_states.hpp"

#include "fragility/codes/code_table.hpp"
#include "tests/fragility/curve_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

using namespace fragility;
using scenes::OwnedCurve;

namespace {

auto near(double value) { return Approx(value).epsilon(1e-14).margin(0.0); }

/// All limit states of a code.
/// @param cap displacement at its drift limit; 0: none
std::vector<LimitState> states(const Curve& curve, std::string_view set,
                               const LimitStateOptions& options = {}, double cap = 0.0)
{
    const Code& code = *find_code(built_in_codes(), set);
    std::vector<double> caps;
    for (const CodeState& s : code.states) caps.push_back(s.drifts.empty() ? 0.0 : cap);
    return read_limit_states(curve, code, caps, options);
}

/// One limit state of a set, by name.
LimitState state(const Curve& curve, std::string_view set, std::string_view name,
                 const LimitStateOptions& options = {}, double cap = 0.0)
{
    for (const LimitState& s : states(curve, set, options, cap))
        if (s.name == name) return s;
    FAIL("no limit state " << name);
    return {};
}

void check_observed(const LimitDisplacement& x, double displacement)
{
    CHECK(x.reading == Reading::observed);
    CHECK(x.displacement == near(displacement));
}

void check_censored(const LimitDisplacement& x, double displacement)
{
    CHECK(x.reading == Reading::censored);
    CHECK(x.displacement == near(displacement));
    CHECK_FALSE(x.reason.empty());
}

void check_not_defined(const LimitDisplacement& x)
{
    CHECK(x.reading == Reading::not_defined);
    CHECK(x.displacement == 0.0);
    CHECK_FALSE(x.reason.empty());
}

constexpr std::string_view kPaper = "paper";
constexpr std::string_view kNtc = "ntc";
constexpr std::string_view kEc8 = "ec8";
const double kTriangleYield = 1.4 - std::sqrt(0.24); // see test_bilinear

} // namespace

TEST_CASE("limit states: a triangle has all of them in closed form",
          "[fragility][limit_states]")
{
    const OwnedCurve c = scenes::triangle();
    check_observed(state(c, kPaper, "ultimate").limit, 1.4);
    check_observed(state(c, kNtc, "SLC").limit, 1.4);
    check_observed(state(c, kNtc, "SLV").limit, 1.05);
    check_observed(state(c, kNtc, "SLD").limit, kTriangleYield);
    check_observed(state(c, kNtc, "SLO").limit, kTriangleYield * 2.0 / 3.0);
    check_observed(state(c, kEc8, "NC").limit, 1.4);
    check_observed(state(c, kEc8, "SD").limit, 1.05);
    check_observed(state(c, kEc8, "DL").limit, kTriangleYield);
    for (const std::string_view set : {kPaper, kNtc, kEc8})
        for (const LimitState& s : states(c, set)) CHECK(s.limit.reason.empty());
}

TEST_CASE("limit states: each set lists its own, mildest first", "[fragility][limit_states]")
{
    const auto names = [](std::string_view set) {
        std::vector<std::string> out;
        for (const LimitState& s : states(scenes::triangle(), set)) out.push_back(s.name);
        return out;
    };
    CHECK(names(kPaper) == std::vector<std::string>{"ultimate"});
    CHECK(names(kNtc) == std::vector<std::string>{"SLO", "SLD", "SLV", "SLC"});
    CHECK(names(kEc8) == std::vector<std::string>{"DL", "SD", "NC"});
}

TEST_CASE("limit states: without a drop the ultimate, its 3/4 and the yield are censored",
          "[fragility][limit_states]")
{
    const OwnedCurve c = scenes::elastic_plastic();
    check_censored(state(c, kPaper, "ultimate").limit, 10.0);
    check_censored(state(c, kNtc, "SLC").limit, 10.0);
    check_censored(state(c, kNtc, "SLV").limit, 7.5);
    check_censored(state(c, kNtc, "SLD").limit, 0.8); // of 1 up to the end
    check_censored(state(c, kNtc, "SLO").limit, 0.8 * 2.0 / 3.0);
    check_censored(state(c, kEc8, "SD").limit, 7.5);
    check_censored(state(c, kEc8, "DL").limit, 0.8);
    CHECK(state(c, kEc8, "DL").limit.reason ==
          "this value still depends on where the push ended; push further");
}

TEST_CASE("limit states: the bound of a yield holds however the push goes on",
          "[fragility][limit_states]")
{
    const double bound = state(scenes::elastic_plastic(), kEc8, "DL").limit.displacement;
    const double level = GENERATE(4.001, 4.5, 5.0, 6.0), end = GENERATE(10.5, 20.0, 500.0);
    const OwnedCurve longer{{0, 0}, {1, 5}, {10, 5}, {10.1, level}, {end, level}, {end, 0}};
    const LimitDisplacement dl = state(longer, kEc8, "DL").limit;
    CHECK(dl.reading == Reading::observed);
    CHECK(dl.displacement > bound);
}

TEST_CASE("limit states: a curve that ends on its elastic branch has not yielded",
          "[fragility][limit_states]")
{
    const LimitDisplacement sld = state(scenes::straight(), kNtc, "SLD").limit;
    CHECK(sld.reading == Reading::censored);
    CHECK(sld.displacement == Approx(0.8 * 3.0).epsilon(1e-7).margin(0.0));
    CHECK(state(scenes::straight(), kNtc, "SLO").limit.reading == Reading::censored);
}

TEST_CASE("limit states: the drift limit of the Italian code ends the curve where it comes "
          "first",
          "[fragility][limit_states]")
{
    // Up to 1.2 the triangle has 5 + 1.8 of energy; its fall to 80 % comes at 1.4.
    const OwnedCurve c = scenes::triangle();
    const LimitDisplacement slc = state(c, kNtc, "SLC", {}, 1.2).limit;
    check_observed(slc, 1.2);
    CHECK(slc.reason == "governed by the code's drift limit");
    check_observed(state(c, kNtc, "SLV", {}, 1.2).limit, 0.9);
    check_observed(state(c, kNtc, "SLD", {}, 1.2).limit,
                   1.2 - std::sqrt(1.44 - 2.0 * 6.9 / 10.0));
    check_observed(state(c, kNtc, "SLC", {}, 1.5).limit, 1.4);
    CHECK_FALSE(is_capped(state(c, kNtc, "SLC", {}, 1.5).limit));
}

TEST_CASE("limit states: the drift limit of EN 1998-3 ends the curve, and its rule sends the "
          "reader to the code",
          "[fragility][limit_states]")
{
    const OwnedCurve c = scenes::triangle(); // as for ntc below 1.4
    const LimitState nc = state(c, kEc8, "NC", {.slenderness = 1.5}, 1.2);
    check_observed(nc.limit, 1.2);
    CHECK(nc.limit.reason.find("compare with your copy of the code") != std::string::npos);
    CHECK(nc.rule.find("1.067 % x H0/D = 1.6 % if the wall rocks, 0.5333 % if not") !=
          std::string::npos);
    CHECK(nc.rule.find("compare with your copy of the code") != std::string::npos);
    check_observed(state(c, kEc8, "SD", {}, 1.2).limit, 0.9);
    check_observed(state(c, kEc8, "DL", {}, 1.2).limit,
                   1.2 - std::sqrt(1.44 - 2.0 * 6.9 / 10.0));
    check_observed(state(c, kEc8, "NC", {}, 1.5).limit, 1.4);
}

TEST_CASE("limit states: a drift limit is told from a displacement of the wall's own",
          "[fragility][limit_states]")
{
    const OwnedCurve c = scenes::triangle();
    CHECK(is_capped(state(c, kNtc, "SLC", {}, 1.2).limit));
    CHECK(is_capped(state(c, kNtc, "SLV", {}, 1.2).limit));
    CHECK(is_capped(state(c, kEc8, "SD", {}, 1.2).limit));
    CHECK_FALSE(is_capped(state(c, kNtc, "SLD", {}, 1.2).limit));
    CHECK_FALSE(is_capped(state(c, kNtc, "SLC", {}, 1.5).limit));
    CHECK_FALSE(is_capped(state(c, kPaper, "ultimate", {}, 1.2).limit));
    UserLimitState user;
    user.name = "near";
    user.ultimate = 1.0;
    user.at_most = 1.3;
    CHECK(is_capped(read_limit_states(c, {&user, 1}).front().limit));
    user.at_most = 1.5;
    CHECK_FALSE(is_capped(read_limit_states(c, {&user, 1}).front().limit));
    // a wall that has not come so far has not reached the limit
    CHECK_FALSE(
        is_capped(state(OwnedCurve{{0, 0}, {1, 5}, {4, 5}}, kNtc, "SLC", {}, 5.0).limit));
}

TEST_CASE("limit states: with a drift limit no limit state moves with where the push ends",
          "[fragility][limit_states]")
{
    const double end = GENERATE(5.0, 7.0, 100.0);
    const OwnedCurve c{{0, 0}, {1, 5}, {end, 5}};
    for (const LimitState& s : states(c, kNtc, {}, 5.0))
        CHECK(s.limit.reading == Reading::observed);
    check_observed(state(c, kNtc, "SLC", {}, 5.0).limit, 5.0);
    check_observed(state(c, kNtc, "SLD", {}, 5.0).limit, 1.0);
    check_censored(state(OwnedCurve{{0, 0}, {1, 5}, {4, 5}}, kNtc, "SLC", {}, 5.0).limit, 4.0);
}

TEST_CASE("limit states: SLD is the peak where the bilinear yields later",
          "[fragility][limit_states]")
{
    const OwnedCurve stiffens{{0, 0}, {1, 0.6}, {1.3, 1.0}, {3, 1}, {3.01, 0.7}};
    const LimitDisplacement sld = state(stiffens, kNtc, "SLD").limit;
    check_observed(sld, 1.3);
    CHECK(sld.reason == "the peak comes before the yield");
    CHECK(state(stiffens, kEc8, "DL").limit.displacement > 1.7);
}

TEST_CASE("limit states: the crossing, the drop and the share of the bilinear are choices",
          "[fragility][limit_states]")
{
    const LimitStateOptions last{.crossing = Crossing::last};
    check_observed(state(scenes::jerky(), kNtc, "SLC").limit, 1.0 + 2.0 / 3.0);
    check_observed(state(scenes::jerky(), kNtc, "SLC", last).limit, 3.0 + 1.0 / 3.0);
    CHECK(state(scenes::jerky(), kPaper, "ultimate").rule == "first drop to 80 % of the peak");
    CHECK(state(scenes::jerky(), kPaper, "ultimate", last).rule ==
          "last drop to 80 % of the peak");

    const LimitStateOptions half{.ultimate_share = 0.5};
    check_observed(state(scenes::triangle(), kPaper, "ultimate", half).limit, 2.0);
    CHECK(state(scenes::triangle(), kPaper, "ultimate", half).rule ==
          "first drop to 50 % of the peak");

    const OwnedCurve softening{{0, 0}, {1, 6}, {2, 10}, {8, 10}, {8, 0}};
    const LimitStateOptions peak_secant{.bilinear_share = 1.0};
    const double energy = 71.0; // up to 8
    check_observed(state(softening, kEc8, "DL").limit,
                   8.0 - std::sqrt(64.0 - 2.0 * energy / 6.0));
    check_observed(state(softening, kEc8, "DL", peak_secant).limit,
                   8.0 - std::sqrt(64.0 - 2.0 * energy / 5.0));
    CHECK(state(softening, kEc8, "DL").rule ==
          "yield of the equal-energy bilinear through 60 % of the peak");
}

TEST_CASE("limit states: what a curve does not have is not defined, with the reason",
          "[fragility][limit_states]")
{
    for (const std::string_view set : {kPaper, kNtc, kEc8})
        for (const LimitState& s : states(scenes::negative(), set)) {
            check_not_defined(s.limit);
            CHECK(s.limit.reason == "the force is nowhere positive");
        }
    check_not_defined(state(scenes::descending(), kNtc, "SLD").limit);
    check_not_defined(state(scenes::descending(), kNtc, "SLO").limit);
    check_observed(state(scenes::descending(), kNtc, "SLC").limit, 1.5);
    const OwnedCurve stiffens{{0, 0}, {1, 0.6}, {1.01, 1.0}, {1.02, 0.79}};
    CHECK(state(stiffens, kEc8, "DL").limit.reason == reason(BilinearOutcome::no_real_root));
}

TEST_CASE("limit states: 3/4 of the ultimate may come before the yield of a brittle curve",
          "[fragility][limit_states]")
{
    const OwnedCurve brittle{{0, 0}, {1, 10}, {1, 0}};
    CHECK(state(brittle, kNtc, "SLV").limit.displacement == near(0.75));
    CHECK(state(brittle, kNtc, "SLD").limit.displacement ==
          Approx(1.0).epsilon(1e-7).margin(0.0));
}

TEST_CASE("limit states: a bad curve and bad shares are refused", "[fragility][limit_states]")
{
    CHECK_THROWS_AS(states(OwnedCurve{}, kPaper), std::invalid_argument);
    const OwnedCurve c = scenes::triangle();
    CHECK_THROWS_AS(states(c, kPaper, {.ultimate_share = 1.0}), std::invalid_argument);
    CHECK_THROWS_AS(states(c, kNtc, {.bilinear_share = 0.0}), std::invalid_argument);
}
