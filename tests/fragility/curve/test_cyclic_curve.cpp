#include "fragility/curve/cyclic_curve.hpp"
#include "fragility/curve/first_loading.hpp"

#include "fragility/curve/curve_reading.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

using namespace fragility;

namespace {

struct OwnedPath {
    std::vector<double> displacement, force;
    operator Path() const { return {displacement, force}; } // NOLINT: a view, as in scenes
};

/// A sliding joint of stiffness k and strength s, driven through the targets, with points where
/// it begins to slide.
OwnedPath sliding(double k, double s, const std::vector<double>& targets)
{
    OwnedPath p{{0.0}, {0.0}};
    for (const double to : targets) {
        const double from = p.displacement.back(), f = p.force.back();
        const double way = to > from ? 1.0 : -1.0;
        const double slides = from + (way * s - f) / k;
        if (way * (to - slides) > 0.0) {
            if (from * slides < 0.0) { // the zero between, as a recorder writes it
                p.displacement.push_back(0.0);
                p.force.push_back(f - k * from);
            }
            p.displacement.push_back(slides);
            p.force.push_back(way * s);
            p.displacement.push_back(to);
            p.force.push_back(way * s);
        } else {
            p.displacement.push_back(to);
            p.force.push_back(f + k * (to - from));
        }
    }
    return p;
}

auto near(double value) { return Approx(value).epsilon(1e-12).margin(1e-12); }

} // namespace

TEST_CASE("cyclic curve: the loop of a sliding joint has its exact energy and damping",
          "[fragility][cyclic]")
{
    const double k = 8.0, s = 2.0, d = 1.5;
    const auto c = cycles(sliding(k, s, {d, -d, d, -d, d, -d, 0.0}));
    REQUIRE(c.size() == 3);
    // the second: the first begins on the virgin branch
    CHECK(c[1].energy == near(4.0 * s * (d - s / k)));
    CHECK(equivalent_damping(c[1]).value() ==
          near(2.0 / std::numbers::pi * (1.0 - s / (k * d))));
    CHECK(c[1].displacement_plus == d);
    CHECK(c[1].displacement_minus == -d);
    CHECK(amplitude(c[1]) == d);
    CHECK(c[1].residual_plus.value() == near(d - s / k));
    CHECK(c[1].residual_minus.value() == near(-d + s / k));
    CHECK(secant_stiffness(c[1]).value() == near(s / d));
    CHECK(c[1].closed);
}

TEST_CASE("cyclic curve: a cycle that goes out again on one side has no damping",
          "[fragility][cyclic]")
{
    const double k = 8.0, s = 2.0;
    const auto c = cycles(sliding(k, s, {5.0, 1.0, 5.0, 1.0, 0.0, 5.0, 0.0}));
    REQUIRE(c.size() == 2);
    CHECK(c[0].closed);
    CHECK(c[0].inner_loop);
    CHECK_FALSE(equivalent_damping(c[0])); // 4 s (5 - 1 - s / k) twice, over pi s 5
    CHECK(equivalent_damping(c[1]).has_value());
    // a sensor's jitter, and a small unloading on the way out, are no loop
    CHECK_FALSE(cycles(sliding(k, s, {3.0, 2.95, 5.0, 4.95, 5.0, 0.0}))[0].inner_loop);
}

TEST_CASE("cyclic curve: a cycle ends at zero displacement, whether or not a point lies there",
          "[fragility][cyclic]")
{
    const double k = 8.0, s = 2.0;
    const OwnedPath p = sliding(k, s, {0.6, -0.6, 1.0, -1.0, 1.5, -1.5, 1.5, -1.5, 0.0});
    OwnedPath sparse{{0.0}, {0.0}}, whole = sparse;
    for (std::size_t i = 1; i < p.force.size(); ++i) {
        const double x = p.displacement[i], f = p.force[i];
        if (x == 0.0 && i + 1 < p.force.size()) continue;
        const double before = sparse.displacement.back();
        if (before * x < 0.0) { // a point at zero
            whole.displacement.push_back(0.0);
            whole.force.push_back(f - (f - sparse.force.back()) * x / (x - before));
        }
        for (OwnedPath* const path : {&sparse, &whole}) {
            path->displacement.push_back(x);
            path->force.push_back(f);
        }
    }
    REQUIRE(sparse.force.size() < whole.force.size());
    const auto with = cycles(whole), without = cycles(sparse);
    REQUIRE(with.size() == 4);
    REQUIRE(without.size() == 4);
    for (std::size_t i = 0; i < with.size(); ++i) {
        CHECK(without[i].energy == near(with[i].energy));
        CHECK(equivalent_damping(without[i]).value() ==
              near(equivalent_damping(with[i]).value()));
    }
    // the second: out from zero, where friction holds with s, and back the same way
    CHECK(without[1].energy == near(4.0 * s * (1.0 - s / k)));
    CHECK(without[1].end_share == Approx(0.25));
}

TEST_CASE("cyclic curve: what goes back the way it came has no energy and no residual",
          "[fragility][cyclic]")
{
    const OwnedPath p{{0, 1, 4, 1, 0, -1, -4, -1, 0}, {0, 3, 5, 3, 0, -3, -5, -3, 0}};
    const auto c = cycles(p);
    REQUIRE(c.size() == 1);
    CHECK(c[0].energy == 0.0);
    CHECK(c[0].residual_plus.value() == 0.0);
    CHECK(c[0].residual_minus.value() == 0.0);
    CHECK(equivalent_damping(c[0]).value() == 0.0);
    CHECK(c[0].force_plus == 5.0);
    CHECK(c[0].force_minus == -5.0);
}

TEST_CASE("cyclic curve: the force may come back to zero on the way into the next cycle",
          "[fragility][cyclic]")
{
    const auto c = cycles(OwnedPath{{0, 2, -2, -0.5, 0.5, 2, -2, 0}, //
                                    {0, 4, -4, -1.5, 0.5, 4, -4, -0.01}});
    REQUIRE(c.size() == 2);
    CHECK(c[0].residual_minus.value() == near(0.25));
    CHECK(c[1].residual_minus.value() == 0.0); // no way on, and no force to speak of
    CHECK_FALSE(cycles(OwnedPath{{0, 2, -2, 0}, {0, 4, -4, -0.03}})[0].residual_minus);
    // One side: the way ends at zero, where it turns.
    CHECK_FALSE(cycles(OwnedPath{{0, 2, 0, 3}, {0, 4, 1, -1}})[0].residual_plus);
}

TEST_CASE(
    "cyclic curve: damping and stiffness are those of the extremes, not of the peak forces",
    "[fragility][cyclic]")
{
    const auto c = cycles(OwnedPath{{0, 1, 2, 0, -1, -2, 0}, {0, 5, 3, 0, -5, -3, 0}});
    REQUIRE(c.size() == 1);
    CHECK(c[0].energy == near(2.0 * (2.5 + 4.0 - 3.0)));
    CHECK(c[0].force_plus == 5.0);
    CHECK(c[0].force_minus == -5.0);
    CHECK(secant_stiffness(c[0]).value() == near(1.5));
    CHECK(equivalent_damping(c[0]).value() == near(7.0 / (2.0 * std::numbers::pi * 3.0 * 2.0)));
}

TEST_CASE("cyclic curve: cycles are parted where the path comes back to zero",
          "[fragility][cyclic]")
{
    SECTION("the side that came first begins each")
    {
        const auto c =
            cycles(OwnedPath{{0, -1, 0, 1, 0, -2, 0, 2, 0}, {0, -1, 0, 1, 0, -2, 0, 2, 0}});
        REQUIRE(c.size() == 2);
        CHECK(c[0].begin == 0);
        CHECK(c[0].end == 4);
        CHECK(c[1].displacement_minus == -2.0);
    }
    SECTION("cycles of one side")
    {
        const auto c = cycles(OwnedPath{{0, 1, 0, 2, 0, 3}, {0, 2, 0, 3, 0, 4}});
        REQUIRE(c.size() == 3);
        CHECK(c[1].displacement_plus == 2.0);
        CHECK(c[1].displacement_minus == 0.0);
        CHECK(amplitude(c[1]) == 2.0);
        CHECK_FALSE(c[2].closed);
        CHECK_FALSE(c[2].residual_plus);
    }
    SECTION("a side that comes twice is no pair with the other")
    {
        const auto c =
            cycles(OwnedPath{{0, 1, 0, -1, 0, -2, 0, 2, 0}, {0, 1, 0, -1, 0, -2, 0, 2, 0}});
        REQUIRE(c.size() == 3);
        CHECK(c[1].displacement_minus == -2.0);
        CHECK(c[1].displacement_plus == 0.0);
        CHECK(c[2].displacement_plus == 2.0);
    }
    SECTION("no point at zero")
    {
        const auto c = cycles(OwnedPath{{0, 2, -2, 3, -3}, {0, 1, -1, 1, -1}});
        REQUIRE(c.size() == 2);
        CHECK(c[0].closed);
        CHECK(c[1].begin == 2);
        CHECK_FALSE(c[1].closed);
    }
    SECTION("no point at zero before a cycle of one side, which has no other extreme")
    {
        // as a recorder writes it: the point before lies on the side that the path comes from
        for (const double sign : {1.0, -1.0}) {
            OwnedPath p{{0, 3, 3, 0.1, -0.1, -3, -3, -0.1, 0.1, 8, 8, 0},
                        {0, 2, -2, -2, -2, -2, 2, 2, 2, 2, -2, -2}};
            for (double& d : p.displacement) d *= sign;
            for (double& f : p.force) f *= sign;
            const auto c = cycles(p);
            REQUIRE(c.size() == 2);
            const Cycle& last = c.back();
            CHECK(amplitude(last) == 8.0);
            CHECK(last.displacement_plus - last.displacement_minus == 8.0);
            CHECK(last.force_at_plus == (sign > 0.0 ? 2.0 : 0.0));
            CHECK(last.force_at_minus == (sign > 0.0 ? 0.0 : -2.0));
            CHECK(secant_stiffness(last).value() == near(2.0 / 8.0));
            CHECK(equivalent_damping(last).value() ==
                  near(last.energy / (std::numbers::pi * 16.0)));
        }
    }
    SECTION("a path that ends beside zero has come back")
    {
        CHECK(cycles(OwnedPath{{0, 2, -2, -0.019}, {0, 1, -1, 0}}).back().closed);
        CHECK_FALSE(cycles(OwnedPath{{0, 2, -2, -0.021}, {0, 1, -1, 0}}).back().closed);
    }
    SECTION("a path that stays at zero has none")
    {
        CHECK(cycles(OwnedPath{{0, 0}, {0, 1}}).empty());
    }
}

TEST_CASE("cyclic curve: the energies of all cycles are the work of the path",
          "[fragility][cyclic]")
{
    const OwnedPath p = sliding(5.0, 1.0, {1, -1, 2, -2, 3, -3, 0});
    double all = 0.0, work = 0.0;
    for (const Cycle& c : cycles(p)) all += c.energy;
    for (std::size_t i = 1; i < p.force.size(); ++i)
        work +=
            0.5 * (p.force[i] + p.force[i - 1]) * (p.displacement[i] - p.displacement[i - 1]);
    CHECK(all == near(work));
}

TEST_CASE("cyclic curve: the backbone is what lies farther out than all before",
          "[fragility][cyclic]")
{
    // +1 at 4, back, again to 1 at 3 (weaker), on to 2 at 5; the left side never beyond -1
    const OwnedPath p{{0, 1, 0, -1, 0, 1, 2, 0}, {0, 4, 0, -6, 0, 3, 5, 0}};
    const Backbone right = backbone(p, 1), left = backbone(p, -1);
    CHECK(right.displacement == std::vector<double>{0, 1, 2});
    CHECK(right.force == std::vector<double>{0, 4, 5});
    CHECK(left.displacement == std::vector<double>{0, 1});
    CHECK(left.force == std::vector<double>{0, 6});
    CHECK_NOTHROW(check({right.displacement, right.force}));
    CHECK(peak({right.displacement, right.force}).force == 5.0);
}

TEST_CASE("cyclic curve: reloading is left out of the backbone, strength that is lost is not",
          "[fragility][cyclic]")
{
    // from 4 at 1 down to 3 when it is there again; 3.2 at 2, then down to 2 at 3
    const OwnedPath p{{0, 1, 0, 1, 1.5, 2, 3}, {0, 4, 0, 3, 3.7, 3.2, 2}};
    const Backbone b = backbone(p, 1);
    CHECK(b.displacement == std::vector<double>{0, 1, 1.5, 2, 3});
    CHECK(b.force == std::vector<double>{0, 4, 3.7, 3.2, 2});
    const OwnedPath weaker{{0, 1, 0, 1, 2}, {0, 4, 0, 3, 2.5}};
    CHECK(backbone(weaker, 1).force == std::vector<double>{0, 4, 3, 2.5});
}

TEST_CASE("cyclic curve: reloading is left out of the backbone in every cycle",
          "[fragility][cyclic]")
{
    const OwnedPath p{{0, 1, 0, 1, 1.5, 2, 0, 2, 3}, {0, 4, 0, 3, 3.2, 5, 0, 4, 6}};
    CHECK(backbone(p, 1).displacement == std::vector<double>{0, 1, 2, 3});
    CHECK(backbone(p, 1).force == std::vector<double>{0, 4, 5, 6});
}

TEST_CASE("cyclic curve: the first loading of a side begins where its force is zero",
          "[fragility][cyclic]")
{
    const OwnedPath far = sliding(4.0, 4.0, {3.0, -3.0, 0.0}); // slides beyond 1
    CHECK(first_loading(far, -1, 0.4).residual == near(2.0));
    CHECK(first_loading(far, -1, 0.4).force == near(4.0));
    CHECK(first_loading(far, 1, 0.4).residual == 0.0); // loaded first
    CHECK(first_loading(far, 1, 0.4).force == 0.0);
    const OwnedPath little = sliding(4.0, 4.0, {1.25, -3.0, 0.0});
    CHECK(first_loading(little, -1, 2.0).residual == near(0.25));
    CHECK(first_loading(little, -1, 2.0).force == near(1.0));
    const OwnedPath elastic = sliding(4.0, 4.0, {0.5, -0.5, 0.0});
    CHECK(first_loading(elastic, -1, 0.4).force == 0.0);
    const OwnedPath mirrored = sliding(4.0, 4.0, {-1.25, 3.0, 0.0});
    CHECK(first_loading(mirrored, 1, 2.0).residual == near(0.25));
    const OwnedPath one_side{{0, 1, 0.5, 1}, {0, 4, -1, 3}};
    CHECK(first_loading(one_side, -1, 0.4).force == 0.0); // never goes there
    CHECK(first_loading(one_side, 1, 0.4).force == 0.0);
    CHECK(first_loading(far, -1, 0.4).reach == 0.0); // comes there with all its force
    CHECK(first_loading(far, 1, 0.4).reach == 3.0);
    CHECK(first_loading(little, -1, 2.0).reach == near(3.0));
    const OwnedPath grows = sliding(4.0, 4.0, {0.5, -0.5, 3.0, -3.0, 0.0});
    CHECK(first_loading(grows, 1, 0.4).reach == near(3.0));
    CHECK(first_loading(grows, -1, 0.4).reach == near(0.5));
    CHECK_THROWS_AS(first_loading(far, 0, 0.4), std::invalid_argument);
}

TEST_CASE("cyclic curve: from its own zero a sliding side has the stiffness of the other one",
          "[fragility][cyclic]")
{
    const OwnedPath path = sliding(4.0, 4.0, {1.25, -3.0, 0.0});
    const Backbone left = backbone(path, -1);
    const Backbone own =
        from_own_zero({left.displacement, left.force}, first_loading(path, -1, 2.0).residual);
    CHECK(own.displacement.back() == near(3.25));
    CHECK(*secant_stiffness({own.displacement, own.force}) == near(4.0));
    CHECK(*secant_stiffness({left.displacement, left.force}) > 4.1);
}

TEST_CASE("cyclic curve: a wall that is held at rest has one elastic stiffness",
          "[fragility][cyclic]")
{
    // force 24 x - 3 within 1 of zero displacement: it acts with the push to the right at rest
    const auto force = [](double x) { return std::clamp(24.0 * x - 3.0, -27.0, 21.0); };
    const double amplitude = GENERATE(0.1, 0.5); // before and behind where the force is zero
    OwnedPath path;
    for (const double turn : {amplitude, -amplitude, 2.0, -2.0, 0.0}) {
        const double from = path.displacement.empty() ? 0.0 : path.displacement.back();
        for (int i = path.displacement.empty() ? 0 : 1; i <= 40; ++i) {
            path.displacement.push_back(from + (turn - from) * i / 40.0);
            path.force.push_back(force(path.displacement.back()));
        }
    }
    for (const int direction : {1, -1}) {
        const fragility::FirstLoading first = first_loading(path, direction, 0.4);
        CHECK(first.residual == near(-direction * 3.0 / 24.0));
        CHECK(first.force == near(0.0));
        CHECK(first.turn == near(amplitude));
        CHECK(first.reach == near(2.0));
        const Backbone side = backbone(path, direction);
        const fragility::Curve curve{side.displacement, side.force};
        const Backbone own = from_own_zero(curve, first.residual);
        const double share = share_within(curve, first.turn, 0.3);
        CHECK(*secant_stiffness({own.displacement, own.force}, share) == near(24.0));
        CHECK(residual_at_rest(curve) == 0.0); // begins at the origin, as backbones do
    }
    const std::vector<double> x = {0.0, 0.1, 0.2, 1.0}, up = {3.0, 5.4, 7.8, 27.0},
                              down = {-3.0, -0.6, 1.8, 21.0};
    CHECK(residual_at_rest({x, up}) == near(0.125));
    CHECK(residual_at_rest({x, down}) == near(-0.125));
}

TEST_CASE("cyclic curve: the worse of two displacements is the one that surely comes first",
          "[fragility][cyclic]")
{
    const LimitDisplacement seen3{3.0, Reading::observed, {}},
        seen5{5.0, Reading::observed, {}}, after4{4.0, Reading::censored, {}}, none{};
    const auto is = [](const LimitDisplacement& d, double x, Reading r) {
        return d.displacement == x && d.reading == r;
    };
    CHECK(is(worse(seen3, seen5), 3.0, Reading::observed));
    CHECK(is(worse(after4, seen3), 3.0, Reading::observed));
    CHECK(is(worse(seen5, after4), 4.0, Reading::censored)); // the other may come between
    CHECK(worse(seen3, none).reading == Reading::not_defined);
    const LimitDisplacement after3{3.0, Reading::censored, {}};
    CHECK(is(worse(after3, seen3), 3.0, Reading::observed));
    CHECK(is(worse(seen3, after3), 3.0, Reading::observed));
}

TEST_CASE("cyclic curve: the mean backbone reaches as far as both", "[fragility][cyclic]")
{
    const Backbone m = mean({{0, 1, 3}, {0, 4, 8}}, {{0, 2}, {0, 6}});
    CHECK(m.displacement == std::vector<double>{0, 1, 2});
    CHECK(m.force == std::vector<double>{0, 3.5, 6});
    const Backbone stepped = mean({{0, 2, 2, 3}, {0, 8, 4, 4}}, {{0, 2, 3}, {0, 6, 6}});
    CHECK(stepped.displacement == std::vector<double>{0, 2, 2, 3});
    CHECK(stepped.force == std::vector<double>{0, 7, 5, 5});
}

TEST_CASE("cyclic curve: a push one way is its own backbone, bit for bit",
          "[fragility][cyclic]")
{
    const OwnedPath p{{0, 0.1, 0.25, 0.7}, {0.0, 3.3, 4.4, 1.1}};
    CHECK(backbone(p, 1).displacement == p.displacement);
    CHECK(backbone(p, 1).force == p.force);
}

TEST_CASE("cyclic curve: wrong input is refused", "[fragility][cyclic]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(cycles(OwnedPath{{0, 1}, {0}}), std::invalid_argument);
    CHECK_THROWS_AS(cycles(OwnedPath{{0, nan}, {0, 1}}), std::invalid_argument);
    CHECK_THROWS_AS(backbone(OwnedPath{{0, 1}, {0, 1}}, 0), std::invalid_argument);
}
