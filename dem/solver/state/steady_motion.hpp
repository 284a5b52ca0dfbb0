#pragma once
/// Tells how much of the motion of a wall goes on, and how much only rings.

#include "dem/solver/state/wall_state.hpp"

#include <cstddef>
#include <vector>

namespace dem {

/// Kinetic energy of a wall over some steps.
struct Kinetic {
    double all = 0.0;    ///< mean [J], >= steady
    double steady = 0.0; ///< of the mean velocities [J], >= 0
};

/// Samples the velocities of one wall.
class SteadyMotion {
  public:
    template <class Real> void add(const WallState<Real>& s, int lane)
    {
        if (mass_.empty())
            for (const Real& inverse : s.laws.inv_mass)
                mass_.push_back(1.0 / dem::lane(inverse, lane));
        sum_.resize(mass_.size());
        for (std::size_t m = 0; m < sum_.size(); ++m) {
            const double v = dem::lane(s.v[m], lane);
            sum_[m] += v;
            all_ += 0.5 * mass_[m] * v * v;
        }
        ++samples_;
    }

    /// Returns the energy of the samples since the last call, and starts again. Call it after
    /// add().
    [[nodiscard]] Kinetic take()
    {
        const double n = samples_;
        Kinetic k{all_ / n, 0.0};
        for (std::size_t m = 0; m < sum_.size(); ++m)
            k.steady += 0.5 * mass_[m] * (sum_[m] / n) * (sum_[m] / n);
        sum_.clear();
        all_ = 0.0;
        samples_ = 0;
        return k;
    }

  private:
    std::vector<double> mass_; ///< by mode [step2]
    std::vector<double> sum_;  ///< of velocities, by mode [sqrt(J)/step]
    double all_ = 0.0;         ///< of kinetic energies [J]
    int samples_ = 0;
};

} // namespace dem
