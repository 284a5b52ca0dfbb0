#pragma once
/// The clock of one wall: the vertical load first, then the load line visits the target displacements.

#include "dem/solver/solver_options.hpp"

#include <vector>

namespace dem {

class Drive {
  public:
    /// @param targets [m], visited in order
    Drive(std::vector<double> targets, const SolverOptions& options);

    /// Share of the vertical load that acts in the next step.
    [[nodiscard]] double load_factor() const;

    /// Advances by one step and returns the displacement of the load line in it [m], which is zero while
    /// the wall settles under vertical load.
    double advance();

    /// To be called after each step under vertical load.
    /// @param unbalanced_ratio gives that of the wall; it is called only when it is time to look
    template <class F> void settle(F unbalanced_ratio)
    {
        if (!settling_ || step_ % kLookEvery != 0 || step_ <= ramp_steps()) return;
        settled_ = unbalanced_ratio() < options_.preload_unbalance;
        settling_ = !settled_ && step_ < options_.preload_steps;
    }

    /// To be called after each step of the push. Slows the drive while the wall is out of balance.
    /// @param unbalance |top force - base shear| / vertical load [-]
    void feel(double unbalance);
    struct Felt { double unbalance, force, damping, fracture; };
    bool window_due() const { return window_ + 1 >= 200; }
    double log_m = 0;
    void weigh(double kinetic) { kinetic_ = kinetic; } // N, N, J, J
    void feel(const Felt& f);
    double set_body(double mass, double stiffness, double capacity);
    double log_calm = 1, log_cruise = 0, log_c = 0;

    /// To be told at each point of the curve whether the wall has come down to PushPlan::drop of its peak.
    void after_drop(bool yes) { haste_ = yes ? options_.haste_after_drop : 1.0; }

    /// Whether the wall is so far out of balance that the drive goes as slowly as it may.
    [[nodiscard]] bool waits() const
    {
        return options_.unbalance_limit > 0.0 &&
               unbalance_ * options_.min_speed >= haste_ * options_.unbalance_limit;
    }

    [[nodiscard]] bool settling() const { return settling_; }
    [[nodiscard]] bool settled() const { return settled_; } ///< at rest before the push
    [[nodiscard]] bool finished() const { return !settling_ && target_ >= targets_.size(); }
    [[nodiscard]] double position() const { return position_; } ///< of the load line [m]
    /// Remaining distance to the next turn, or to the end [m].
    [[nodiscard]] double left() const { return turns_[turn_] - travelled_; }
    /// Whether the last step arrived where the drive turns back.
    [[nodiscard]] bool turned() const { return turned_; }
    /// Whether the last step of a push that turns back arrived at zero displacement, which it never steps across.
    [[nodiscard]] bool passed_zero() const { return passed_zero_; }
    /// Whether a push that turns back is at its end, which is a point like its turns.
    [[nodiscard]] bool came_to_its_end() const { return turns_back() && finished(); }
    /// Remaining distance to the next turn, the end, or zero displacement [m].
    [[nodiscard]] double left_to_mark() const;
    [[nodiscard]] double done() const; ///< share of the whole path travelled [-]

  private:
    static constexpr int kLookEvery = 50;
    [[nodiscard]] bool turns_back() const { return turns_.size() > 1; }
    [[nodiscard]] bool towards_zero() const;
    void land_on_zero();
    [[nodiscard]] double fastest(double to_target) const;
    [[nodiscard]] long long ramp_steps() const
    {
        return options_.preload == Preload::solved ? 0 : options_.preload_steps / 4;
    }

    std::vector<double> targets_;
    SolverOptions options_;
    double full_speed_ = 0.0;   ///< [m/step]
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
    double farthest_right_ = 0.0, farthest_left_ = 0.0; ///< so far [m], >= 0 and <= 0
    double speed_ = 0.0;                                ///< now [m/step]
    double landing_ = 0.0;   ///< speed at which it lands on zero; 0: not yet [m/step]
    double unbalance_ = 0.0; ///< smoothed
    double mean_force_ = 0.0, kinetic_ = 0.0, last_kinetic_ = 0.0, mass0_ = 0.0, mass_ = 0.0, floor_ = 0.0, scale_ = 0.0, cruise_ = 0.0, window_damping_ = 0.0, window_fracture_ = 0.0, window_way_ = 0.0;
    double last_damping_ = 0.0, last_fracture_ = 0.0; int window_ = 0;
    double haste_ = 1.0;     ///< SolverOptions::haste_after_drop, or 1
};

} // namespace dem
