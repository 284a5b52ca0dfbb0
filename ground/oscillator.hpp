#pragma once

#include <span>
#include <vector>

namespace ground {

/// A linear oscillator u'' + 2 zeta omega u' + omega^2 u = p(t), exact where p is linear over a
/// step (Nigam & Jennings 1969; the coefficients as in Chopra, Dynamics of Structures, table
/// 5.2.1, for a unit mass).
class Oscillator {
  public:
    /// @param omega [rad/s], > 0
    /// @param zeta share of critical damping, in [0, 1)
    /// @param step [s], > 0
    Oscillator(double omega, double zeta, double step);

    /// From p0 at the start of the step to p1 at its end.
    void advance(double p0, double p1)
    {
        const double next = a_ * u + b_ * v + c_ * p0 + d_ * p1;
        v = a2_ * u + b2_ * v + c2_ * p0 + d2_ * p1;
        u = next;
    }

    double u = 0.0; ///< displacement
    double v = 0.0; ///< velocity

  private:
    double a_, b_, c_, d_, a2_, b2_, c2_, d2_;
};

/// Largest |u| of an oscillator at rest on ground that moves with this acceleration [m].
[[nodiscard]] double largest_displacement(std::span<const double> acceleration, double step,
                                          double omega, double zeta);

/// Acceleration behind a causal Butterworth low-pass of second order.
/// @param cut_off [Hz], > 0
[[nodiscard]] std::vector<double> low_passed(std::span<const double> acceleration, double step,
                                             double cut_off);

} // namespace ground
