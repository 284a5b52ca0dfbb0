#include "dem/solver/drive.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

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
double env(const char* n, double d) { const char* e = std::getenv(n); return e ? std::atof(e) : d; }
const double pU = env("D_U", 0.3);      // unbalance limit / (tol force)
const double pA = env("D_A", 0.3);      // inertia of acceleration / (tol force)
const double pC = env("D_C", 0.5);      // damping drag / (tol force)
const double pV = env("D_V", 250);      // top speed steps/mm
const double pM = env("D_M", 0.01);     // min speed / cruise
const double pW = env("D_W", 200);      // window
const double pG = env("D_G", 1.5);      // growth per window
const double pS = env("D_S", 1e-3);     // first cruise / top
const double pH = env("D_H", 0);
const double pK = env("D_K", 0.0);
const double p0 = env("D_0", 0.02);
const double pP = env("D_P", 3);
const double pX = env("D_X", 1);
const double pF = env("D_F", 20);

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
    options_.accuracy *= pX;
    full_speed_ = 1e-3 / pV; cruise_ = pS * full_speed_;
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
    const double h = pH > 0 ? haste_ : 1.0;
    const double limit = h * pU * options_.accuracy * scale_;
    const double calm = unbalance_ > limit ? std::max(pM, limit / unbalance_) : 1.0;
    const double a = pA * options_.accuracy * scale_ / mass_;
    const double left = targets_[target_] - position_;
    double want = cruise_ * calm;
    if (turns_back()) want = std::min(want, std::max(a, std::sqrt(2.0 * a * std::max(0.0, this->left()))));
    speed_ = std::min(want, speed_ + a);
    log_calm = calm; log_cruise = cruise_;
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

double Drive::set_body(double mass, double stiffness, double capacity)
{
    mass0_ = mass_ = mass > 0 ? mass : 1.0;
    floor_ = scale_ = p0 * capacity;
    if (!(stiffness > 0.0 && mass > 0.0)) { cruise_ = 1e-4 * full_speed_; return 0.0; }
    const double period = 2.0 * M_PI * std::sqrt(mass / stiffness);
    cruise_ = speed_ = std::min(full_speed_, pP * std::sqrt(options_.accuracy) * capacity / stiffness / period);
    last_kinetic_ = 0.0;
    return speed_;
}

void Drive::feel(const Felt& f)
{
    if (settling_) return;
    unbalance_ += (f.unbalance - unbalance_) / kSmoothingSteps;
    mean_force_ += (f.force - mean_force_) / 200.0;
    scale_ = std::max(scale_, std::abs(mean_force_));
    window_damping_ += f.damping - last_damping_;
    window_fracture_ += f.fracture - last_fracture_;
    last_damping_ = f.damping;
    last_fracture_ = f.fracture;
    window_way_ += speed_;
    if (++window_ < 200) return;
    const double mean = window_way_ / window_;
    const double measured = mean > 0 ? std::min(2.0 * kinetic_ / (speed_ * speed_), 1e4 * mass0_) : mass0_;
    mass_ = std::max({mass0_, measured, 0.5 * mass_});
    log_m = mass_ / mass0_;
    window_damping_ += pK * (kinetic_ - last_kinetic_);
    last_kinetic_ = kinetic_;
    const double c = window_way_ > 0 ? window_damping_ / (window_way_ * scale_ * options_.accuracy) : 1.0;
    log_c = c;
    const bool breaks = window_fracture_ > options_.accuracy * scale_ * window_way_;
    if (!breaks) cruise_ *= std::clamp(pC / std::max(c, 1e-9), 0.5, pG);
    cruise_ = std::clamp(cruise_, std::min(full_speed_, pF * pA * options_.accuracy * scale_ / mass_), full_speed_);
    window_ = 0;
    window_damping_ = window_fracture_ = window_way_ = 0.0;
}

double Drive::done() const { return path_ > 0.0 ? travelled_ / path_ : 1.0; }

} // namespace dem
