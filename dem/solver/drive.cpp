#include "dem/solver/drive.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

Drive::Drive(std::vector<double> targets, const SolverOptions& options)
    : targets_(std::move(targets)), options_(options), pace_(options)
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

/// A push that turns back steps on zero, where its cycles end, and not across: some steps
/// before, it takes as many equal ones as are needed, or more if it must slow down. A short
/// last step would ring through the wall.
void Drive::land_on_zero()
{
    constexpr double kLandingSteps = 100;
    const double steps = std::ceil(std::abs(position_) / speed_ * (1.0 - 1e-9));
    if (landing_ > 0.0 && speed_ > 0.5 * landing_)
        speed_ = landing_;
    else if (steps <= kLandingSteps)
        speed_ = landing_ = std::abs(position_) / std::max(1.0, steps);
}

double Drive::advance()
{
    ++step_;
    turned_ = passed_zero_ = false;
    if (settling_ || finished()) return 0.0;
    const double left = targets_[target_] - position_;
    speed_ = pace_.next(speed_);
    if (turns_back()) speed_ = std::min(speed_, pace_.stopping_within(this->left()));
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
    if (arrives) {
        ++target_;
        turned_ = !finished() && (targets_[target_] - position_) * left < 0.0;
        turn_ += turned_ ? 1 : 0;
        if (turned_ || finished()) speed_ = 0.0;
    }
    return position_ - before;
}

double Drive::done() const { return path_ > 0.0 ? travelled_ / path_ : 1.0; }

} // namespace dem
