#include "dem/shaking/history_ledger.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

constexpr double kStill = 1e-8; // kinetic energy over the largest so far

} // namespace

bool HistoryLedger::read(const HistoryEnergy& energy)
{
    const Energy& e = energy.all;
    const double found =
        e.kinetic + e.elastic + e.friction + e.fracture + e.crushing + e.damping;
    passed_ = std::max({passed_, std::abs(e.work - stored_), std::abs(found - stored_),
                        std::abs(energy.ground_work), std::abs(energy.fall_work)});
    const double missing = std::abs(e.work - found);
    if (!std::isfinite(missing)) return false;
    most_missing_ = std::max(most_missing_, missing);
    most_kinetic_ = std::max(most_kinetic_, e.kinetic);
    // A swing stands still for a moment as well, where it turns.
    stood_before_ = stood_;
    stood_ = e.kinetic <= kStill * most_kinetic_;
    return true;
}

} // namespace dem
