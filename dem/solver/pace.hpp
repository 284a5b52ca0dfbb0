#pragma once
/// How fast a wall is pushed, so that the drive takes no more than the accuracy allows. What
/// the solver adds to the force of the wall itself is felt in three ways, each as a share of
/// the largest force so far:
///   inertia    the wall is accelerated no faster than kInertia of the accuracy allows;
///   damping    its energy per displacement is held at kDamping of the accuracy, by the
///   cruising speed;
///   unbalance  |top force - base shear|, where something breaks: above unbalance_limit of the
///   accuracy the drive waits.
/// docs/theory.md, section 4, Speed.

#include "dem/solver/state/solver_options.hpp"
#include "dem/solver/state/steady_motion.hpp"

namespace dem {

/// Response of a wall in one step of its push.
struct Felt {
    double way = 0.0;       ///< of the drive in the step [m], >= 0
    double force = 0.0;     ///< of the drive [N]
    double unbalance = 0.0; ///< |drive + loads - base shear| [N]
    double damping = 0.0;   ///< energy so far [J]
    double fracture = 0.0;  ///< energy so far [J]
};

/// Facts of a wall that are known before its push.
struct PushStart {
    double stiffness = 0.0;  ///< while nothing opens, slips or cracks [N/m]; 0: not known
    double mass = 0.0;       ///< 2 kinetic energy / speed^2 of that motion [N step2/m]
    double most_force = 0.0; ///< size of what it can carry [N]
    double damping = 0.0;    ///< energy so far [J]
    double way = 0.0;        ///< of the whole push, if nothing ends it before [m]
};

class Pace {
  public:
    explicit Pace(const SolverOptions& options);

    /// Begins the push.
    /// @return speed at which the wall is set moving [m/step]
    double begin(const PushStart& start);

    /// Holds another accuracy and another fastest speed from now on.
    void change(const SolverOptions& options);

    /// Speed of the next step [m/step], > 0.
    /// @param speed now [m/step]
    [[nodiscard]] double next(double speed) const;

    /// Largest speed from which the drive can stop within a way [m/step].
    [[nodiscard]] double stopping_within(double way) const;

    /// Whether the motion after the next step is to be sampled.
    [[nodiscard]] bool samples() const
    {
        return !constant() && (window_.steps + 1) % kSampleEvery == 0;
    }
    /// Whether the next feel() ends a window, and reads the kinetic energy of its samples.
    [[nodiscard]] bool ends_window() const
    {
        return !constant() && window_.steps + 1 == kWindow;
    }

    /// To be called after each step of the push.
    /// @param kinetic of the window, read where ends_window() asked for it
    void feel(const Felt& felt, const Kinetic& kinetic);

    /// Whether the wall is so far out of balance that the drive goes as slowly as it may.
    [[nodiscard]] bool waits() const
    {
        return !constant() && unbalance_ * options_.min_speed >= unbalance_allowed();
    }

  private:
    static constexpr int kWindow = 200;     ///< steps over which damping is measured
    static constexpr int kSampleEvery = 10; ///< steps

    [[nodiscard]] bool constant() const { return options_.unbalance_limit == 0.0; }
    [[nodiscard]] double error_allowed() const { return options_.accuracy * scale_; } ///< [N]
    [[nodiscard]] double unbalance_allowed() const
    {
        return options_.unbalance_limit * error_allowed();
    }
    [[nodiscard]] double acceleration() const;   ///< largest [m/step2]
    [[nodiscard]] double slowest_cruise() const; ///< of the way so far [m/step]
    void change_cruise(const Kinetic& kinetic);

    SolverOptions options_;
    double fastest_;          ///< [m/step]
    double cruise_;           ///< speed of a wall in balance [m/step]
    double first_way_;        ///< that the push has at least [m]
    double least_ = 0.0;      ///< cruising speed that the start of the push allows [m/step]
    double way_ = 0.0;        ///< of the push, in whole windows [m]
    double scale_ = 0.0;      ///< largest force so far [N]
    double force_ = 0.0;      ///< smoothed [N]
    double unbalance_ = 0.0;  ///< smoothed [N]
    double rise_ = 0.0;       ///< largest change of the force, as a share [1/step]; 0: any
    double first_rise_ = 0.0; ///< force of which it is a share at least [N]
    double least_mass_ = 0.0, mass_ = 0.0; ///< that the drive moves [N step2/m]
    struct {
        int steps = 0;
        double way = 0.0, damping = 0.0, fracture = 0.0; ///< [m], and at its begin [J]
        double force = 0.0;                              ///< at its begin [N]
    } window_;
    Felt last_;
};

} // namespace dem
