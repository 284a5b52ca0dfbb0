#include "dem/contact/closure.hpp"

#include <cmath>

namespace dem {

namespace {

/// Unloading down to `low` times the pressure under load, which is reached by a line `turning`
/// times as steep as that under load: share of the closing work that is lost where closure is
/// linear.
double lost_share(double turning, double low)
{
    const double turned = (turning - 1.0) / (turning - low); // closure, over the largest
    return 1.0 - (1.0 + low * turned) * (1.0 - turned) - low * turned * turned;
}

/// `low`, so that h is lost.
double low_of(double turning, double h)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (lost_share(turning, middle) > h ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace

ClosureLaw<double> closure_law(Closure closure, double initial_stiffness, double maximum,
                               double stiffest, double loss, double ks_ratio)
{
    ClosureLaw<double> law;
    law.k0 = initial_stiffness;
    law.inv_maximum = 1.0 / maximum;
    law.rise = initial_stiffness * maximum;
    law.inv_rise = 1.0 / law.rise;
    law.stiffest = stiffest;
    const double stiffer = stiffest / initial_stiffness;
    const double secant = closure == Closure::hyperbolic ? std::sqrt(stiffer) : stiffer;
    law.knee_pressure = law.rise * (secant - 1.0);
    law.knee = closure == Closure::hyperbolic ? maximum * (1.0 - 1.0 / secant)
                                              : maximum * std::log(secant);
    law.root_ks = std::sqrt(ks_ratio * initial_stiffness);
    law.inv_root_ks = 1.0 / law.root_ks;
    law.turning = loss > 0.0 ? 2.0 / (1.0 - loss) : 1.0;
    const double low = loss > 0.0 ? low_of(law.turning, loss) : 1.0;
    law.mu = (1.0 - low) / (1.0 + low);
    law.elastic = 1.0 / (1.0 + law.mu);
    law.beta = loss > 0.0 ? law.turning * (1.0 + law.mu) - 1.0 : 1.0;
    law.inv_beta = 1.0 / law.beta;
    return law;
}

} // namespace dem
