#pragma once
/// Closure of dry joints under pressure, as pure functions over Real = double or Pack
/// (pack.hpp).
///   w = max(0, -u_n)   closure [m]
///   hyperbolic         p = k_0 w / (1 - w / V)       secant  k_0 + p / V   (Bandis, Lumsden
///   and Barton 1983)
///   exponential        p = k_0 V (exp(w / V) - 1)    tangent k_0 + p / V   (Malama and
///   Kulatilake 2003)
/// Where the tangent reaches `stiffest` the law goes straight on with it.
///
/// Shear. The stiffness follows the pressure: k_s = r (k_0 + p / V). The stress is tau =
/// sqrt(k_s) z, where dz = sqrt(k_s) du_s, so that tau du_s = d(z^2 / 2) on every path: what is
/// stored is a function of the state, nothing can be taken out that was not put in, and
/// pressure that goes up and down by a little leaves all as it was. (tau kept while k_s falls
/// would make energy, the elastic slip kept while k_s falls loses some with every ripple.)
///
/// Loss. Asperities rub on one another as they close: the pressure is
///   P = (p + f) / (1 + mu),   f = beta (p - p_r), held within -mu p and mu p,
/// where p_r moves so that f stays within. Load follows p, unloading goes down to (1 - mu) / (1
/// + mu) of it. Stored is
///   (1 + beta) Phi(w) - beta (Phi(w_r) + p_r (w - w_r)), over 1 + mu, with Phi the integral of
///   p, and p_r = p(w_r);
/// it is convex, and lost is beta (w - w_r) dp_r / (1 + mu), which is never negative. Nothing
/// depends on rates, and ripples within 2 mu / (beta + mu) of the pressure lose nothing. A
/// joint that turns is 2 / (1 - h) times as stiff as under load, a free choice; mu is then such
/// that a cycle from nothing to any pressure and back loses the share h of the closing work
/// where closure is linear, and nearly that where it is not.

#include "dem/contact/contact_options.hpp"
#include "dem/contact/crushing.hpp"
#include "dem/contact/pack.hpp"

namespace dem {

template <class Real> struct ClosureLaw {
    Real k0;             ///< [Pa/m]
    Real inv_maximum;    ///< 1 / V [1/m]
    Real inv_rise;       ///< 1 / (k_0 V) [1/Pa]
    Real rise;           ///< k_0 V [Pa]
    Real stiffest;       ///< largest tangent [Pa/m]
    Real knee;           ///< closure at which the tangent reaches it [m]
    Real knee_pressure;  ///< [Pa]
    Real root_ks;        ///< sqrt(r k_0) [sqrt(Pa/m)]
    Real inv_root_ks;    ///< of that
    Real mu;             ///< friction of closing [-], in [0, 1); 0: no loss
    Real beta, inv_beta; ///< [-], beta >= 1, so that p_r is never below zero
    Real elastic;        ///< 1 / (1 + mu) [-]
    Real turning; ///< stiffness of a joint that turns over that under load [-]; 1: no loss
};

/// Calls `work(number of one, number of other)` for all numbers of two laws.
template <class A, class B, class Work>
void for_each_number(const ClosureLaw<A>& one, ClosureLaw<B>& other, Work work)
{
    work(one.k0, other.k0);
    work(one.inv_maximum, other.inv_maximum);
    work(one.inv_rise, other.inv_rise);
    work(one.rise, other.rise);
    work(one.stiffest, other.stiffest);
    work(one.knee, other.knee);
    work(one.knee_pressure, other.knee_pressure);
    work(one.root_ks, other.root_ks);
    work(one.inv_root_ks, other.inv_root_ks);
    work(one.mu, other.mu);
    work(one.beta, other.beta);
    work(one.inv_beta, other.inv_beta);
    work(one.elastic, other.elastic);
    work(one.turning, other.turning);
}

/// exp(x), for 0 <= x <= 7, within 1e-12 of itself.
template <class Real> [[nodiscard]] Real exp_of(Real x)
{
    const Real one(1.0), y = Real(1.0 / 64.0) * x;
    Real e(1.0 / 40320.0);
    for (const double c : {1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5})
        e = multiply_add(e, y, Real(c));
    e = multiply_add(e * y, y, y + one);
    for (int doubled = 0; doubled < 6; ++doubled) e = e * e;
    return e;
}

/// log(r), for 1 <= r <= 1e3, within 1e-9 of itself: it serves the ledger.
template <class Real> [[nodiscard]] Real log_of(Real r)
{
    for (int halved = 0; halved < 3; ++halved) r = sqrt(r);
    const Real one(1.0), z = (r - one) / (r + one), z2 = z * z;
    Real sum(1.0 / 15.0);
    for (int n = 13; n >= 1; n -= 2) sum = multiply_add(sum, z2, Real(1.0 / n));
    return Real(16.0) * (z * sum);
}

/// -log(1 - x) - x, for 0 <= x < 1, within 1e-8 of itself, however small x is.
template <class Real> [[nodiscard]] Real log_beyond(Real x)
{
    const Real y = x / (Real(2.0) - x), y2 = y * y; // -log(1 - x) = 2 artanh(y)
    Real sum(1.0 / 15.0);
    for (int n = 13; n >= 3; n -= 2) sum = multiply_add(sum, y2, Real(1.0 / n));
    const Real near = multiply_add(Real(2.0) * y2 * y, sum, x * y);
    const auto far = x > Real(0.5);
    if (!any(far)) return near;
    return select(far, Real(2.0) * log_of(inverse_root(Real(1.0) - x)) - x, near);
}

/// exp(x) - 1 - x, for 0 <= x <= 0.5, within 1e-12 of itself, however small x is.
template <class Real> [[nodiscard]] Real exp_beyond(Real x)
{
    Real sum(1.0);
    for (int n = 12; n >= 3; --n) sum = multiply_add(Real(1.0 / n) * x, sum, Real(1.0));
    return Real(0.5) * x * x * sum;
}

/// Pressure and shear stiffness of a joint that has closed.
template <Closure kClosure, class Real> struct Closed {
    Real p;    ///< [Pa]
    Real root; ///< sqrt(k_s) over that without pressure, sqrt(1 + p / (k_0 V)) [-]
    /// sqrt(k_s) and 1 / sqrt(k_s) [sqrt(Pa/m)]. Most contacts have no use for the second, and
    /// a division takes long.
    [[nodiscard]] Real root_ks(const ClosureLaw<Real>& law) const { return law.root_ks * root; }
    [[nodiscard]] Real inverse_root_ks(const ClosureLaw<Real>& law) const
    {
        return law.inv_root_ks * (Real(1.0) / root);
    }
};

/// A hyperbola has the inverse without a division.
template <class Real> struct Closed<Closure::hyperbolic, Real> {
    Real p, root;
    Real inverse; ///< 1 / root [-]
    [[nodiscard]] Real root_ks(const ClosureLaw<Real>& law) const { return law.root_ks * root; }
    [[nodiscard]] Real inverse_root_ks(const ClosureLaw<Real>& law) const
    {
        return law.inv_root_ks * inverse;
    }
};

/// @param w >= 0 [m]
template <Closure kClosure, class Real>
[[nodiscard, gnu::always_inline]] inline Closed<kClosure, Real>
closed_by(const ClosureLaw<Real>& law, Real w)
{
    constexpr bool kHyperbolic = kClosure == Closure::hyperbolic;
    const Real one(1.0), within = min(w, law.knee), x = within * law.inv_maximum;
    const auto beyond = w > law.knee;
    Real p, root, inverse;
    if constexpr (kHyperbolic) {
        root = inverse_root(one - x);
        inverse = (one - x) * root;
        p = law.k0 * within * (root * root);
    } else {
        root = exp_of(Real(0.5) * x);
        p = law.rise * multiply_add(root, root, -one);
    }
    if (any(beyond)) {
        const Real farther = multiply_add(law.stiffest, w - within, p);
        root = select(beyond, sqrt(multiply_add(farther, law.inv_rise, one)), root);
        if constexpr (kHyperbolic) inverse = select(beyond, one / root, inverse);
        p = select(beyond, farther, p);
    }
    if constexpr (kHyperbolic)
        return {p, root, inverse};
    else
        return {p, root};
}

/// p [Pa]. @param w >= 0 [m]
template <Closure kClosure, class Real>
[[nodiscard]] Real pressure_of(const ClosureLaw<Real>& law, Real w)
{
    return closed_by<kClosure>(law, w).p;
}

/// dp/dw where the pressure is p [Pa/m].
template <Closure kClosure, class Real>
[[nodiscard]] Real tangent_at(const ClosureLaw<Real>& law, Real p)
{
    const Real secant = multiply_add(p, law.inv_rise, Real(1.0)); // over k_0
    const Real tangent = kClosure == Closure::hyperbolic ? secant * secant : secant;
    return min(law.stiffest, law.k0 * tangent);
}

/// w at which the pressure is p [m]. @param p >= 0 [Pa]
template <Closure kClosure, class Real>
[[nodiscard]] Real closure_at(const ClosureLaw<Real>& law, Real p)
{
    const Real within = min(p, law.knee_pressure);
    const Real beyond = (p - within) / law.stiffest;
    if constexpr (kClosure == Closure::hyperbolic)
        return within / multiply_add(within, law.inv_maximum, law.k0) + beyond;
    else
        return Real(2.0) * log_of(sqrt(multiply_add(within, law.inv_rise, Real(1.0)))) /
                   law.inv_maximum +
               beyond;
}

/// Phi, the integral of p over w, from p and w [J/m2].
template <Closure kClosure, class Real>
[[nodiscard]] Real closing_energy(const ClosureLaw<Real>& law, Real p, Real w)
{
    const Real within = min(w, law.knee), at = min(p, law.knee_pressure), more = w - within;
    const Real beyond = more * multiply_add(Real(0.5) * law.stiffest, more, law.knee_pressure);
    const Real unit = law.rise / law.inv_maximum, x = within * law.inv_maximum;
    if constexpr (kClosure == Closure::hyperbolic) {
        return multiply_add(unit, log_beyond(x), beyond);
    } else {
        const Real most(0.5);
        const Real far = (at - law.k0 * within) / law.inv_maximum; // small x would leave noise
        return select(x > most, far, unit * exp_beyond(min(x, most))) + beyond;
    }
}

template <class Real> struct ClosingState {
    Real u_n;   ///< [m]
    Real shear; ///< z [sqrt(J)/m]
    Real rest;  ///< p_r [Pa]; used where there is loss
};

/// Stored, per area [J/m2].
template <Closure kClosure, class Real>
[[nodiscard]] Real stored_energy(const ClosureLaw<Real>& law, const ClosingState<Real>& s)
{
    const Real w = max(Real(0.0), -s.u_n), p = pressure_of<kClosure>(law, w);
    const Real sheared = Real(0.5) * s.shear * s.shear;
    const Real phi = closing_energy<kClosure>(law, p, w);
    if (!any(law.mu > Real(0.0))) return phi + sheared;
    const Real w_r = closure_at<kClosure>(law, s.rest);
    const Real phi_r = closing_energy<kClosure>(law, s.rest, w_r);
    const Real bound = law.elastic * (phi + law.beta * ((phi - phi_r) - s.rest * (w - w_r)));
    return select(law.mu > Real(0.0), bound, phi) + sheared;
}

template <class Real> struct ClosingUpdate {
    ClosingState<Real> state;
    Real sigma, tau; ///< [Pa]
    Real friction;   ///< lost in slip and in closing, per area [J/m2]
    Real closing;    ///< lost in closing alone, per area [J/m2], >= 0
    Real slip;       ///< plastic [m]
    Real pressure;   ///< p [Pa]
};

/// A dry joint that has closed. |tau| <= P tan_phi
/// @param kLoses whether any lane has mu > 0
/// @param closed by the opening u_n after this step
template <Closure kClosure, bool kLoses, class Real>
[[nodiscard, gnu::always_inline]] inline ClosingUpdate<Real>
slide_closed(const ClosureLaw<Real>& law, Real tan_phi, const ClosingState<Real>& s, Real u_n,
             const Closed<kClosure, Real>& closed, Real du_s)
{
    const Real zero(0.0), half(0.5), w = max(zero, -u_n);
    const Real p = closed.p, root = closed.root_ks(law);
    Real acting = p, rest = s.rest, lost = zero;
    if constexpr (kLoses) {
        const Real most = law.mu * p;
        const Real f = max(-most, min(most, law.beta * (p - rest)));
        const Real moved = max(zero, p - f * law.inv_beta);
        const auto moves = (moved > rest) | (moved < rest);
        if (any(moves & (law.mu > zero))) {
            const Real w_before = max(zero, -s.u_n);
            const Real apart = (w - closure_at<kClosure>(law, moved)) +
                               (w_before - closure_at<kClosure>(law, rest));
            lost = max(zero, half * law.beta * law.elastic * apart * (moved - rest));
            lost = select(law.mu > zero, lost, zero);
        }
        rest = moved;
        acting = law.elastic * (p + f);
    }
    const Real trial = multiply_add(root, du_s, s.shear);
    const Real limit = acting * tan_phi, tau_trial = root * trial;
    const Real tau = max(-limit, min(limit, tau_trial));
    const auto slips = abs(tau_trial) > limit;
    Real shear = trial, slid = zero, slip = zero;
    // A hyperbola has its inverse without a division, which takes longer than the rest.
    if (kClosure == Closure::hyperbolic || any(slips)) {
        const Real inverse = closed.inverse_root_ks(law);
        shear = select(slips, tau * inverse, trial);
        slid = trial - shear;
        slip = slid * inverse;
    }
    return {{u_n, shear, rest},
            zero - acting,
            tau,
            multiply_add(half * (s.shear + shear), slid, lost),
            lost,
            slip,
            p};
}

/// A dry joint that closes and slides.
template <Closure kClosure, bool kLoses, class Real>
[[nodiscard, gnu::always_inline]] inline ClosingUpdate<Real>
advance_closing(const ClosureLaw<Real>& law, Real tan_phi, const ClosingState<Real>& s,
                Real du_n, Real du_s)
{
    const Real u_n = s.u_n + du_n;
    return slide_closed<kClosure, kLoses>(law, tan_phi, s, u_n,
                                          closed_by<kClosure>(law, max(Real(0.0), -u_n)), du_s);
}

/// crushed_by() of a joint that closes: until p is the strength that is left.
template <Closure kClosure, class Real>
[[nodiscard]] Real crushed_by(const CrushingLaw<Real>& crushing, const ClosureLaw<Real>& law,
                              Real crushed, Real u_e)
{
    constexpr int kNewton = 4; // from one side of the root of a convex function
    const Real zero(0.0), w = max(zero, -u_e);
    const Real left = max(zero, crushing.strength - crushing.softening * crushed);
    const auto crushes = pressure_of<kClosure>(law, w) > left;
    if (!any(crushes)) return zero;
    Real by = max(zero, w - closure_at<kClosure>(law, left)); // enough where nothing softens
    for (int i = 0; i < kNewton; ++i) {
        const Real p = pressure_of<kClosure>(law, w - by);
        const Real steeper = tangent_at<kClosure>(law, p) - crushing.softening;
        const Real excess = multiply_add(crushing.softening, by, p - left);
        by = select(steeper > zero, by + excess / steeper, w);
        by = max(zero, min(by, w));
    }
    const auto holds = crushing.strength - crushing.softening * (crushed + by) > zero;
    return select(crushes, select(holds, by, w), zero);
}

/// @param initial_stiffness k_0 [Pa/m], > 0;  maximum V [m], > 0;  stiffest [Pa/m], >= k_0
/// @param loss h [-], in [0, 1);  ks_ratio k_s / k_n [-], > 0
[[nodiscard]] ClosureLaw<double> closure_law(Closure closure, double initial_stiffness,
                                             double maximum, double stiffest, double loss,
                                             double ks_ratio);

} // namespace dem
