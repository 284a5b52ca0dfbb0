#include "app/study/mode_rule.hpp"

#include "app/input/number_text.hpp"

namespace app {

std::string mode_rule_text(const dem::ModeThresholds& t)
{
    const std::string overturns =
        "less than " + number(t.rotation_share, 6) + " of the displacement is rotation";
    if (t.cracked_units == 0)
        return "Mixed: the load fell to 80 % of its peak, or " + overturns + "; else rocking";
    return "Mixed: the load fell to 80 % of its peak, or " +
           (t.cracked_units == 1 ? "a unit" : std::to_string(t.cracked_units) + " units") +
           " cracked through and " + overturns +
           "; else rocking, with it walls that slid along a course and did not crack";
}

bool slid_whole(const dem::Mechanism& m, bool load_dropped, const dem::ModeThresholds& t)
{
    return dem::failure_mode(m, load_dropped, t) == dem::FailureMode::rocking &&
           m.rotation_share < t.rotation_share;
}

} // namespace app
