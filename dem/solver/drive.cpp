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
// Ways between two turns that are shorter than kLongWay are gone as much slower, down to kSlowest: their loops are small,
// and what the drive itself takes is a larger share of them.
constexpr double kLongWay = 6e-3; // [m]
constexpr double kSlowest = 0.1;
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

bool Drive::towards_zero() const
{
    return turns_back() && !finished() && position_ != 0.0 &&
           position_ * targets_[target_] <= 0.0;
}

double Drive::left_to_mark() const
{
    return towards_zero() ? std::min(left(), std::abs(position_)) : left();
}

/// A push that turns back steps on zero, where its cycles end, and not across: some steps before, it takes as many
/// equal ones as are needed, or more if it must slow down. A short last step would ring through the wall.
void Drive::land_on_zero()
{
    constexpr double kLandingSteps = 100;
    const double steps = std::ceil(std::abs(position_) / speed_ * (1.0 - 1e-9));
    if (landing_ > 0.0 && speed_ > 0.5 * landing_)
        speed_ = landing_;
    else if (steps <= kLandingSteps)
        speed_ = landing_ = std::abs(position_) / std::max(1.0, steps);
}

/// Speed of a wall in balance [m/step].
/// @param to_target way to it, signed [m]
double Drive::fastest(double to_target) const
{
    const double known =
        to_target > 0.0 ? farthest_right_ - position_ : position_ - farthest_left_;
    const double room = std::clamp(std::min(known, std::abs(to_target)) / kRoom, 0.0, 1.0);
    const double steady = full_speed_ * (1.0 + (kOnKnownGround - 1.0) * room);
    if (!turns_back()) return steady;
    const double way = turns_[turn_] - (turn_ > 0 ? turns_[turn_ - 1] : 0.0);
    const double slower = std::clamp(way / kLongWay, kSlowest, 1.0);
    const double braking = full_speed_ / kStartSteps; // [m/step2]
    return std::min(slower * steady,
                    std::max(braking, std::sqrt(2.0 * braking * std::max(0.0, left()))));
}

double Drive::advance()
{
    ++step_;
    turned_ = passed_zero_ = false;
    if (settling_ || finished()) return 0.0;
    const double limit = haste_ * options_.unbalance_limit;
    const double calm = limit > 0.0 && unbalance_ > limit
                            ? std::max(options_.min_speed, limit / unbalance_)
                            : 1.0;
    const double left = targets_[target_] - position_;
    speed_ = std::min(haste_ * fastest(left) * calm, speed_ + full_speed_ / kStartSteps);
    const bool lands = towards_zero();
    if (lands)
        land_on_zero();
    else
        landing_ = 0.0;
    const double mark = lands ? std::abs(position_) : std::abs(left);
    // The last of equal steps may miss zero by rounding.
    const double way = speed_ >= mark * (lands ? 1.0 - 1e-9 : 1.0) ? mark : speed_;
    const bool arrives = way >= std::abs(left);
    passed_zero_ = lands && way >= mark;
    const double before = position_;
    position_ = arrives        ? targets_[target_]
                : passed_zero_ ? 0.0
                               : position_ + std::copysign(way, left);
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
