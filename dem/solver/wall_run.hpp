#pragma once
/// The push of one wall: its clock, its curve, its verdict. The state of the wall itself is in
/// a lane of a batch.

#include "dem/solver/drive.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/state/mean_stresses.hpp"
#include "dem/solver/state/recorder.hpp"
#include "dem/solver/state/steady_motion.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/step.hpp"

#include <cstddef>
#include <deque>
#include <optional>

namespace dem {

/// Data that all walls of an ensemble share.
struct Task {
    const Model& model;
    const StepTables& tables;
    const PushPlan& plan;
    const SolverOptions& options;
};

class WallRun {
  public:
    WallRun(const Task& task, std::size_t number, WallMaterials materials);

    /// Puts the wall, unloaded, into its lane.
    template <class Real> void load(WallState<Real>& state, int lane);

    /// Action of the outside on the wall in the next step.
    struct Input {
        double load_factor, drive, held;
    };
    [[nodiscard]] Input next(double top_force);

    /// Looks at the wall after the step. Returns false when the run is over.
    template <class Real> [[nodiscard]] bool look(WallState<Real>& state, int lane);

    [[nodiscard]] std::size_t number() const { return number_; }
    void spend(double seconds) { result_.cost.seconds += seconds; }
    template <class Real>
    [[nodiscard]] PushResult finish(const WallState<Real>& state, int lane);

  private:
    template <class Real> void begin_push(const WallState<Real>& state, int lane);
    template <class Real> void set_moving(WallState<Real>& state, int lane);
    template <class Real> void add_ramp_work(WallState<Real>& state, int lane) const;
    template <class Real> void settle(WallState<Real>& state, int lane);
    template <class Real> void go_on(const WallState<Real>& state, int lane);
    template <class Real> void take_point(const WallState<Real>& state, int lane);
    void keep(Snapshot&& snapshot);
    template <class Take> void keep_trail(Take take);
    template <class Real> void take_turn(const WallState<Real>& state, int lane);
    template <class Real>
    [[nodiscard]] Energy energy(const WallState<Real>& state, int lane) const;
    template <class Real> [[nodiscard]] Outcome judge(const WallState<Real>& state, int lane);

    /// Whether the wall is followed wherever it goes, and is being pushed.
    [[nodiscard]] bool may_fall() const
    {
        return options_.kinematics == Kinematics::finite && !drive_.settling();
    }
    /// Whether more of the energy that the wall has taken up moves it than it stores, and
    /// weight and load gave it that.
    [[nodiscard]] bool falls(const Energy& e);
    [[nodiscard]] WallState<double> with_stable_step();
    void reduce_step();
    void start_slowly();
    void start_again();
    [[nodiscard]] bool passed_peak();
    [[nodiscard]] bool wants_slowdown();
    void slow_down();
    [[nodiscard]] bool is_past() const;
    void keep_pace();

    const Task* task_;
    std::size_t number_;
    WallMaterials materials_;
    SolverOptions options_; ///< with the step and the accuracy of this start
    double fall_work_;      ///< least work of weight and load on a wall that falls [J]
    Drive drive_;
    ElasticPush elastic_; ///< until the push begins
    Recorder recorder_;
    SteadyMotion motion_; ///< in the push, since the last window
    MeanStresses means_;  ///< where they are asked for
    PushResult result_;
    double load_factor_ = 0.0;  ///< of the step [-]
    double force_before_ = 0.0; ///< of the drive, before the step [N]
    double step_drive_ = 0.0;   ///< of the step [m]
    /// Way of a push until it was given up, and its largest force there.
    struct Reach {
        double way = 0.0, peak = 0.0; ///< [m], [N]
    };
    std::optional<Reach> before_;   ///< of the push before, twice as fast
    double peak_then_ = 0.0;        ///< largest force over that way [N]
    Reach looked_;                  ///< at the last way that was twice the one before
    double estimated_ = 0.0;        ///< the peak whose error was read before the end [N]
    bool peak_known_ = false;       ///< since the last point
    bool eased_ = false;            ///< whether a slower push goes on as fast as the first
    double error_before_ = 0.0;     ///< of the peak of the push before [-]
    double peak_ = 0.0;             ///< largest force so far, either way [N]
    bool resists_ = false;          ///< that force acts against the displacement
    double farthest_ = 0.0;         ///< distance of the farthest turn so far [m]
    double way_ = 0.0;              ///< displacement travelled since the start of the push [m]
    double drive_work_ = 0.0;       ///< since the start of the push [J]
    double work_before_push_ = 0.0; ///< of the vertical load and self-weight, until then [J]
    double next_snapshot_ = 0.0;    ///< travelled displacement at which it is due [m]
    /// Snapshots of the wall, from 0.45 to 0.5 of its way on; each is kTrail times as far as
    /// the one before.
    std::deque<Snapshot> trail_;
    double least_given_ =
        0.0; ///< least work of the vertical load and self-weight in the push [J]
    double solved_energy_ =
        0.0; ///< stored under vertical load with closed joints; 0: not known [J]
    double work_half_way_ = 0.0; ///< after half the steps under vertical load [J]
    bool came_down_ = false;     ///< under its vertical load, before the push
    /// Steps since the last restart, so that checks fall on the same steps as in a run that
    /// used the smaller step from the beginning.
    long long steps_ = 0;
    bool decided_ = false;
};

} // namespace dem
