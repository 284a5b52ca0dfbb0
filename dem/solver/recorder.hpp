#pragma once
/// Makes the points of a capacity curve from the steps of one wall.

#include "dem/solver/curve_point.hpp"

namespace dem {

/// Sums up the steps since the last point.
class Recorder {
  public:
    /// Points that are closer after a turn, where the force changes fast: they reach as far as two others.
    static constexpr int kAfterTurn = 32;

    explicit Recorder(double every) : every_(every) {}

    /// @param drive signed displacement of the step [m];  forces before and after the step [N]
    void add(double drive, double force_before, double force_after, double base_shear)
    {
        const double way = drive < 0.0 ? -drive : drive;
        const double mean = 0.5 * (force_before + force_after);
        const double gap = force_after - base_shear;
        way_ += way;
        displacement_ += drive;
        force_ += mean * way;
        base_ += base_shear * way;
        gap_ += (gap < 0.0 ? -gap : gap) * way;
    }

    [[nodiscard]] bool due() const
    {
        return way_ >= (fine_ > 0 ? 2.0 * every_ / kAfterTurn : every_);
    }
    void begin_way() { fine_ = kAfterTurn; } ///< to be called at a turn
    [[nodiscard]] bool any() const { return way_ > 0.0; }

    /// Returns the point and starts the sums again. Call it only if any().
    [[nodiscard]] CurvePoint take(double position, const Energy& energy)
    {
        const CurvePoint p{position - 0.5 * displacement_, force_ / way_, base_ / way_,
                           gap_ / way_, energy};
        const int fine = fine_ > 0 ? fine_ - 1 : 0;
        *this = Recorder(every_);
        fine_ = fine;
        return p;
    }

  private:
    double every_;
    int fine_ = 0; ///< points to come that are close
    double way_ = 0.0, displacement_ = 0.0, force_ = 0.0, base_ = 0.0, gap_ = 0.0;
};

} // namespace dem
