#include "dem/solver/pace.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace dem {

namespace {

// Shares of the accuracy. Free choices; docs/bench/accuracy.md has what they hold.
constexpr double kInertia = 0.2;
const double kDamping = std::getenv("D_C") ? std::atof(std::getenv("D_C")) : 0.5;
// A wall whose first force is not known yet has this share of what it can carry.
constexpr double kFirstForce = 0.02;
// Change of the force in a period of the wall, as a share of the largest so far, or of kFirstRise of what it can carry: kRise
// times the root of the accuracy. Faster, a wall swings beyond the force at which a mechanism forms.
const double kRise = std::getenv("D_R") ? std::atof(std::getenv("D_R")) : 1.5, kFirstRise = 0.1;
constexpr double kUnknownStart = 1e-4; // of the fastest speed, where stiffness is not known
// Steps over which unbalance and force are smoothed.
constexpr double kUnbalanceSteps = 50.0, kForceSteps = 200.0;
// Change of the cruising speed from one window to the next.
constexpr double kFaster = 1.5, kSlower = 0.5;
// The cruising speed is at least what the largest acceleration reaches in so many steps: slower, a wall that only rings
// would seem to be dragged.
constexpr double kLeastSteps = 20.0;
// What rings in a wall may seem to be mass; at most so many times that of the wall.
constexpr double kMostMass = 1e4;

} // namespace

Pace::Pace(const SolverOptions& options)
    : options_(options), fastest_(1e-3 / options.steps_per_mm), cruise_(fastest_)
{
}

double Pace::begin(double stiffness, double mass, double force, double damping)
{
    window_.damping = damping;
    scale_ = kFirstForce * force;
    least_mass_ = mass_ = mass;
    if (constant()) return fastest_;
    if (!(stiffness > 0.0 && mass > 0.0 && force > 0.0)) {
        cruise_ = kUnknownStart * fastest_;
        return 0.0;
    }
    const double period = 2.0 * std::numbers::pi * std::sqrt(mass / stiffness); // [steps]
    rise_ = kRise * std::sqrt(options_.accuracy) / period;
    first_rise_ = kFirstRise * force;
    cruise_ = std::min(fastest_, rise_ * first_rise_ / stiffness);
    return cruise_;
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

void Pace::feel(const Felt& felt, double speed, double kinetic)
{
    unbalance_ += (felt.unbalance - unbalance_) / kUnbalanceSteps;
    if (constant()) return;
    force_ += (felt.force - force_) / kForceSteps;
    scale_ = std::max(scale_, std::abs(force_));
    window_.way += felt.way;
    last_ = felt;
    if (++window_.steps < kWindow) return;
    if (speed > 0.0) {
        const double measured =
            std::min(2.0 * kinetic / (speed * speed), kMostMass * least_mass_);
        mass_ = std::max({least_mass_, measured, 0.5 * mass_});
    }
    change_cruise();
    window_ = {0, 0.0, felt.damping, felt.fracture, force_};
}

/// Damping per displacement is what the drive takes, unless something has broken and set energy free.
void Pace::change_cruise()
{
    const double allowed = kDamping * error_allowed() * window_.way;
    const double damping = last_.damping - window_.damping,
                 fracture = last_.fracture - window_.fracture;
    if (fracture <= error_allowed() * window_.way)
        cruise_ *= damping > 0.0 ? std::clamp(allowed / damping, kSlower, kFaster) : kFaster;
    const double risen = std::abs(force_ - window_.force),
                 may_rise = rise_ * kWindow * std::max(scale_, first_rise_);
    if (rise_ > 0.0 && risen > may_rise) cruise_ *= std::max(kSlower, may_rise / risen) / kFaster;
    const double least = std::min(fastest_, kLeastSteps * acceleration());
    cruise_ = std::clamp(cruise_, least, fastest_);
}

} // namespace dem
