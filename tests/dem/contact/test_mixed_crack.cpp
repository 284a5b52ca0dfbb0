/// The law of mixed modes at one contact: closed forms, energies on any path, and its two
/// readings.

#include "dem/solver/state/lane_laws.hpp"
#include "tests/dem/bits.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using dem::CrackLaw;
using dem::CrackMaterial;
using dem::CrackState;
using dem::Envelope;
using dem::lanes;
using dem::MixedLaw;
using dem::Pack;

constexpr double kFt = 2.5e6, kC = 3e6, kG1 = 110.0, kG2 = 440.0, kTan = 0.6;

CrackMaterial stone()
{
    CrackMaterial c{};
    c.kn = 1e11;
    c.ks = 1e11;
    c.ft = kFt;
    c.cohesion = kC;
    c.tan_phi = c.tan_phi_res = kTan;
    c.fracture_energy = kG1;
    c.envelope = Envelope::hyperbolic;
    c.shear_fracture_energy = kG2;
    return c;
}

/// One contact, what was put into it and what it lost [J/m2].
struct Crack {
    CrackLaw<double> law;
    MixedLaw<double> mixed;
    CrackState<double> state;
    double work_normal = 0.0, work_shear = 0.0, friction = 0.0, fracture = 0.0;
    double largest_tau = 0.0, least_loss = 0.0; ///< [Pa], of one step [J/m2]

    explicit Crack(const CrackMaterial& c)
        : law(dem::crack_law(c)), mixed(dem::mixed_law(c)), state(dem::intact(law))
    {
    }
    void move(double to_n, double by_s, int steps = 20000)
    {
        const double du_n = (to_n - state.u_n) / steps, du_s = by_s / steps;
        for (int i = 0; i < steps; ++i) {
            const auto before = state;
            const auto [after, loss] = dem::advance(law, mixed, state, du_n, du_s);
            state = after;
            friction += loss.friction;
            fracture += loss.fracture;
            work_normal += 0.5 * (before.sigma + after.sigma) * (after.u_n - before.u_n);
            work_shear += 0.5 * (before.tau + after.tau) * du_s;
            largest_tau = std::max(largest_tau, std::abs(after.tau));
            least_loss = std::min({least_loss, loss.friction, loss.fracture});
        }
    }
    /// Lost through sigma, and through tau less friction.
    [[nodiscard]] double lost_in_tension() const
    {
        return work_normal - 0.5 * state.sigma * state.u_n;
    }
    [[nodiscard]] double lost_in_shear() const
    {
        return work_shear - 0.5 * state.tau * state.tau * law.inv_ks - friction;
    }
    [[nodiscard]] double damage() const { return dem::damage(law, state); }
    /// Largest shear stress at this opening.
    [[nodiscard]] double limit() const
    {
        return dem::shear_limit(law, mixed, state.integrity, state.u_max, state.u_n,
                                state.sigma)
            .at(state.integrity);
    }
};

double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Both envelopes, gradual and brittle, with and without residual cohesion and friction that
/// drops.
CrackMaterial some_material(std::mt19937_64& random)
{
    CrackMaterial c = stone();
    c.kn = (4.0 + 8.0 * uniform(random)) * 1e10;
    c.ks = 0.4 * c.kn;
    c.ft = (0.5 + 4.0 * uniform(random)) * 1e6;
    c.cohesion = (0.5 + 1.5 * uniform(random)) * c.ft;
    c.cohesion_res = random() % 3 ? 0.0 : 0.2 * c.cohesion;
    c.tan_phi = 0.4 + 0.8 * uniform(random);
    c.tan_phi_res = random() % 3 ? c.tan_phi : 0.7 * c.tan_phi;
    c.fracture_energy = random() % 4 ? 110.0 : 20.0;
    c.shear_fracture_energy = random() % 4 ? 300.0 * (1.0 + uniform(random)) : 0.0;
    c.tension_reduces_shear = random() % 4 != 0;
    c.envelope = random() % 2 ? Envelope::hyperbolic : Envelope::coulomb;
    return c;
}

struct Move {
    double du_n, du_s; // [m]
};
Move some_move(std::mt19937_64& random)
{
    const double far = random() % 16 ? 1.0 : 10.0;
    return {far * (uniform(random) - 0.48) * 5e-6, far * (uniform(random) - 0.5) * 1e-5};
}

bool same_memory(const CrackState<double>& a, const CrackState<double>& b)
{
    return bits::same(a.u_max, b.u_max) && bits::same(a.bond, b.bond) &&
           bits::same(a.unloading, b.unloading) && bits::same(a.integrity, b.integrity);
}

bool same_stress(const CrackState<double>& a, const CrackState<double>& b)
{
    return bits::same(a.u_n, b.u_n) && a.tau == b.tau && a.sigma == b.sigma;
}

} // namespace

TEST_CASE("mixed crack: without slip it is the paper's law, bit for bit", "[dem][mixed_crack]")
{
    const CrackMaterial c = stone();
    Crack mixed(c);
    CrackState<double> paper = dem::intact(mixed.law);
    double fracture = 0.0;
    const double u_ul = 2.0 * kG1 / kFt;
    for (const double to : {0.4 * u_ul, -1e-6, 0.7 * u_ul, 0.1 * u_ul, 1.1 * u_ul, -2e-6}) {
        const double du = (to - paper.u_n) / 1000;
        for (int i = 0; i < 1000; ++i) {
            const auto a = dem::advance<dem::ContactLaw::coupled>(mixed.law, paper, du, 0.0);
            const auto b = dem::advance(mixed.law, mixed.mixed, mixed.state, du, 0.0);
            REQUIRE(bits::same(a.state.sigma, b.state.sigma));
            REQUIRE(bits::same(a.state.u_max, b.state.u_max));
            REQUIRE(a.loss.fracture == b.loss.fracture);
            paper = a.state, mixed.state = b.state;
            fracture += b.loss.fracture;
        }
    }
    CHECK(fracture == Approx(kG1).epsilon(1e-3));
    CHECK(mixed.damage() == 1.0);
}

TEST_CASE("mixed crack: pure shear costs G_II, whatever the stiffness and the pressure",
          "[dem][mixed_crack]")
{
    CrackMaterial c = stone();
    c.ks = GENERATE(2.5e10, 1e11);
    c.tan_phi_res = GENERATE(0.6, 0.4);
    const double pressure = GENERATE(0.0, 1e6);
    Crack crack(c);
    crack.move(-pressure / c.kn, 0.0, 1);
    crack.move(-pressure / c.kn, 1.5 * 2.0 * kG2 / kC);
    CHECK(crack.damage() == 1.0);
    CHECK(crack.state.tau == Approx(pressure * c.tan_phi_res));
    CHECK(crack.largest_tau == Approx(kC + pressure * kTan).epsilon(1e-3));
    CHECK(crack.fracture == Approx(kG2).epsilon(1e-3));
    CHECK(crack.friction >= 0.0);
    if (c.tan_phi_res == kTan) {
        const double slip = 3.0 * kG2 / kC - crack.state.tau / c.ks;
        CHECK(crack.friction == Approx(pressure * kTan * slip).epsilon(1e-3));
    }
}

TEST_CASE("mixed crack: in pure shear the cohesion falls linearly with the slip",
          "[dem][mixed_crack]")
{
    Crack crack(stone());
    crack.move(0.0, kC / stone().ks + 0.25 * 2.0 * kG2 / kC - 0.25 * kC / stone().ks);
    CHECK(crack.state.tau == Approx(0.75 * kC).epsilon(1e-4));
    CHECK(crack.damage() == Approx(1.0 - 0.75 * 0.75).epsilon(1e-3));
    const double tau = crack.state.tau; // unloads with k_s
    crack.move(0.0, -1e-6);
    CHECK(crack.state.tau == Approx(tau - 1e-6 * stone().ks).epsilon(1e-9));
}

TEST_CASE("mixed crack: the hyperbolic envelope goes through (0, c) with Coulomb's slope and "
          "through (f_t, 0)",
          "[dem][mixed_crack]")
{
    CrackMaterial c = stone();
    c.tan_phi = c.tan_phi_res = GENERATE(0.0, 0.36, 0.6, 1.2, 3.0);
    Crack crack(c);
    CHECK(crack.limit() == kC);
    const double u_el = kFt / c.kn, slope = std::min(c.tan_phi, kC / kFt);
    crack.move(1e-6 * u_el, 0.0, 1);
    CHECK((kC - crack.limit()) / crack.state.sigma == Approx(slope).margin(2e-6));
    crack.move(-1e-6 * u_el, 0.0, 1);
    CHECK((kC - crack.limit()) / crack.state.sigma == Approx(c.tan_phi).margin(2e-6));
    double before = kC;
    for (int i = 1; i < 20; ++i) {
        crack.move(0.05 * i * u_el, 0.0, 1);
        CHECK(crack.limit() < before);
        CHECK(crack.limit() >= Approx(kC * (1.0 - 0.05 * i))); // the chord
        before = crack.limit();
    }
    crack.move(u_el, 0.0, 1);
    CHECK(crack.state.sigma == Approx(kFt));
    CHECK(crack.limit() == Approx(0.0).margin(1e-6 * kC));
}

TEST_CASE("mixed crack: Coulomb's envelope in tension is the paper's, in both readings",
          "[dem][mixed_crack]")
{
    CrackMaterial c = stone();
    c.envelope = Envelope::coulomb;
    c.tension_reduces_shear = GENERATE(true, false);
    Crack crack(c);
    for (const double share : {-0.5, 0.2, 0.9}) {
        crack.move(share * kFt / c.kn, 0.0, 1);
        CHECK(crack.limit() == Approx(dem::shear_strength(crack.law, 1.0, crack.state.sigma)));
    }
}

TEST_CASE(
    "mixed crack: every way to an opening and a slip of 0.1 mm spends G_I and G_II by the "
    "linear criterion",
    "[dem][mixed_crack]")
{
    CrackMaterial c = stone();
    c.fracture_energy = GENERATE(60.0, 110.0);
    c.shear_fracture_energy = GENERATE(110.0, 150.0);
    c.envelope = GENERATE(Envelope::hyperbolic, Envelope::coulomb);
    const double end = 1e-4;
    const auto along = [&](const std::vector<std::pair<double, double>>& stages) {
        Crack crack(c);
        for (const auto& [to_n, by_s] : stages) crack.move(to_n, by_s);
        return crack;
    };
    // Opening first, slip first, both at once, in stages, and with a crack that closes in
    // between.
    for (const Crack& crack :
         {along({{end, 0.0}, {end, end}}), along({{0.0, end}, {end, 0.0}}), along({{end, end}}),
          along({{0.0, 0.3 * end}, {0.3 * end, 0.0}, {0.3 * end, 0.7 * end}, {end, 0.0}}),
          along({{0.5 * end, 0.0}, {0.0, 0.0}, {0.0, end}, {end, 0.0}})}) {
        CHECK(crack.damage() == 1.0);
        const double spent = crack.lost_in_tension() / c.fracture_energy +
                             crack.lost_in_shear() / c.shear_fracture_energy;
        CHECK(spent == Approx(1.0).epsilon(2e-3));
        if (c.fracture_energy == c.shear_fracture_energy)
            CHECK(crack.fracture == Approx(110.0).epsilon(2e-3));
    }
}

TEST_CASE(
    "mixed crack: what a single step loses pays for its damage, and its stresses are those "
    "of the damaged crack",
    "[dem][mixed_crack]")
{
    Crack closed(stone());
    closed.move(-1e-5, 0.0, 1);
    closed.move(-1e-5, 0.8 * closed.limit() / closed.law.ks, 1);
    closed.move(-1e-5, 4e-5, 1);
    REQUIRE(closed.damage() > 0.1);
    REQUIRE(closed.damage() < 0.9);
    CHECK(closed.damage() == Approx(closed.fracture / kG2).epsilon(1e-12));

    Crack open(stone());
    open.move(0.5 * open.law.u_el, 0.0, 1);
    open.move(open.state.u_n, 1e-4, 1);
    REQUIRE(open.damage() > 0.1);
    REQUIRE(open.damage() < 0.9);
    CHECK(open.state.sigma == Approx(0.5 * kFt * (1.0 - open.damage())).epsilon(1e-12));

    CrackMaterial c = stone();
    c.cohesion_res = 0.3e6;
    Crack breaks(c);
    breaks.move(0.5 * breaks.law.u_el, 0.0, 1);
    breaks.move(breaks.state.u_n, 1e-3, 1);
    CHECK(breaks.damage() == 1.0);
    CHECK(breaks.state.sigma == 0.0);
    CHECK(breaks.state.tau == 0.0);
}

TEST_CASE("mixed crack: the damage is the share of the fracture energies that is spent, on any "
          "path, and no path makes energy",
          "[dem][mixed_crack]")
{
    std::mt19937_64 random(GENERATE(range(1, 11)));
    CrackMaterial c = stone();
    c.envelope = random() % 2 ? Envelope::hyperbolic : Envelope::coulomb;
    Crack crack(c);
    double damage = 0.0;
    for (int leg = 0; leg < 40; ++leg) { // there and back, and on
        const double to = (uniform(random) - 0.4) * 4e-5, by = (uniform(random) - 0.5) * 2e-4;
        const double from = crack.state.u_n;
        crack.move(to, by, 5000);
        if (random() % 2) crack.move(from, -by, 5000);
        const double stored = 0.5 * (crack.state.sigma * crack.state.u_n +
                                     crack.state.tau * crack.state.tau * crack.law.inv_ks);
        const double put = crack.work_normal + crack.work_shear;
        REQUIRE(put == Approx(stored + crack.friction + crack.fracture).margin(2e-3));
        const double spent = crack.lost_in_tension() / kG1 + crack.lost_in_shear() / kG2;
        REQUIRE(std::min(spent, 1.0) == Approx(crack.damage()).margin(2e-3));
        REQUIRE(crack.damage() >= damage);
        damage = crack.damage();
    }
    CHECK(crack.least_loss > -2e-7); // the kink of a step that opens a broken crack
}

TEST_CASE("mixed crack: a broken crack rubs where it is closed and carries nothing where it is "
          "open",
          "[dem][mixed_crack]")
{
    CrackMaterial c = stone();
    c.cohesion_res = 0.3e6;
    c.tan_phi_res = 0.4;
    Crack crack(c);
    crack.move(0.0, 1e-3);
    REQUIRE(crack.damage() == 1.0);
    CHECK(crack.state.tau == Approx(0.3e6));
    crack.move(-1e-5, 1e-4);
    CHECK(crack.state.tau == Approx(0.3e6 + 0.4 * 1e6));
    const double fracture = crack.fracture;
    crack.move(1e-7, 1e-4, 200);
    CHECK(crack.state.tau == 0.0);
    CHECK(crack.state.sigma == 0.0);
    crack.move(-1e-5, 1e-4);
    CHECK(crack.state.tau == Approx(0.7e6));
    CHECK(crack.fracture == Approx(fracture).epsilon(1e-3));
}

TEST_CASE("mixed crack: without G_II, without cohesion to lose, and below the stiffness of a "
          "snap-back the first slip breaks it",
          "[dem][mixed_crack]")
{
    CrackMaterial c = stone();
    SECTION("no energy") { c.shear_fracture_energy = 0.0; }
    SECTION("no cohesion to lose") { c.cohesion_res = c.cohesion; }
    SECTION("snap-back") { c.ks = 0.99 * kC * kC / (2.0 * kG2); }
    Crack crack(c);
    crack.move(-1e-6, 0.0, 1);
    const double pressure = 1e-6 * c.kn;
    crack.move(-1e-6, 1.001 * (kC + pressure * kTan) / c.ks);
    CHECK(crack.damage() == 1.0);
    CHECK(crack.state.tau == Approx(c.cohesion_res + pressure * kTan));
    CHECK(crack.fracture >= 0.0);
}

TEST_CASE(
    "mixed crack: without G_II an open crack breaks at its first slip with Coulomb's envelope, "
    "as in the paper, and with the hyperbolic one as far as the slip costs",
    "[dem][mixed_crack]")
{
    CrackMaterial c = stone();
    c.shear_fracture_energy = 0.0;
    c.envelope = GENERATE(Envelope::coulomb, Envelope::hyperbolic);
    Crack crack(c);
    CrackState<double> paper = dem::intact(crack.law);
    const double du_n = 0.9 * crack.law.u_el, du_s = 1.02 * 0.1 * kC / c.ks;
    crack.move(du_n, 0.0, 1);
    paper = dem::advance<dem::ContactLaw::coupled>(crack.law, paper, du_n, 0.0).state;
    for (int i = 0; i < 10; ++i) {
        crack.move(du_n, du_s, 1);
        paper = dem::advance<dem::ContactLaw::coupled>(crack.law, paper, 0.0, du_s).state;
        if (c.envelope == Envelope::hyperbolic) continue;
        CHECK(crack.state.tau == paper.tau);
        CHECK(crack.state.sigma == paper.sigma);
    }
    REQUIRE(dem::damage(crack.law, paper) == 1.0);
    if (c.envelope == Envelope::coulomb)
        CHECK(crack.damage() == 1.0);
    else
        CHECK((crack.damage() > 0.0 && crack.damage() < 1.0));
}

TEST_CASE("mixed crack: reversing the slip reverses the shear stress and nothing else",
          "[dem][mixed_crack]")
{
    for (const double to : {-1e-6, 8e-6}) {
        Crack left(stone()), right(stone());
        left.move(to, -1.5e-4, 1000);
        right.move(to, 1.5e-4, 1000);
        CHECK(left.state.tau == -right.state.tau);
        CHECK(left.state.integrity == right.state.integrity);
        CHECK(left.fracture == right.fracture);
        CHECK(right.damage() > 0.0);
    }
}

TEST_CASE("mixed crack: the short way holds where the law changes nothing else, and gives its "
          "bits",
          "[dem][mixed_crack]")
{
    int opened = 0, sheared = 0, broken = 0, left = 0; // times it held, and did not
    for (int seed = 0; seed < 48; ++seed) {
        std::mt19937_64 random(seed);
        Crack crack(some_material(random));
        CrackState<double>& s = crack.state;
        for (int i = 0; i < 2000; ++i) {
            const auto [du_n, du_s] = some_move(random);
            const auto trial = dem::try_elastic(crack.law, crack.mixed, s, du_n, du_s);
            const auto [after, loss] = dem::advance(crack.law, crack.mixed, s, du_n, du_s);
            CrackState<double> elastic = s;
            elastic.u_n = trial.u_n, elastic.tau = trial.tau, elastic.sigma = trial.sigma;
            if (trial.holds) {
                REQUIRE(same_stress(elastic, after));
                REQUIRE(same_memory(s, after));
                REQUIRE(loss.friction == 0.0);
                REQUIRE(loss.fracture == 0.0);
                opened += s.u_max > crack.law.u_el && s.bond == 1.0 && trial.sigma > 0.0;
                sheared += s.bond < 1.0 && s.bond > 0.0;
                broken += s.integrity == 0.0;
            } else {
                REQUIRE_FALSE((same_stress(elastic, after) && same_memory(s, after)));
                ++left;
            }
            s = after;
        }
    }
    CHECK(opened > 20);
    CHECK(sheared > 100);
    CHECK(broken > 500);
    CHECK(left > 500);
}

TEST_CASE("mixed crack: each lane of a pack is the scalar law, bit for bit",
          "[dem][mixed_crack][pack]")
{
    std::mt19937_64 random(GENERATE(range(1, 9)));
    std::vector<Crack> alone;
    CrackLaw<Pack> law{};
    MixedLaw<Pack> mixed{};
    for (int i = 0; i < lanes<Pack>; ++i) {
        Crack c(some_material(random));
        const auto put = [i](auto& all, const auto& one, auto... field) {
            (set_lane(all.*(field.first), i, one.*(field.second)), ...);
        };
        using L = CrackLaw<Pack>;
        using l = CrackLaw<double>;
        using M = MixedLaw<Pack>;
        using m = MixedLaw<double>;
        put(law, c.law, std::pair{&L::kn, &l::kn}, std::pair{&L::ks, &l::ks},
            std::pair{&L::inv_ks, &l::inv_ks}, std::pair{&L::ft, &l::ft},
            std::pair{&L::u_el, &l::u_el}, std::pair{&L::inv_softening, &l::inv_softening},
            std::pair{&L::cohesion_res, &l::cohesion_res},
            std::pair{&L::cohesion_drop, &l::cohesion_drop},
            std::pair{&L::tan_phi_res, &l::tan_phi_res},
            std::pair{&L::tan_phi_drop, &l::tan_phi_drop},
            std::pair{&L::tension_weight, &l::tension_weight});
        put(mixed, c.mixed, std::pair{&M::inv_energy, &m::inv_energy},
            std::pair{&M::brittle, &m::brittle}, std::pair{&M::brittle_open, &m::brittle_open},
            std::pair{&M::inv_u_ul, &m::inv_u_ul}, std::pair{&M::kappa, &m::kappa},
            std::pair{&M::hyperbolic, &m::hyperbolic});
        alone.push_back(c);
    }
    CrackState<Pack> together = dem::intact(law);
    for (int step = 0; step < 3000; ++step) {
        Pack du_n, du_s;
        for (int i = 0; i < lanes<Pack>; ++i) {
            const Move move = some_move(random);
            du_n.set(i, move.du_n), du_s.set(i, move.du_s);
        }
        const auto trial = dem::try_elastic(law, mixed, together, du_n, du_s);
        const auto [after, loss] = dem::advance(law, mixed, together, du_n, du_s);
        bool all_hold = true;
        for (int i = 0; i < lanes<Pack>; ++i) {
            Crack& c = alone[i];
            all_hold =
                all_hold && dem::try_elastic(c.law, c.mixed, c.state, du_n[i], du_s[i]).holds;
            const auto one = dem::advance(c.law, c.mixed, c.state, du_n[i], du_s[i]);
            c.state = one.state;
            const CrackState<double> lane{after.u_n[i],      after.tau[i],  after.sigma[i],
                                          after.u_max[i],    after.bond[i], after.unloading[i],
                                          after.integrity[i]};
            REQUIRE(same_memory(lane, c.state));
            REQUIRE(bits::same(lane.tau, c.state.tau));
            REQUIRE(bits::same(lane.sigma, c.state.sigma));
            REQUIRE(bits::same(loss.friction[i], one.loss.friction));
            REQUIRE(bits::same(loss.fracture[i], one.loss.fracture));
        }
        REQUIRE(trial.holds == all_hold);
        together = after;
    }
}
