#pragma once
/// Draws of one bootstrap replicate.

#include "fragility/fits/bootstrap_random.hpp"
#include "fragility/fits/censored_sample.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace fragility {

/// Where the runs of resampled walls stop. A censored wall keeps its own stopping point. For an
/// observed wall one is drawn from the Kaplan-Meier estimate of the stopping points beyond its
/// value; it is infinite if there is none (Davison and Hinkley 1997, algorithm 3.2).
class StoppingPoints {
  public:
    explicit StoppingPoints(std::span<const Observation> walls);
    [[nodiscard]] double draw(std::size_t wall, double u) const; ///< u in (0, 1)

  private:
    std::vector<double> own_;           ///< of each wall, or NaN: drawn
    std::vector<double> value_;         ///< of each wall
    std::vector<double> at_, survival_; ///< stopping points, ascending; share beyond each
};

/// One resample from the law. Wall k uses draws 2 k and 2 k + 1.
[[nodiscard]] std::vector<Observation> draw_law(const Distribution& law,
                                                const StoppingPoints& stops, std::size_t walls,
                                                const RandomBits& bits,
                                                std::uint64_t replicate);

} // namespace fragility
