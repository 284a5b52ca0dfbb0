#include "dem/shaking/shake.hpp"

#include "dem/block/model.hpp"
#include "dem/shaking/history_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dem {

namespace {

void require(bool ok, const char* what)
{
    if (!ok) throw std::invalid_argument(what);
}

} // namespace

void check(const ShakePlan& p)
{
    const auto finite = [](const std::vector<double>& a) {
        return std::ranges::all_of(a, [](double x) { return std::isfinite(x); });
    };
    require(p.step > 0 && std::isfinite(p.step), "time between samples must be positive");
    require(finite(p.horizontal) && finite(p.vertical),
            "accelerations of the ground must be finite");
    require(
        p.vertical.empty() || p.vertical.size() == p.horizontal.size(),
        "the vertical motion of the ground must have as many samples as the horizontal one");
    require(p.free_vibration >= 0, "the time of free vibration must not be negative");
    require(p.quiet >= 0, "the motion of a quiet wall must not be negative");
    require(p.record_every > 0, "the time between points of the history must be positive");
    require(p.contact_damping >= 0, "contact damping must not be negative");
    require(p.step_fraction > 0 && p.step_fraction <= 1,
            "the step must be above 0 and at most the largest stable one");
}

void check_shaken(const Model& m)
{
    require(
        m.loads.pattern == LoadPattern::body,
        "a wall that is shaken has a beam that moves freely: its loads must be body forces");
}

std::string_view name_of(ShakeOutcome outcome)
{
    switch (outcome) {
    case ShakeOutcome::stood:
        return "stood";
    case ShakeOutcome::collapsed:
        return "collapsed";
    case ShakeOutcome::unsettled:
        return "unsettled";
    case ShakeOutcome::not_finite:
        return "not finite";
    case ShakeOutcome::energy_astray:
        return "energy astray";
    }
    __builtin_unreachable();
}

} // namespace dem
