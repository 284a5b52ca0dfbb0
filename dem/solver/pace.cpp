#include "dem/solver/pace.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dem {

namespace {

// Inertia and damping may take these shares of the accuracy. Both are free choices;
// docs/bench/accuracy/accuracy.md has what they hold.
constexpr double kInertia = 0.1, kDamping = 0.25;
// Local damping takes most of what rings, and drags the wall less than it takes.
constexpr double kLocalDamping = 1.5;
// Damping of blocks that only ring counts so much: where joints slide, it takes in place of
// friction.
constexpr double kRinging = 0.35;
// A wall whose first force is not known yet has this share of what it can carry.
constexpr double kFirstForce = 0.02;
// Change of the force in a period of the wall, as a share of the largest so far, or of
// kFirstRise of what it can carry: kRise times the root of the accuracy. Faster, a wall swings
// beyond the force at which a mechanism forms.
constexpr double kRise = 1.5, kFirstRise = 0.1;
constexpr double kUnknownStart = 1e-4; // of the fastest speed, where stiffness is not known
// Steps over which unbalance and force are smoothed.
constexpr double kUnbalanceSteps = 50.0, kForceSteps = 200.0;
// Change of the cruising speed from one window to the next.
constexpr double kFaster = 1.5, kSlower = 0.5;
// The cruising speed is at least this share of the one at the start: slower, a wall that moves
// by itself would seem to be dragged. And it is so fast that the first way takes so many steps,
// over the accuracy, at most, and each e-fold of it after that as many: a push does not know
// where it will end. A push whose whole way is short has kShortWay times that as first way.
constexpr double kSlowest = 0.3, kMostSteps = 4e3;
constexpr double kFirstWay = 0.03; // [m], to which the walls of the paper are pushed
constexpr double kShortWay = 4.0;  // a free choice: more of it is faster and less accurate
// A wall that moves by itself may seem to be heavy; at most so many times as in its elastic
// motion.
constexpr double kMostMass = 100.0;

} // namespace

Pace::Pace(const SolverOptions& options)
    : options_(options), fastest_(1e-3 / options.steps_per_mm), cruise_(fastest_),
      first_way_(kFirstWay)
{
}

double Pace::begin(const PushStart& start)
{
    window_.damping = start.damping;
    first_way_ = std::min(kFirstWay, kShortWay * start.way);
    scale_ = kFirstForce * start.most_force;
    least_mass_ = mass_ = start.mass;
    if (constant()) return fastest_;
    way_ = 0.0;
    if (!(start.stiffness > 0.0 && start.mass > 0.0 && start.most_force > 0.0)) {
        cruise_ = kUnknownStart * fastest_;
        return 0.0;
    }
    const double period =
        2.0 * std::numbers::pi * std::sqrt(start.mass / start.stiffness); // [steps]
    rise_ = kRise * std::sqrt(options_.accuracy) / period;
    first_rise_ = kFirstRise * start.most_force;
    cruise_ = std::min(fastest_, rise_ * first_rise_ / start.stiffness);
    least_ = kSlowest * cruise_;
    return cruise_;
}

void Pace::change(const SolverOptions& options)
{
    const double times = options.accuracy / options_.accuracy;
    options_ = options;
    fastest_ = 1e-3 / options.steps_per_mm;
    cruise_ = std::min(fastest_, cruise_ * times);
    rise_ *= std::sqrt(times);
}

double Pace::slowest_cruise() const
{
    const double by_way = std::max(first_way_, way_) * options_.accuracy / kMostSteps;
    return std::min(fastest_, std::max(by_way, least_));
}

double Pace::acceleration() const
{
    return mass_ > 0.0 && scale_ > 0.0 ? kInertia * error_allowed() / mass_
                                       : kUnknownStart * fastest_;
}

double Pace::next(double speed) const
{
    if (constant()) return fastest_;
    const double allowed = unbalance_allowed();
    const double calm =
        unbalance_ > allowed ? std::max(options_.min_speed, allowed / unbalance_) : 1.0;
    return std::min(cruise_ * calm, speed + acceleration());
}

double Pace::stopping_within(double way) const
{
    const double a = constant() ? fastest_ / kUnbalanceSteps : acceleration();
    return std::max(a, std::sqrt(2.0 * a * std::max(0.0, way)));
}

void Pace::feel(const Felt& felt, const Kinetic& kinetic)
{
    unbalance_ += (felt.unbalance - unbalance_) / kUnbalanceSteps;
    if (constant()) return;
    force_ += (felt.force - force_) / kForceSteps;
    scale_ = std::max(scale_, std::abs(force_));
    window_.way += felt.way;
    last_ = felt;
    if (++window_.steps < kWindow) return;
    way_ += window_.way;
    if (window_.way > 0.0) {
        const double speed = window_.way / kWindow;
        const double mass =
            std::min(2.0 * kinetic.steady / (speed * speed), kMostMass * least_mass_);
        mass_ = std::max({least_mass_, mass, 0.5 * mass_});
        change_cruise(kinetic);
    }
    window_ = {0, 0.0, felt.damping, felt.fracture, force_};
}

/// Damping per displacement is what the drive takes, unless something has broken and set energy
/// free.
void Pace::change_cruise(const Kinetic& kinetic)
{
    const double steady = kinetic.all > 0.0 ? kinetic.steady / kinetic.all : 1.0;
    const double taken =
        (kRinging + (1.0 - kRinging) * steady) * (last_.damping - window_.damping);
    const double share = options_.damping == Damping::local ? kLocalDamping : kDamping;
    const double allowed = share * error_allowed() * window_.way;
    if (last_.fracture - window_.fracture <= error_allowed() * window_.way)
        cruise_ *= taken > 0.0 ? std::clamp(allowed / taken, kSlower, kFaster) : kFaster;
    const double risen = std::abs(force_ - window_.force),
                 may_rise = rise_ * kWindow * std::max(scale_, first_rise_);
    if (rise_ > 0.0 && risen > may_rise)
        cruise_ *= std::max(kSlower, may_rise / risen) / kFaster;
    cruise_ = std::clamp(cruise_, slowest_cruise(), fastest_);
}

} // namespace dem
