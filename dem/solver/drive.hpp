#pragma once
/// The clock of one wall: the vertical load first, then the load line visits the target
/// displacements.

#include "dem/solver/pace.hpp"

#include <vector>

namespace dem {

class Drive {
  public:
    /// @param targets [m], visited in order
    Drive(std::vector<double> targets, const SolverOptions& options);

    /// Share of the vertical load that acts in the next step.
    [[nodiscard]] double load_factor() const;

    /// Advances by one step and returns the displacement of the load line in it [m], which is
    /// zero while the wall settles under vertical load.
    double advance();

    /// To be called after each step under vertical load.
    /// @param at_rest tells whether the wall is; it is called only when it is time to look
    template <class F> void settle(F at_rest)
    {
        if (!settling_ || step_ % kLookEvery != 0 || step_ <= ramp_steps()) return;
        settled_ = at_rest();
        settling_ = !settled_ && step_ < options_.preload_steps;
    }

    /// Begins the push, whose whole way the drive knows: see Pace::begin.
    double begin(PushStart start)
    {
        start.way = path_;
        return speed_ = pace_.begin(start);
    }

    /// Feels each step of the push.
    [[nodiscard]] Pace& pace() { return pace_; }

    /// Whether the wall is so far out of balance that the drive goes as slowly as it may.
    [[nodiscard]] bool waits() const { return pace_.waits(); }

    [[nodiscard]] bool settling() const { return settling_; }
    [[nodiscard]] bool settled() const { return settled_; } ///< at rest before the push
    [[nodiscard]] bool finished() const { return !settling_ && target_ >= targets_.size(); }
    [[nodiscard]] double position() const { return position_; } ///< of the load line [m]
    /// Remaining distance to the next turn, or to the end [m].
    [[nodiscard]] double left() const { return turns_[turn_] - travelled_; }
    /// Whether the last step arrived where the drive turns back.
    [[nodiscard]] bool turned() const { return turned_; }
    /// Whether the last step of a push that turns back arrived at zero displacement, which it
    /// never steps across.
    [[nodiscard]] bool passed_zero() const { return passed_zero_; }
    /// Whether the push turns back on its way.
    [[nodiscard]] bool turns_back() const { return turns_.size() > 1; }
    /// Whether a push that turns back is at its end, which is a point like its turns.
    [[nodiscard]] bool came_to_its_end() const { return turns_back() && finished(); }
    /// Remaining distance to the next turn, the end, or zero displacement [m].
    [[nodiscard]] double left_to_mark() const;
    [[nodiscard]] double done() const; ///< share of the whole path travelled [-]

  private:
    static constexpr int kLookEvery = 50;
    [[nodiscard]] bool towards_zero() const;
    void land_on_zero();
    [[nodiscard]] long long ramp_steps() const
    {
        return options_.preload == Preload::solved ? 0 : options_.preload_steps / 4;
    }

    std::vector<double> targets_;
    SolverOptions options_;
    Pace pace_;
    double path_ = 0.0;         ///< [m]
    std::vector<double> turns_; ///< travelled way at each turn, and at the end [m]
    std::size_t turn_ = 0;      ///< the next of them
    bool turned_ = false, passed_zero_ = false;
    bool settling_ = true;
    bool settled_ = false;
    long long step_ = 0;
    std::size_t target_ = 0;
    double position_ = 0.0;
    double travelled_ = 0.0;
    double speed_ = 0.0;   ///< now [m/step]
    double landing_ = 0.0; ///< speed at which it lands on zero; 0: not yet [m/step]
};

} // namespace dem
