#pragma once
/// The crack of Table 4 at one contact, moved along a path of openings and slips.

#include "dem/contact/contact_law.hpp"
#include "dem/scene/paper_materials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crack_path {

inline constexpr double kFt = 3.7e6;           // [Pa]
inline constexpr double kG = 110.0;            // [J/m2]
inline constexpr double kKn = 80.8e9;          // [Pa/m]
inline constexpr double kUel = kFt / kKn;      // 45.79 um
inline constexpr double kUul = 2.0 * kG / kFt; // 59.46 um

inline double tan_deg(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

/// Unit crack of Table 4; stiffness chosen so that there is no snap-back.
inline dem::CrackLaw<double> crack(double ft = kFt, double kn = kKn, double g = kG)
{
    dem::CrackLaw<double> law{};
    law.kn = kn;
    law.ks = dem::shear_stiffness(kn, 0.2);
    law.inv_ks = 1.0 / law.ks;
    law.ft = ft;
    law.u_el = ft / kn;
    const double u_ul = 2.0 * g / ft;
    law.inv_softening = u_ul > law.u_el ? 1.0 / (u_ul - law.u_el) : dem::kBreaksAtOnce;
    law.cohesion_drop = ft;
    law.tan_phi_res = tan_deg(35.0);
    law.tension_weight = 1.0;
    return law;
}

/// Moves a contact in n equal steps; keeps the largest stresses, the work done on it and what
/// it lost.
struct Path {
    dem::CrackState<double> state;
    double work = 0.0, friction = 0.0, fracture = 0.0; // [J/m2]
    double largest_sigma = 0.0, largest_tau = 0.0;
};

template <dem::ContactLaw kLaw = dem::ContactLaw::coupled,
          dem::Unloading kUnloading = dem::Unloading::secant>
void move(const dem::CrackLaw<double>& law, double du_n, double du_s, int n, Path& p)
{
    for (int i = 0; i < n; ++i) {
        const auto before = p.state;
        const auto u = dem::advance<kLaw, kUnloading>(law, p.state, du_n / n, du_s / n);
        p.state = u.state;
        p.friction += u.loss.friction;
        p.fracture += u.loss.fracture;
        p.work += 0.5 * (before.sigma + u.state.sigma) * du_n / n +
                  0.5 * (before.tau + u.state.tau) * du_s / n;
        p.largest_sigma = std::max(p.largest_sigma, u.state.sigma);
        p.largest_tau = std::max(p.largest_tau, u.state.tau);
    }
}

} // namespace crack_path
