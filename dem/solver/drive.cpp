#include "dem/solver/drive.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

// Number of steps to reach full speed. A jerk at the start would ring through the wall.
constexpr double kStartSteps = 500;
// Where a push that turns back has been before it may go so many times as fast, as long as the next turn and new ground
// are kRoom away, and in proportion nearer by. Loops move by less than 1 % of their energy (docs/cyclic.md).
constexpr double kOnKnownGround = 3.0;
constexpr double kRoom = 6e-3; // [m]
// Number of steps over which the unbalance is smoothed before it slows the drive.
constexpr double kSmoothingSteps = 50;

} // namespace

Drive::Drive(std::vector<double> targets, const SolverOptions& options)
    : targets_(std::move(targets)), options_(options)
{
    const auto stays = std::unique(targets_.begin(), targets_.end());
    targets_.erase(stays, targets_.end());
    if (!targets_.empty() && targets_.front() == position_) targets_.erase(targets_.begin());
    double from = 0.0, way = 0.0;
    for (const double to : targets_) {
        if ((to - from) * way < 0.0) turns_.push_back(path_);
        way = to - from;
        path_ += std::abs(way);
        from = to;
    }
    turns_.push_back(path_);
    full_speed_ = 1e-3 / options_.steps_per_mm;
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
    turned_ = false;
    if (settling_ || finished()) return 0.0;
    const double limit = options_.unbalance_limit;
    const double calm = limit > 0.0 && unbalance_ > limit
                            ? std::max(options_.min_speed, limit / unbalance_)
                            : 1.0;
    const double left = targets_[target_] - position_;
    const double known = left > 0.0 ? farthest_right_ - position_ : position_ - farthest_left_;
    const double room = std::clamp(std::min(known, std::abs(left)) / kRoom, 0.0, 1.0);
    const double fastest = full_speed_ * (1.0 + (kOnKnownGround - 1.0) * room);
    speed_ = std::min(fastest * calm, speed_ + full_speed_ / kStartSteps);
    const double way = std::min(speed_, std::abs(left));
    const bool arrives = way >= std::abs(left);
    const double before = position_;
    position_ = arrives ? targets_[target_] : position_ + std::copysign(way, left);
    travelled_ += way;
    farthest_right_ = std::max(farthest_right_, position_);
    farthest_left_ = std::min(farthest_left_, position_);
    if (arrives) {
        ++target_;
        speed_ = 0.0; // turn round, or stop
        turned_ = !finished() && (targets_[target_] - position_) * left < 0.0;
        turn_ += turned_ ? 1 : 0;
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
