/// The short way through the law of a crack: where it may be taken it gives the same bits.

#include "dem/contact/contact_law.hpp"
#include "dem/scene/paper_materials.hpp"
#include "tests/dem/bits.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace {

using dem::ContactLaw;
using dem::CrackLaw;
using dem::CrackState;
using dem::lanes;
using dem::multiply_add;
using dem::Pack;
using dem::Unloading;

/// In [0, 1).
double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Strong and weak, with and without snap-back, residual cohesion, friction that drops, and
/// both readings of the shear strength in tension.
CrackLaw<double> some_crack(std::mt19937_64& random)
{
    CrackLaw<double> law{};
    law.kn = (4.0 + 8.0 * uniform(random)) * 1e10;
    law.ks = dem::shear_stiffness(law.kn, 0.2);
    law.inv_ks = 1.0 / law.ks;
    law.ft = (1.0 + 5.0 * uniform(random)) * 1e6;
    law.u_el = law.ft / law.kn;
    const double u_ul = 2.0 * 110.0 / law.ft;
    law.inv_softening = u_ul > law.u_el ? 1.0 / (u_ul - law.u_el) : dem::kBreaksAtOnce;
    law.cohesion_res = random() % 2 ? 0.0 : 0.2 * law.ft;
    law.cohesion_drop = law.ft - law.cohesion_res;
    law.tan_phi_res = 0.4 + 0.4 * uniform(random);
    law.tan_phi_drop = random() % 2 ? 0.0 : 0.2;
    law.tension_weight = random() % 4 ? 1.0 : 0.0;
    return law;
}

/// Displacements of one step [m]: to and fro, now and then far. It opens a little more than it
/// closes.
struct Move {
    double du_n, du_s;
};
Move some_move(std::mt19937_64& random)
{
    const double far = random() % 16 ? 1.0 : 10.0;
    return {far * (uniform(random) - 0.48) * 5e-6, far * (uniform(random) - 0.5) * 1e-5};
}

template <class Real> bool same_memory(const CrackState<Real>& a, const CrackState<Real>& b)
{
    return bits::same(a.u_max, b.u_max) && bits::same(a.bond, b.bond) &&
           bits::same(a.unloading, b.unloading) && bits::same(a.integrity, b.integrity);
}

template <class Real> bool same_stress(const CrackState<Real>& a, const CrackState<Real>& b)
{
    return bits::same(a.u_n, b.u_n) && bits::same(a.tau, b.tau) && bits::same(a.sigma, b.sigma);
}

/// A crack and what it has lost, moved as the solver moves it.
template <class Real> struct Crack {
    CrackLaw<Real> law{};
    CrackState<Real> state{};
    Real friction{0.0}, fracture{0.0};

    template <ContactLaw kLaw, Unloading kUnloading> void move(Real du_n, Real du_s)
    {
        const auto trial = dem::try_elastic<kUnloading>(law, state, du_n, du_s);
        if (trial.holds) {
            state.u_n = trial.u_n, state.tau = trial.tau, state.sigma = trial.sigma;
            return;
        }
        const auto [after, loss] = dem::advance<kLaw, kUnloading>(law, state, du_n, du_s);
        const Real area(0.0021);
        state = after;
        friction = multiply_add(area, loss.friction, friction);
        fracture = multiply_add(area, loss.fracture, fracture);
    }
};

/// Values of a law or a state, one by one.
template <class Real> std::vector<Real*> values(CrackLaw<Real>& l)
{
    return {&l.kn,
            &l.ks,
            &l.inv_ks,
            &l.ft,
            &l.u_el,
            &l.inv_softening,
            &l.cohesion_res,
            &l.cohesion_drop,
            &l.tan_phi_res,
            &l.tan_phi_drop,
            &l.tension_weight};
}

template <ContactLaw kLaw, Unloading kUnloading = Unloading::secant>
void follow_trial(int seed, int& fresh, int& damaged, int& sheared)
{
    std::mt19937_64 random(seed);
    const CrackLaw<double> law = some_crack(random);
    CrackState<double> s = dem::intact<kUnloading>(law);
    for (int i = 0; i < 2000; ++i) {
        const auto [du_n, du_s] = some_move(random);
        const auto trial = dem::try_elastic<kUnloading>(law, s, du_n, du_s);
        const auto [after, loss] = dem::advance<kLaw, kUnloading>(law, s, du_n, du_s);
        CrackState<double> elastic = s;
        elastic.u_n = trial.u_n, elastic.tau = trial.tau, elastic.sigma = trial.sigma;
        REQUIRE(trial.holds == (same_stress(elastic, after) && same_memory(s, after)));
        if (trial.holds) {
            REQUIRE(loss.friction == 0.0);
            REQUIRE(loss.fracture == 0.0);
            const bool opened = s.u_max > law.u_el;
            fresh += !opened && s.bond == 1.0;
            damaged += opened && s.bond == 1.0 && trial.sigma > 0.0; // reloaded
            sheared += s.bond == 0.0;
        }
        s = after;
    }
}

template <ContactLaw kLaw, Unloading kUnloading = Unloading::secant>
void follow_lanes(int seed, int& mixed)
{
    std::mt19937_64 random(seed);
    Crack<Pack> together;
    std::vector<Crack<double>> alone(lanes<Pack>);
    for (int i = 0; i < lanes<Pack>; ++i) {
        alone[i].law = some_crack(random);
        alone[i].state = dem::intact<kUnloading>(alone[i].law);
        const auto one = values(alone[i].law);
        const auto all = values(together.law);
        for (std::size_t k = 0; k < one.size(); ++k) set_lane(*all[k], i, *one[k]);
    }
    together.state = dem::intact<kUnloading>(together.law);
    for (int step = 0; step < 2000; ++step) {
        Pack du_n, du_s;
        int leave = 0;
        for (int i = 0; i < lanes<Pack>; ++i) {
            const Move m = some_move(random);
            du_n.set(i, m.du_n), du_s.set(i, m.du_s);
            leave += !dem::try_elastic<kUnloading>(alone[i].law, alone[i].state, m.du_n, m.du_s)
                          .holds;
            alone[i].template move<kLaw, kUnloading>(m.du_n, m.du_s);
        }
        mixed += leave > 0 && leave < lanes<Pack>;
        together.template move<kLaw, kUnloading>(du_n, du_s);
        for (int i = 0; i < lanes<Pack>; ++i) {
            const auto& s = together.state;
            const CrackState<double> in_lane{s.u_n[i],      s.tau[i],  s.sigma[i],
                                             s.u_max[i],    s.bond[i], s.unloading[i],
                                             s.integrity[i]};
            REQUIRE(same_stress(in_lane, alone[i].state));
            REQUIRE(same_memory(in_lane, alone[i].state));
            REQUIRE(bits::same(together.friction[i], alone[i].friction));
            REQUIRE(bits::same(together.fracture[i], alone[i].fracture));
        }
    }
}

} // namespace

TEST_CASE("elastic trial: holds where the law changes nothing else, and gives its bits",
          "[dem][contact_law]")
{
    int fresh = 0, damaged = 0, sheared = 0; // times it held
    for (int seed = 0; seed < 24; ++seed) {
        follow_trial<ContactLaw::coupled>(seed, fresh, damaged, sheared);
        follow_trial<ContactLaw::uncoupled>(seed, fresh, damaged, sheared);
    }
    CHECK(fresh > 500);
    CHECK(damaged > 50);
    CHECK(sheared > 500);
}

TEST_CASE("elastic trial: the same of cracks that stay propped", "[dem][contact_law]")
{
    int fresh = 0, damaged = 0, sheared = 0;
    for (int seed = 0; seed < 24; ++seed) {
        follow_trial<ContactLaw::coupled, Unloading::elastic>(seed, fresh, damaged, sheared);
        follow_trial<ContactLaw::uncoupled, Unloading::elastic>(seed, fresh, damaged, sheared);
    }
    CHECK(fresh > 500);
    CHECK(damaged > 50);
    CHECK(sheared > 500);
}

TEST_CASE(
    "elastic trial: lanes that crack and lanes that do not keep the bits of the scalar law",
    "[dem][contact_law][pack]")
{
    int mixed = 0; // steps in which some lanes leave the elastic branch
    for (int seed = 0; seed < 8; ++seed) {
        follow_lanes<ContactLaw::coupled>(seed, mixed);
        follow_lanes<ContactLaw::uncoupled>(seed, mixed);
        follow_lanes<ContactLaw::coupled, Unloading::elastic>(seed, mixed);
        follow_lanes<ContactLaw::uncoupled, Unloading::elastic>(seed, mixed);
    }
    CHECK(mixed > 2000);
}

TEST_CASE("elastic trial: a pack holds only if every lane does", "[dem][contact_law][pack]")
{
    std::mt19937_64 random(1);
    const CrackLaw<double> one = some_crack(random);
    CrackLaw<Pack> law{};
    const auto all = values(law);
    CrackLaw<double> copy = one;
    for (std::size_t k = 0; k < all.size(); ++k) *all[k] = Pack(*values(copy)[k]);
    const CrackState<Pack> s = intact(law);
    CHECK(try_elastic(law, s, Pack(0.9 * one.u_el), Pack(0.0)).holds);
    for (int i = 0; i < lanes<Pack>; ++i) {
        Pack opens(0.0), slips(0.0);
        opens.set(i, 1.1 * one.u_el);
        slips.set(i, -2.0 * one.ft / one.ks);
        CHECK_FALSE(try_elastic(law, s, opens, Pack(0.0)).holds);
        CHECK_FALSE(try_elastic(law, s, Pack(0.0), slips).holds);
    }
}
