/// Cracks that unload with k_n and stay propped (Unloading::elastic): closed-form paths, and
/// the energy of each. The default, secant, is in test_contact_law.

#include "dem/block/model.hpp"
#include "dem/solver/state/wall_state.hpp"
#include "tests/dem/crack_path.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <random>

namespace {

using dem::ContactLaw;
using dem::CrackLaw;
using dem::Unloading;
using namespace crack_path;

constexpr double kHalf = 0.5 * (kUel + kUul);    // where half of f_T is left [m]
constexpr double kHalfProp = kHalf - 0.5 * kUel; // u_p there [m]

Path fresh(const CrackLaw<double>& law) { return {dem::intact<Unloading::elastic>(law)}; }

template <ContactLaw kLaw = ContactLaw::coupled>
void go(const CrackLaw<double>& law, double du_n, double du_s, int n, Path& p)
{
    move<kLaw, Unloading::elastic>(law, du_n, du_s, n, p);
}

/// To an opening, without slip.
void open_to(const CrackLaw<double>& law, double u_n, Path& p)
{
    go(law, u_n - p.state.u_n, 0.0, 1000, p);
}

double stored(const CrackLaw<double>& law, const Path& p)
{
    return 0.5 *
           (p.state.sigma * p.state.sigma / law.kn + p.state.tau * p.state.tau * law.inv_ks);
}

} // namespace

TEST_CASE("crack unloading: closes with k_n and is propped at u_max - (1 - D) f_T/k_n",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path p = fresh(law);
    open_to(law, kHalf, p);
    CHECK(p.state.sigma == Approx(0.5 * kFt).epsilon(1e-12));
    open_to(law, kHalf - 3e-6, p);
    CHECK(p.state.sigma == Approx(0.5 * kFt - kKn * 3e-6).epsilon(1e-12));
    open_to(law, kHalfProp, p);
    CHECK(std::abs(p.state.sigma) < 1e-6 * kFt);
    open_to(law, kHalfProp - 2e-6, p); // in contact although open
    CHECK(p.state.u_n > 0.0);
    CHECK(p.state.sigma == Approx(-kKn * 2e-6).epsilon(1e-9));
    open_to(law, -1e-6, p);
    CHECK(p.state.sigma == Approx(-kKn * (1e-6 + kHalfProp)).epsilon(1e-9));
    CHECK(dem::damage(law, p.state) == Approx(0.5).epsilon(1e-12)); // never heals
}

TEST_CASE("crack unloading: reloaded with k_n to the strength left, then it softens on",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path p = fresh(law);
    open_to(law, kHalf, p);
    open_to(law, -5e-6, p);
    p.largest_sigma = 0.0;
    open_to(law, kHalf, p);
    CHECK(p.largest_sigma == Approx(0.5 * kFt).epsilon(1e-12));
    CHECK(dem::damage(law, p.state) == Approx(0.5).epsilon(1e-12));
    open_to(law, 0.25 * kUel + 0.75 * kUul, p);
    CHECK(p.state.sigma == Approx(0.25 * kFt).epsilon(1e-12));
    CHECK(p.largest_sigma == Approx(0.5 * kFt).epsilon(1e-12));
}

TEST_CASE("crack unloading: sigma^2/(2 k_n) is stored, the rest of the work is fracture",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path p = fresh(law);
    go(law, kHalf, 0.0, 100000, p);
    const double under_curve = 0.5 * kFt * kUel + 0.75 * kFt * (kHalf - kUel); // [J/m2]
    const double fracture = under_curve - std::pow(0.5 * kFt, 2) / (2.0 * kKn);
    CHECK(p.work == Approx(under_curve).epsilon(1e-6));
    CHECK(p.fracture == Approx(fracture).epsilon(1e-6));

    const double lost = p.fracture;
    for (const double u_n : {kHalfProp, -5e-6, 0.5 * kHalf, 0.99 * kHalf}) { // elastic
        open_to(law, u_n, p);
        CHECK(p.fracture == lost);
        CHECK(p.work == Approx(stored(law, p) + lost).epsilon(1e-9));
    }

    go(law, 0.2 * kUul, 0.0, 100000, p);
    CHECK(p.state.sigma == 0.0);
    CHECK(p.fracture == Approx(kG).epsilon(1e-5));
    CHECK(p.work == Approx(kG).epsilon(1e-5));
    CHECK(p.friction == 0.0);
}

TEST_CASE("crack unloading: broken through, it is in contact where it was when it turned back",
          "[dem][contact_law]")
{
    const auto law = crack(GENERATE(3.7e6, 6.0e6)); // with and without snap-back
    Path p = fresh(law);
    open_to(law, 3.0 * kUul, p);
    CHECK(p.state.sigma == 0.0);
    CHECK(dem::damage(law, p.state) == 1.0);
    const double lost = p.fracture;
    open_to(law, 3.0 * kUul - 1e-6, p);
    CHECK(p.state.sigma == Approx(-kKn * 1e-6).epsilon(1e-9));
    open_to(law, 4.0 * kUul, p); // opens again without strength
    CHECK(p.state.sigma == 0.0);
    open_to(law, 4.0 * kUul - 1e-6, p);
    CHECK(p.state.sigma == Approx(-kKn * 1e-6).epsilon(1e-9));
    CHECK(p.fracture == Approx(lost).margin(1e-3 * lost)); // the kink where it opens again
}

TEST_CASE("crack unloading: a shear failure in tension props it at once", "[dem][contact_law]")
{
    const auto law = crack();
    Path p = fresh(law);
    const double u = 0.6 * kUel, sigma = kKn * u;
    open_to(law, u, p);
    const double tau = kFt - sigma * tan_deg(35.0); // c = f_T, no residual
    go(law, 0.0, 0.999 * tau / law.ks, 1000, p);
    CHECK(p.state.sigma == Approx(sigma).epsilon(1e-12));
    CHECK(p.fracture == 0.0);
    for (int i = 0; i < 20000 && p.state.bond > 0.0; ++i)
        go(law, 0.0, 1e-7 * tau / law.ks, 1, p);
    CHECK(p.state.bond == 0.0); // in the same step:
    CHECK(p.state.sigma == 0.0);
    CHECK(p.state.tau == 0.0);
    const double released = 0.5 * (sigma * sigma / kKn + tau * tau / law.ks);
    CHECK(p.fracture + p.friction == Approx(released).epsilon(1e-4));
    CHECK(p.work == Approx(released).epsilon(1e-4));

    open_to(law, u - 1e-6, p); // in contact below u, rubbing
    CHECK(p.state.sigma == Approx(-kKn * 1e-6).epsilon(1e-9));
    go(law, 0.0, 1e-5, 1000, p);
    CHECK(p.state.tau == Approx(kKn * 1e-6 * tan_deg(35.0)).epsilon(1e-9));
}

TEST_CASE("crack unloading: after a shear failure in compression it opens without tension",
          "[dem][contact_law]")
{
    const auto law = crack();
    Path coupled = fresh(law), uncoupled = fresh(law);
    for (Path* p : {&coupled, &uncoupled}) open_to(law, -1e-6, *p);
    go(law, 0.0, 3e-4, 1000, coupled);
    go<ContactLaw::uncoupled>(law, 0.0, 3e-4, 1000, uncoupled);
    REQUIRE(coupled.state.bond == 0.0);
    REQUIRE(uncoupled.state.bond == 0.0);
    coupled.largest_sigma = uncoupled.largest_sigma = 0.0;
    go(law, 0.5 * kUel, 0.0, 1000, coupled); // less than an intact crack needs to yield
    go<ContactLaw::uncoupled>(law, 0.5 * kUel, 0.0, 1000, uncoupled);
    CHECK(coupled.largest_sigma == 0.0);
    CHECK(uncoupled.state.sigma == Approx(kKn * uncoupled.state.u_n).epsilon(1e-12));
    const double turned = coupled.state.u_n;
    open_to(law, turned - 2e-6, coupled);
    CHECK(coupled.state.sigma == Approx(-kKn * 2e-6).epsilon(1e-9));
    CHECK(dem::damage(law, coupled.state) == 1.0);
}

TEST_CASE("crack unloading: until a crack opens both readings are the same law",
          "[dem][contact_law]")
{
    std::mt19937_64 random(3);
    const auto draw = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto law = crack();
    Path secant{dem::intact(law)}, elastic = fresh(law);
    int compared = 0;
    for (; compared < 2000; ++compared) {
        const double to_n = (2.0 * draw() - 1.0) * kUel, du_s = (draw() - 0.5) * 1e-5;
        const double du_n = to_n - secant.state.u_n;
        move(law, du_n, du_s, 1, secant);
        go(law, du_n, du_s, 1, elastic);
        if (secant.state.bond == 0.0) break;
        REQUIRE(elastic.state.sigma == secant.state.sigma);
        REQUIRE(elastic.state.tau == secant.state.tau);
    }
    CHECK(compared > 20);
    CHECK(secant.state.bond == elastic.state.bond);
}

namespace {

/// Opens, closes and slides at random; whether a leg ended in contact while open.
template <ContactLaw kLaw> bool ledger_closes(const CrackLaw<double>& law, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    const auto draw = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    Path p = fresh(law);
    double damage = 0.0, fracture = 0.0;
    bool propped = false;
    for (int leg = 0; leg < 40; ++leg) {
        const double to_n = (draw() - 0.3) * 2.0 * law.u_el, du_s = (draw() - 0.5) * 4e-5;
        go<kLaw>(law, to_n - p.state.u_n, du_s, 5000, p);
        CHECK(p.work == Approx(stored(law, p) + p.friction + p.fracture).epsilon(1e-9));
        CHECK(dem::damage(law, p.state) >= damage);
        CHECK(p.fracture > fracture - 1e-5); // a step across u_p, k_n du_n^2 / 8
        propped = propped || (p.state.u_n > 0.0 && p.state.sigma < 0.0);
        damage = dem::damage(law, p.state);
        fracture = p.fracture;
    }
    CHECK(damage > 0.0);
    return propped;
}

} // namespace

TEST_CASE("crack unloading: what is put in is stored or accounted for, on any path",
          "[dem][contact_law]")
{
    int propped = 0;
    for (const double ft : {2.0e6, 3.7e6, 6.0e6})
        for (const std::uint64_t seed : {1, 2, 3, 4}) {
            propped += ledger_closes<ContactLaw::coupled>(crack(ft), seed);
            propped += ledger_closes<ContactLaw::uncoupled>(crack(ft), seed);
        }
    CHECK(propped > 20); // of 24
}

TEST_CASE(
    "crack unloading: a wall stores sigma^2/(2 k_n) in a crack, however far it is propped",
    "[dem][contact_law][energy]")
{
    const dem::Model m = small_wall::model();
    const dem::StepTables t = dem::step_tables(m);
    const dem::WallMaterials w = scenes::uniform(small_wall::scene(), m);
    dem::SolverOptions o;
    o.unloading = GENERATE(Unloading::secant, Unloading::elastic);
    dem::WallState<double> s = dem::unloaded<double>(m, t, {&w, 1}, o);
    REQUIRE(dem::energy_of(t, s, 0).elastic == 0.0);
    const double kn = w.cracks[0].kn, prop = 1e-4; // [m]
    const double sigma = GENERATE(1e6, -2e6);
    const int k = t.first_crack;
    s.u_n[k] = prop + sigma / kn;
    s.stress[2 * k] = sigma;
    const double u = o.unloading == Unloading::elastic ? sigma / kn : s.u_n[k];
    CHECK(dem::energy_of(t, s, 0).elastic == Approx(0.5 * t.area[k] * sigma * u));
}
