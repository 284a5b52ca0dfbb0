#pragma once
/// Mean stresses of the contacts of one wall over the parts of its push that the points of its
/// curve are means of (dem/solver/state/recorder.hpp).

#include "dem/scene/geometry/snapshot.hpp"
#include "dem/solver/state/wall_state.hpp"

#include <cstddef>
#include <deque>
#include <vector>

namespace dem {

struct Model;

class MeanStresses {
  public:
    /// After a step.
    /// @param way of the step [m]; its weight
    template <class Real> void add(const WallState<Real>& state, int lane, double way);

    /// At a point of the curve.
    void end_interval();

    /// Writes the means over the last intervals into a snapshot.
    /// @param intervals that the point of the curve is a mean of, >= 1
    void give_to(Snapshot& snapshot, const Model& model, std::size_t intervals) const;

    void begin_way() ///< at a turn
    {
        ended_.clear();
    }

  private:
    /// The first of so many steps is looked at.
    static constexpr int kEvery = 4;
    struct Sums {
        std::vector<double> stress; ///< as WallState::stress, times way [Pa m]
        double way = 0.0;           ///< [m]
        int steps = 0;
    };
    Sums now_;
    std::deque<Sums> ended_; ///< the last ones
};

} // namespace dem
