#pragma once
/// Draws of one bootstrap replicate.

#include "fragility/bootstrap_random.hpp"
#include "fragility/censored_sample.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace fragility {

/// Stopping points: of a censored wall its own, of an observed one drawn from the Kaplan-Meier
/// estimate of those beyond it; infinite where there is none.
class StoppingPoints {
  public:
    explicit StoppingPoints(std::span<const Observation> walls);
    [[nodiscard]] double draw(std::size_t wall, double u) const; ///< u in (0, 1)

  private:
    std::vector<double> own_;           ///< of each wall, or NaN: drawn
    std::vector<double> value_;         ///< of each wall
    std::vector<double> at_, survival_; ///< stopping points, ascending; share beyond each
};

/// One resample from the law. Draws 2 k and 2 k + 1 are for wall k.
[[nodiscard]] std::vector<Observation> draw_law(const Distribution& law,
                                                const StoppingPoints& stops, std::size_t walls,
                                                const RandomBits& bits,
                                                std::uint64_t replicate);

} // namespace fragility
