#pragma once
/// The history of one wall: its clock, its maxima, its verdict. The state of the wall itself is
/// in a lane.

#include "dem/shaking/free_vibration.hpp"
#include "dem/shaking/history_ledger.hpp"
#include "dem/shaking/shake.hpp"
#include "dem/shaking/shaking_clock.hpp"
#include "dem/shaking/shaking_step.hpp"

#include <cstddef>
#include <vector>

namespace dem {

/// Data that all histories of an ensemble share.
struct ShakenTask {
    const Model& model;
    const StepTables& tables;
    const SolverOptions& options;
};

/// @throws std::invalid_argument if a number of the plan is out of its range
void check(const ShakePlan& plan);
/// @throws std::invalid_argument if the model is of a kind that cannot be shaken
void check_shaken(const Model& model);

class HistoryRun {
  public:
    /// @throws std::invalid_argument as check() does, or where joints that close are to have
    /// dashpots
    HistoryRun(const ShakenTask& task, std::size_t number, WallMaterials materials,
               ShakePlan plan);

    /// Brings the wall to rest under its loads and puts it into its lane. Returns false when
    /// the history is over at once.
    template <class Real> [[nodiscard]] bool load(ShakenWalls<Real>& walls, int lane);

    /// Motion of the ground in the next step.
    [[nodiscard]] ShakingInput<double> next() const;

    /// Looks at the wall after the step. Returns false when the history is over.
    template <class Real> [[nodiscard]] bool look(ShakenWalls<Real>& walls, int lane);

    [[nodiscard]] std::size_t number() const { return number_; }
    void spend(double seconds) { seconds_ += seconds; }
    template <class Real>
    [[nodiscard]] ShakeResult finish(const ShakenWalls<Real>& walls, int lane);

  private:
    void set_clock(const StepLimits& limits);
    [[nodiscard]] double damped_fraction(const StepLimits& limits) const;
    template <class Real>
    [[nodiscard]] double displacement(const WallState<Real>& state, int lane) const;
    template <class Real> void find_top(const WallState<Real>& state, int lane);
    template <class Real> void watch(const ShakenWalls<Real>& walls, int lane);
    template <class Real> void judge(const ShakenWalls<Real>& walls, int lane);
    template <class Real> void judge_energy(const ShakenWalls<Real>& walls, int lane);
    template <class Real>
    [[nodiscard]] bool collapsed(const ShakenWalls<Real>& walls, int lane) const;
    template <class Real>
    [[nodiscard]] Snapshot snapshot(const WallState<Real>& state, int lane) const;
    [[nodiscard]] bool wants_smaller_step() const;
    void start_again();

    const ShakenTask* task_;
    std::size_t number_;
    WallMaterials materials_;
    ShakePlan plan_;
    SolverOptions options_; ///< with the share of the stable step of this start
    std::vector<BlockMass> masses_;
    double fraction_;   ///< of the stable step, of this start [-]
    double load_;       ///< vertical [N]
    double peak_ = 0.0; ///< of the ground [m/s2]
    double seconds_ = 0.0;
    std::vector<int> top_blocks_; ///< whose mean displacement is told
    ShakingClock clock_;
    HistoryLedger ledger_;
    FreeVibration free_;
    ShakeResult r_;
    double top_x_ = 0.0;           ///< of the top at rest [m]
    double top_u_ = 0.0;           ///< displacement of the top, now [m]
    bool further_ = false;         ///< the wall was never so far out
    std::vector<ContactRun> foot_; ///< dry joints between what the ground holds and what moves
    double raised_ =
        0.0; ///< energy of blocks that are let go, above their undeformed place [J]
    double next_point_ = 0.0, next_snapshot_ = 0.0; ///< [s]
    std::vector<bool> open_;
};

} // namespace dem
