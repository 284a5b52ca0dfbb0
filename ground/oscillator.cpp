#include "ground/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ground {

Oscillator::Oscillator(double omega, double zeta, double step)
{
    const double root = std::sqrt(1.0 - zeta * zeta), wd = omega * root, k = omega * omega;
    const double e = std::exp(-zeta * omega * step);
    const double s = e * std::sin(wd * step), c = e * std::cos(wd * step);
    const double z = zeta / root, r = 2.0 * zeta / (omega * step);
    a_ = z * s + c;
    b_ = s / wd;
    c_ = (r + ((1.0 - 2.0 * zeta * zeta) / (wd * step) - z) * s - (1.0 + r) * c) / k;
    d_ = (1.0 - r + (2.0 * zeta * zeta - 1.0) / (wd * step) * s + r * c) / k;
    a2_ = -omega / root * s;
    b2_ = c - z * s;
    c2_ = (-1.0 / step + (omega / root + z / step) * s + c / step) / k;
    d2_ = (1.0 - z * s - c) / (k * step);
}

double largest_displacement(std::span<const double> acceleration, double step, double omega,
                            double zeta)
{
    Oscillator o(omega, zeta, step);
    double most = 0.0;
    for (std::size_t i = 1; i < acceleration.size(); ++i) {
        o.advance(-acceleration[i - 1], -acceleration[i]);
        most = std::max(most, std::abs(o.u));
    }
    return most;
}

std::vector<double> low_passed(std::span<const double> acceleration, double step,
                               double cut_off)
{
    const double omega = 2.0 * std::numbers::pi * cut_off;
    Oscillator o(omega, std::numbers::sqrt2 / 2.0, step);
    std::vector<double> passed(acceleration.size(), 0.0);
    for (std::size_t i = 1; i < acceleration.size(); ++i) {
        o.advance(acceleration[i - 1], acceleration[i]);
        passed[i] = omega * omega * o.u;
    }
    return passed;
}

} // namespace ground
