#pragma once
/// Makes the points of a capacity curve from the steps of one wall.

#include "dem/solver/state/curve_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>

namespace dem {

/// Sums up the steps since the last point. What rings in a wall moves the forces at its top and
/// at its base apart, one up and one down, so that a point has the mean of both; and it has the
/// mean over some steps more than its own interval, as long as the force stood still there and
/// points stay in order.
class Recorder {
  public:
    /// Points that are closer after a turn, and at the start of a push that turns back, where
    /// the force changes fast: they reach as far as two others. The first points of a push one
    /// way are as close and reach as far as one other.
    static constexpr int kAfterTurn = 32, kAtStart = 16;
    /// Steps over which a point is a mean, if it may be.
    static constexpr int kSteps = 100;
    static constexpr int kFewSteps = 5; ///< of a part of an interval of few steps

    /// Forces of the drive and of the ground [N].
    struct Forces {
        double force = 0.0, base = 0.0;
    };

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
        for (Parts* parts : {&long_parts_, &short_parts_}) parts->add(now_, fine_interval());
    }

    [[nodiscard]] bool due() const { return now_.way + late_ >= interval(); }
    /// To be called at the start and at each turn.
    /// @param close points that are closer
    void begin_way(int close = kAfterTurn)
    {
        fine_ = close;
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
        end_ = forces_at_end();
        for (Parts* parts : {&long_parts_, &short_parts_}) parts->begins = {};
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

    /// Forces where the last interval ended, along the line through the means of its last two
    /// parts: the curve may bend within the interval, where a line through two points leaves
    /// it. Each part is as long as an interval after a turn and has kSteps steps or more, or
    /// kFewSteps where the interval has fewer than two of those; nothing where it has fewer
    /// than two of these.
    [[nodiscard]] std::optional<Forces> at_end() const { return end_; }

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
    /// Where the last parts of the interval at hand begin.
    struct Parts {
        int least; ///< steps of a part
        std::array<Sums, 3> begins = {};
        void add(const Sums& now, double way)
        {
            if (now.way - begins[2].way < way || now.steps - begins[2].steps < least) return;
            begins = {begins[1], begins[2], now};
        }
    };
    [[nodiscard]] double fine_interval() const { return 2.0 * every_ / kAfterTurn; } ///< [m]
    [[nodiscard]] double interval() const { return fine_ > 0 ? fine_interval() : every_; }

    [[nodiscard]] std::optional<Forces> forces_at_end() const
    {
        const bool has_long = long_parts_.begins[1].way > 0.0;
        const auto& [begin, middle, unfinished] =
            has_long ? long_parts_.begins : short_parts_.begins;
        if (middle.way == 0.0) return std::nullopt;
        const double last = now_.way - middle.way, before = middle.way - begin.way;
        const auto led = [&](double sum_now, double sum_middle, double sum_begin) {
            const double a = (sum_now - sum_middle) / last,
                         b = (sum_middle - sum_begin) / before;
            return a + (a - b) * last / (last + before);
        };
        return Forces{led(now_.force, middle.force, begin.force),
                      led(now_.base, middle.base, begin.base)};
    }

    double every_, still_;
    int fine_ = 0; ///< points to come that are close
    double late_ =
        0.0; ///< way by which the last point was late: no step is as long as is left [m]
    Sums now_;
    Parts long_parts_{kSteps}, short_parts_{kFewSteps};
    std::optional<Forces> end_; ///< of the last interval
    std::deque<Sums> before_;   ///< of this way
    std::size_t joined_ = 1;
    double travelled_ = 0.0; ///< to the last point taken [m]
    double last_ = 0.0;      ///< where that point stands, on the way travelled [m]
};

} // namespace dem
