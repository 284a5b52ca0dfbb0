#include "dem/solver/drive.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

// Number of steps to reach full speed. A jerk at the start would ring through the wall.
constexpr double kStartSteps = 500;
// Number of steps over which the unbalance is smoothed before it slows the drive.
constexpr double kSmoothingSteps = 50;

} // namespace

Drive::Drive(std::vector<double> targets, const SolverOptions& options)
    : targets_(std::move(targets)), options_(options)
{
    double from = 0.0;
    for (const double to : targets_) {
        path_ += std::abs(to - from);
        from = to;
    }
    full_speed_ = 1e-3 / options_.steps_per_mm;
    while (target_ < targets_.size() && targets_[target_] == position_) ++target_;
}

double Drive::load_factor() const
{
    if (!settling_) return 1.0;
    const double s = std::min(1.0, static_cast<double>(step_ + 1) /
                                       static_cast<double>(std::max(1LL, ramp_steps())));
    return s * s * (3.0 - 2.0 * s);
}

double Drive::advance()
{
    ++step_;
    if (settling_ || finished()) return 0.0;
    const double limit = options_.unbalance_limit;
    const double calm = limit > 0.0 && unbalance_ > limit
                            ? std::max(options_.min_speed, limit / unbalance_)
                            : 1.0;
    speed_ = std::min(full_speed_ * calm, speed_ + full_speed_ / kStartSteps);
    const double left = targets_[target_] - position_;
    const double way = std::min(speed_, std::abs(left));
    const bool arrives = way >= std::abs(left);
    const double before = position_;
    position_ = arrives ? targets_[target_] : position_ + std::copysign(way, left);
    travelled_ += way;
    if (arrives) {
        ++target_;
        speed_ = 0.0; // turn round, or stop
    }
    return position_ - before;
}

void Drive::feel(double unbalance)
{
    if (settling_) return;
    unbalance_ += (unbalance - unbalance_) / kSmoothingSteps;
}

double Drive::done() const { return path_ > 0.0 ? travelled_ / path_ : 1.0; }

} // namespace dem
