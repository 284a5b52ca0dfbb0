#pragma once
/// The energy balance of a history: largest error over the energy that passed, and whether the
/// wall stands still.

#include "dem/solver/state/energy.hpp"

namespace dem {

/// Energies of one wall at one instant [J].
struct HistoryEnergy {
    Energy all;                                ///< kinetic with that of the true masses
    double ground_work = 0.0, fall_work = 0.0; ///< in all.work
};

class HistoryLedger {
  public:
    HistoryLedger() = default;
    /// @param stored by the wall at rest [J];  least energy that the error is a share of [J]
    HistoryLedger(double stored, double least) : stored_(stored), passed_(least) {}

    /// Reads the balance. Returns false where a number is not finite.
    [[nodiscard]] bool read(const HistoryEnergy& energy);

    /// Largest error so far over the energy that passed [-].
    [[nodiscard]] double residual() const { return most_missing_ / passed_; }
    /// Whether nothing moved at the last two readings.
    [[nodiscard]] bool still() const { return stood_ && stood_before_; }

  private:
    double stored_ = 0.0, passed_ = 0.0, most_missing_ = 0.0, most_kinetic_ = 0.0; ///< [J]
    bool stood_ = false, stood_before_ = false;
};

} // namespace dem
