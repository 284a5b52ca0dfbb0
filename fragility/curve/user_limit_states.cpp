#include "fragility/curve/limit_states.hpp"
#include "fragility/curve/state_parts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fragility {
namespace {

[[noreturn]] void refuse(const UserLimitState& s, const std::string& why)
{
    throw std::invalid_argument("limit state \"" + s.name + "\": " + why);
}

bool sums(const UserLimitState& s) { return s.yield > 0.0 || s.peak > 0.0 || s.ultimate > 0.0; }

void check_rule(const UserLimitState& s)
{
    for (const double weight : {s.yield, s.peak, s.ultimate})
        if (!(weight >= 0.0 && std::isfinite(weight))) refuse(s, "weights must be >= 0");
    if (s.rise && !(*s.rise > 0.0 && *s.rise <= 1.0))
        refuse(s, "the share it rises to must be in (0, 1]");
    if (s.drop && !(*s.drop > 0.0 && *s.drop < 1.0))
        refuse(s, "the share it drops to must be in (0, 1)");
    if (s.at_most && !(*s.at_most > 0.0 && std::isfinite(*s.at_most)))
        refuse(s, "its largest displacement must be positive");
    const int rules = int{sums(s)} + int{s.rise.has_value()} + int{s.drop.has_value()};
    if (rules > 1) refuse(s, "more than one rule");
    if (rules == 0 && !s.at_most) refuse(s, "no rule");
}

/// Parts that sums are made of.
struct StateParts {
    LimitDisplacement yield, peak, ultimate;
};

void add(LimitDisplacement& sum, double weight, const LimitDisplacement& part)
{
    if (weight == 0.0 || sum.reading == Reading::not_defined) return;
    if (part.reading == Reading::not_defined) {
        sum = part;
        return;
    }
    sum.displacement += weight * part.displacement;
    if (part.reading == Reading::censored) sum.reading = Reading::censored;
    if (sum.reason.empty() || part.reading == Reading::censored) sum.reason = part.reason;
}

LimitDisplacement uncapped(const Curve& curve, const UserLimitState& s, const StateParts& parts,
                           const LimitStateOptions& options)
{
    if (s.rise) return rise_to(curve, *s.rise);
    if (s.drop) return drop_after_peak(curve, *s.drop, options.crossing);
    LimitDisplacement sum{0.0, Reading::observed, {}};
    add(sum, s.yield, parts.yield);
    add(sum, s.peak, parts.peak);
    add(sum, s.ultimate, parts.ultimate);
    return sum;
}

std::string short_number(double x)
{
    std::string text = std::to_string(x);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string rule_text(const UserLimitState& s)
{
    std::string text;
    const auto term = [&](double weight, const char* what) {
        if (weight > 0.0)
            text += (text.empty() ? "" : " + ") + short_number(weight) + " " + what;
    };
    term(s.yield, "d_y");
    term(s.peak, "d at the peak");
    term(s.ultimate, "d_u");
    if (s.rise) text = "first rise to " + short_number(100.0 * *s.rise) + " % of the peak";
    if (s.drop) text = "drop to " + short_number(100.0 * *s.drop) + " % of the peak";
    if (s.at_most)
        text += (text.empty() ? "" : ", at most ") + std::string("the displacement given");
    return text;
}

StateParts read_state_parts(const Curve& curve, const LimitStateOptions& options)
{
    StateParts parts;
    parts.peak = at_peak(peak(curve));
    const CurveParts read = curve_parts(curve, options);
    parts.yield = read.yield;
    parts.ultimate = read.ultimate;
    return parts;
}

} // namespace

std::vector<LimitState> read_limit_states(const Curve& curve,
                                          std::span<const UserLimitState> states,
                                          const LimitStateOptions& options)
{
    std::vector<LimitState> found;
    const StateParts parts = read_state_parts(curve, options);
    for (const UserLimitState& s : states) {
        check_rule(s);
        const bool alone = !sums(s) && !s.rise && !s.drop;
        LimitDisplacement limit;
        if (!alone) limit = uncapped(curve, s, parts, options);
        if (s.at_most)
            limit = alone ? cap_alone(curve, *s.at_most, kGivenLimitGoverns)
                          : capped(curve, limit, *s.at_most, kGivenLimitGoverns);
        found.push_back({s.name, rule_text(s), limit});
    }
    return found;
}

} // namespace fragility
