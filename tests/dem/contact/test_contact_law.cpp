#include "tests/dem/crack_path.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace {

using dem::ContactLaw;
using namespace crack_path;

constexpr double kArea = 0.02; // [m2]

} // namespace

// Problem 8 of the verification list: A 0.02 m2, f_T 3.7 MPa, G 110 N/m, k_n 80.8 GPa/m.
TEST_CASE("contact law: mode I costs the fracture energy, 2.2000 J on 0.02 m2",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path p{intact(law)};
    move(law, 1.2 * kUul, 0.0, 120000, p);
    CHECK(p.largest_sigma * kArea == Approx(74.0e3).epsilon(1e-4));
    CHECK(p.work * kArea == Approx(2.2000).epsilon(1e-4));
    CHECK(p.fracture * kArea == Approx(2.2000).epsilon(1e-4));
    CHECK(p.friction == 0.0);
    CHECK(p.state.sigma == 0.0);
    CHECK(dem::damage(law, p.state) == 1.0);
}

TEST_CASE("contact law: half way down the softening branch D = 0.5 and sigma = 1.85 MPa",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path p{intact(law)};
    move(law, 0.5 * (kUel + kUul), 0.0, 1000, p);
    CHECK(dem::damage(law, p.state) == Approx(0.5).epsilon(1e-12));
    CHECK(p.state.sigma == Approx(1.85e6).epsilon(1e-12));
}

TEST_CASE("contact law: unloading in tension goes straight to the origin and closes at u_n = 0",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path p{intact(law)};
    const double u = 0.5 * (kUel + kUul);
    move(law, u, 0.0, 1000, p);
    const double lost = p.fracture;
    move(law, -0.5 * u, 0.0, 10, p);
    CHECK(p.state.sigma == Approx(0.5 * 1.85e6).epsilon(1e-12));
    move(law, -0.5 * u - 1e-6, 0.0, 1000, p);
    CHECK(p.state.sigma == Approx(-kKn * 1e-6).epsilon(1e-9));
    CHECK(dem::damage(law, p.state) == Approx(0.5).epsilon(1e-12)); // never heals
    CHECK(p.fracture == Approx(lost).epsilon(1e-6)); // nothing more lost on the way back
}

TEST_CASE("contact law: a contact that snaps back releases f_T^2/(2 k_n), more than G",
          "[dem][contact_law]")
{
    const double ft = GENERATE(4.5e6, 6.0e6, 9.0e6); // above sqrt(2 G k_n) = 4.22 MPa
    const auto law = crack(ft);
    REQUIRE(ft > std::sqrt(2.0 * kG * kKn));
    Path p{intact(law)};
    move(law, 1.2 * law.u_el, 0.0, 240000, p);
    CHECK(p.fracture == Approx(ft * ft / (2.0 * kKn)).epsilon(1e-4));
    CHECK(p.fracture > kG);
    CHECK(p.state.sigma == 0.0);
}

// Problem 9: unit and joint under constant compression.
TEST_CASE("contact law: mode II peak and residual of a unit crack", "[dem][contact_law]")
{
    const double sigma = GENERATE(0.15e6, 0.5e6, 1.0e6, 1.25e6);
    const auto law = crack();
    Path p{intact(law)};
    move(law, -sigma / kKn, 0.0, 1, p);
    move(law, 0.0, 2e-4, 200000, p);
    CHECK(p.largest_tau == Approx(3.7e6 + sigma * tan_deg(35.0)).epsilon(1e-4));
    CHECK(p.state.tau == Approx(sigma * tan_deg(35.0)).epsilon(1e-12));
    CHECK(p.state.bond == 0.0);
}

TEST_CASE("contact law: a dry joint slides at sigma tan(phi)", "[dem][contact_law]")
{
    const auto [sigma, expected] = GENERATE(table<double, double>(
        {{0.15e6, 0.0930e6}, {0.5e6, 0.3100e6}, {1.0e6, 0.6200e6}, {1.25e6, 0.7750e6}}));
    const double kn = 8.08e9, ks = dem::shear_stiffness(kn, 0.2);
    const dem::DryLaw<double> law{kn, ks, 1.0 / ks, tan_deg(31.8)};
    auto u = dem::advance(law, dem::DryState<double>{0, 0}, -sigma / kn, 0.0);
    double friction = 0.0;
    for (int i = 0; i < 100000; ++i) {
        u = dem::advance(law, u.state, 0.0, 1e-8);
        friction += u.friction;
    }
    CHECK(u.state.tau ==
          Approx(expected).epsilon(1e-3)); // the reference is printed with four digits
    CHECK(u.state.tau == Approx(sigma * tan_deg(31.8)).epsilon(1e-12));
    CHECK(friction == Approx(u.state.tau * (1e-3 - u.state.tau / ks)).epsilon(1e-6));
}

TEST_CASE("contact law: a dry joint carries no tension, and no shear while it is open",
          "[dem][contact_law]")
{
    const dem::DryLaw<double> law{8e9, 3e9, 1.0 / 3e9, 0.62};
    auto u = dem::advance(law, dem::DryState<double>{0, 0}, -1e-4, 5e-5);
    REQUIRE(u.state.tau > 0.0);
    u = dem::advance(law, u.state, 2e-4, 0.0);
    CHECK(u.sigma == 0.0);
    CHECK(u.state.tau == 0.0);
}

// Problem 10: coupling.
TEST_CASE("contact law: a crack without strength is a dry joint", "[dem][contact_law]")
{
    const double kn = 8.08e9, ks = dem::shear_stiffness(kn, 0.2), tan_phi = tan_deg(31.8);
    const dem::DryLaw<double> joint{kn, ks, 1.0 / ks, tan_phi};
    dem::CrackLaw<double> law = crack(0.0, kn);
    law.inv_softening = dem::kBreaksAtOnce;
    law.tan_phi_res = tan_phi;
    Path p{intact(law)};
    dem::DryState<double> dry{0.0, 0.0};
    std::mt19937_64 random(5);
    const auto draw = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
    double friction = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double du_n = 1e-6 * draw(), du_s = 1e-6 * draw();
        move(law, du_n, du_s, 1, p);
        const auto u = dem::advance(joint, dry, du_n, du_s);
        dry = u.state;
        friction += u.friction;
        REQUIRE(p.state.sigma == u.sigma);
        REQUIRE(p.state.tau == dry.tau);
    }
    CHECK(p.friction == Approx(friction).epsilon(1e-9));
    CHECK(p.fracture == Approx(0.0).margin(1e-3)); // [J/m2]: kinks of the path
}

TEST_CASE("contact law: tension damage of one half halves the shear strength",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path p{intact(law)};
    move(law, 0.5 * (kUel + kUul), 0.0, 1000, p);
    move(law, -p.state.u_n, 0.0, 1, p);
    REQUIRE(std::abs(p.state.sigma) < 1e-3);
    p.largest_tau = 0.0;
    move(law, 0.0, 2e-4, 200000, p);
    CHECK(p.largest_tau == Approx(1.85e6).epsilon(1e-4));
}

TEST_CASE("contact law: after a shear failure no tension is left, uncoupled it is",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path coupled{intact(law)}, uncoupled{intact(law)};
    move(law, 0.0, 2e-4, 1000, coupled);
    move<ContactLaw::uncoupled>(law, 0.0, 2e-4, 1000, uncoupled);
    coupled.largest_sigma = uncoupled.largest_sigma = 0.0;
    move(law, kUul, 0.0, 20000, coupled);
    move<ContactLaw::uncoupled>(law, kUul, 0.0, 20000, uncoupled);
    CHECK(coupled.largest_sigma == 0.0);
    CHECK(uncoupled.largest_sigma == Approx(kFt).epsilon(1e-3));
}

TEST_CASE("contact law: tension lowers the shear strength, in the other reading it does not",
          "[dem][contact_law]")
{
    auto law = crack();
    const double sigma = 0.8 * kFt;
    CHECK(dem::shear_strength(law, 1.0, sigma) == Approx(kFt - sigma * tan_deg(35.0)));
    law.tension_weight = 0.0;
    CHECK(dem::shear_strength(law, 1.0, sigma) == Approx(kFt));
    CHECK(dem::shear_strength(law, 1.0, -sigma) == Approx(kFt + sigma * tan_deg(35.0)));
}

TEST_CASE("contact law: what is put in is stored or accounted for, on any path",
          "[dem][contact_law]")
{
    std::mt19937_64 random(GENERATE(range(1, 9)));
    const auto step = [&random] {
        return (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) * 2e-5;
    };
    const auto law = crack(GENERATE(2.0e6, 3.7e6, 6.0e6));
    Path p{intact(law)};
    double previous_damage = 0.0;
    for (int leg = 0; leg < 60; ++leg) {
        move(law, step(), 3 * step(), 20000, p);
        const double stored =
            0.5 * (p.state.sigma * p.state.u_n + p.state.tau * p.state.tau * law.inv_ks);
        CHECK(p.work == Approx(stored + p.friction + p.fracture)
                            .margin(1e-3)); // of some 100 J/m2: kinks of the path
        CHECK(dem::damage(law, p.state) >= previous_damage);
        previous_damage = dem::damage(law, p.state);
    }
    CHECK(p.friction > -1e-6); // rounding of 1.2 million steps
    CHECK(p.fracture > -1e-6);
}

TEST_CASE("contact law: reversing the slip reverses the shear stress and nothing else",
          "[dem][contact_law]")
{
    const auto law = crack();
    const double du_s = GENERATE(1e-6, 1e-5, 1e-4, 1e-3); // [m]; the last two crack
    Path left{intact(law)}, right{intact(law)};
    move(law, -1e-6, -du_s, 100, left);
    move(law, -1e-6, du_s, 100, right);
    CHECK(left.state.tau == -right.state.tau);
    CHECK(left.state.sigma == right.state.sigma);
    CHECK(left.state.bond == right.state.bond);
    CHECK(left.friction == right.friction);
}

TEST_CASE("contact law: each lane of a pack is the scalar law, bit for bit",
          "[dem][contact_law][pack]")
{
    std::mt19937_64 random(11);
    const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    std::vector<dem::CrackLaw<double>> laws;
    std::vector<dem::CrackState<double>> states;
    dem::CrackLaw<dem::Pack> pack_law{};
    dem::CrackState<dem::Pack> pack{};
    for (int i = 0; i < dem::lanes<dem::Pack>; ++i) {
        laws.push_back(crack(2e6 + 5e6 * uniform(), (4 + 8 * uniform()) * 1e10));
        states.push_back(intact(laws.back()));
        pack_law.kn.set(i, laws[i].kn), pack_law.ks.set(i, laws[i].ks),
            pack_law.inv_ks.set(i, laws[i].inv_ks);
        pack_law.ft.set(i, laws[i].ft), pack_law.u_el.set(i, laws[i].u_el);
        pack_law.inv_softening.set(i, laws[i].inv_softening),
            pack_law.cohesion_res.set(i, laws[i].cohesion_res);
        pack_law.cohesion_drop.set(i, laws[i].cohesion_drop),
            pack_law.tan_phi_res.set(i, laws[i].tan_phi_res);
        pack_law.tan_phi_drop.set(i, laws[i].tan_phi_drop), pack_law.tension_weight.set(i, 1.0);
    }
    pack = intact(pack_law);
    for (int step = 0; step < 4000; ++step) {
        dem::Pack du_n, du_s;
        for (int i = 0; i < dem::lanes<dem::Pack>; ++i) {
            const double n = (uniform() - 0.48) * 1e-5, s = (uniform() - 0.5) * 2e-5;
            du_n.set(i, n), du_s.set(i, s);
            states[i] = dem::advance<ContactLaw::coupled>(laws[i], states[i], n, s).state;
        }
        pack = dem::advance<ContactLaw::coupled>(pack_law, pack, du_n, du_s).state;
        for (int i = 0; i < dem::lanes<dem::Pack>; ++i) {
            REQUIRE(pack.sigma[i] == states[i].sigma);
            REQUIRE(pack.tau[i] == states[i].tau);
            REQUIRE(pack.u_max[i] == states[i].u_max);
            REQUIRE(pack.bond[i] == states[i].bond);
        }
    }
}
