#pragma once
/// Mean stresses of the contacts of one wall over a part of its push.

#include "dem/scene/snapshot.hpp"
#include "dem/solver/wall_state.hpp"

#include <vector>

namespace dem {

struct Model;

class MeanStresses {
  public:
    /// After a step.
    /// @param way of the step [m]; its weight
    template <class Real> void add(const WallState<Real>& state, int lane, double way);

    /// Writes the means into the snapshot, and starts again.
    void give_to(Snapshot& snapshot, const Model& model);
    void start_again();

  private:
    /// Of so many steps the first is looked at: what rings takes many more.
    static constexpr int kEvery = 4;
    std::vector<double> sums_; ///< as WallState::stress, times way [Pa m]
    double way_ = 0.0;         ///< [m]
    int steps_ = 0;
};

} // namespace dem
