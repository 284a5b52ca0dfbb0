#pragma once
/// Makes the points of a capacity curve from the steps of one wall.

#include "dem/solver/state/curve_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>

namespace dem {

/// Sums up the steps since the last point. What rings in a wall moves the forces at its top and
/// at its base apart, one up and one down, so that a point has the mean of both; and it has the
/// mean over some steps more than its own interval, as long as the force stood still there and
/// points stay in order.
class Recorder {
  public:
    /// Points that are closer after a turn, where the force changes fast: they reach as far as
    /// two others.
    static constexpr int kAfterTurn = 32;
    /// Steps over which a point is a mean, if it may be.
    static constexpr int kSteps = 100;

    /// @param every way between points [m]
    /// @param still change of the force, as a share of it, up to which it stands still [-]
    Recorder(double every, double still) : every_(every), still_(still) {}

    /// @param drive signed displacement of the step [m]
    /// @param force_before, force_after of the drive [N];  base of the ground, less what the
    /// loads give it [N]
    void add(double drive, double force_before, double force_after, double base)
    {
        const double way = drive < 0.0 ? -drive : drive;
        const double mean = 0.5 * (force_before + force_after), gap = force_after - base;
        ++now_.steps;
        now_.way += way;
        now_.displacement += drive;
        now_.force += mean * way;
        now_.base += base * way;
        now_.gap += (gap < 0.0 ? -gap : gap) * way;
    }

    [[nodiscard]] bool due() const { return now_.way + late_ >= interval(); }
    void begin_way() ///< to be called at a turn
    {
        fine_ = kAfterTurn;
        late_ = 0.0;
        before_.clear();
    }
    [[nodiscard]] bool any() const { return now_.way > 0.0; }

    /// Returns the point and starts the sums again. Call it only if any().
    [[nodiscard]] CurvePoint take(double position, const Energy& energy)
    {
        Sums all = now_;
        joined_ = 1;
        for (auto s = before_.rbegin(); s != before_.rend() && all.steps < kSteps; ++s) {
            if (std::abs(s->mean() - now_.mean()) > still_ * std::abs(now_.mean())) break;
            if (travelled_ + now_.way - 0.5 * (all.way + s->way) <= last_) break;
            all.add(*s);
            ++joined_;
        }
        travelled_ += now_.way;
        last_ = travelled_ - 0.5 * all.way;
        late_ = std::clamp(now_.way + late_ - interval(), 0.0, 0.5 * interval());
        before_.push_back(now_);
        if (before_.size() > static_cast<std::size_t>(kSteps)) before_.pop_front();
        now_ = {};
        fine_ -= fine_ > 0 ? 1 : 0;
        return {position - 0.5 * all.displacement,
                all.mean(),
                all.base / all.way,
                all.gap / all.way,
                energy,
                position};
    }

    /// Intervals between points that the last point is a mean of.
    [[nodiscard]] std::size_t joined() const { return joined_; }

  private:
    struct Sums {
        int steps = 0;
        double way = 0.0, displacement = 0.0, force = 0.0, base = 0.0, gap = 0.0;
        [[nodiscard]] double mean() const { return 0.5 * (force + base) / way; }
        void add(const Sums& s)
        {
            steps += s.steps;
            way += s.way;
            displacement += s.displacement;
            force += s.force;
            base += s.base;
            gap += s.gap;
        }
    };
    [[nodiscard]] double interval() const ///< [m]
    {
        return fine_ > 0 ? 2.0 * every_ / kAfterTurn : every_;
    }

    double every_, still_;
    int fine_ = 0; ///< points to come that are close
    double late_ =
        0.0; ///< way by which the last point was late: no step is as long as is left [m]
    Sums now_;
    std::deque<Sums> before_; ///< of this way
    std::size_t joined_ = 1;
    double travelled_ = 0.0; ///< to the last point taken [m]
    double last_ = 0.0;      ///< where that point stands, on the way travelled [m]
};

} // namespace dem
