#include "app/study/answers/mode_rule.hpp"

#include "app/input/study/fragility_input.hpp"
#include "app/input/study/load_input.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/number_text.hpp"

#include <array>

namespace app {

namespace {

std::string units_text(int cracked)
{
    if (cracked == 0) return "cracked or not";
    return (cracked == 1 ? "a stone" : std::to_string(cracked) + " stones") +
           " cracked through";
}

} // namespace

std::string ultimate_text(const FragilityInput& f)
{
    const bool first = f.crossing == fragility::Crossing::first;
    return std::string("force ") + (first ? "first" : "finally") + " comes down to " +
           percent_text(f.ultimate_share) + " of the peak";
}

std::string backbone_text(const LoadInput& load, const FragilityInput& fragility)
{
    if (push_way(load).direction != 0) return "";
    constexpr std::array<const char*, 4> kReadOn = {
        "the mean of the backbones of both directions",
        "the backbone of the direction that reaches the limit first",
        "the backbone to the right", "the backbone to the left"};
    return std::string(" The push is cyclic; values are read on ") +
           kReadOn.at(static_cast<int>(fragility.backbone)) + ".";
}

std::string undecided_text(const FragilityInput& f)
{
    return dem::standing_is_undecided(f.mode) ? "walls that failed or still stood"
                                              : "walls that failed";
}

std::string whatever_mode_text(const FragilityInput& f)
{
    return "whatever mode the " + undecided_text(f) + " would have had in the end";
}

std::string mode_rule_text(const FragilityInput& f)
{
    const dem::ModeThresholds& t = f.mode;
    if (t.modes == dem::ModeRule::mechanism) {
        const std::string share = number(t.rotation_share, 6);
        const std::string rocking = "Rocking: at least " + share +
                                    " of the movement is rotation of the beam, whatever "
                                    "cracked. Otherwise mixed";
        const std::string sliding =
            t.cracked_units == 0 ? std::string()
                                 : ": " + units_text(t.cracked_units) +
                                       ". Otherwise rocking, or sliding if less than " + share +
                                       " of the movement is rotation of the stones";
        return rocking + sliding +
               ". With finite displacements the movement is that to where the " +
               ultimate_text(f) + ", or that since half of the way of a wall that stands";
    }
    const std::string dropped = "Mixed: the " + ultimate_text(f) + ", or ";
    const std::string overturns =
        "less than " + number(t.rotation_share, 6) + " of the movement is rotation of the beam";
    if (t.cracked_units == 0) return dropped + overturns + ". Otherwise rocking";
    return dropped + units_text(t.cracked_units) + " and " + overturns +
           ". Otherwise rocking, which includes walls that slid along a course without "
           "cracking";
}

} // namespace app
