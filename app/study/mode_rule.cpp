#include "app/study/mode_rule.hpp"

#include "app/input/number_text.hpp"
#include "app/study/fragility_text.hpp"

namespace app {

std::string ultimate_text(const FragilityInput& f)
{
    const bool first = f.crossing == fragility::Crossing::first;
    return std::string("force ") + (first ? "first" : "finally") + " comes down to " +
           percent_text(f.ultimate_share) + " of the peak";
}

std::string mode_rule_text(const FragilityInput& f)
{
    const dem::ModeThresholds& t = f.mode;
    const std::string dropped = "Mixed: the " + ultimate_text(f) + ", or ";
    const std::string overturns =
        "less than " + number(t.rotation_share, 6) + " of the displacement is rotation";
    if (t.cracked_units == 0) return dropped + overturns + "; else rocking";
    return dropped +
           (t.cracked_units == 1 ? "a unit" : std::to_string(t.cracked_units) + " units") +
           " cracked through and " + overturns +
           "; else rocking, with it walls that slid along a course and did not crack";
}

} // namespace app
