#include "app/fragility/fragility_states.hpp"

#include "app/input/number_text.hpp"
#include "app/input/units.hpp"
#include "app/input/words.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

namespace app {
namespace {

constexpr std::array<std::string_view, 4> kSets = {"paper", "ntc", "ec8", "user"};
constexpr std::array<std::string_view, 5> kTerms = {"yield", "peak", "ultimate", "rise",
                                                    "drop"};

std::vector<std::string_view> split(std::string_view text, std::string_view by)
{
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t at = text.find(by);
        parts.push_back(trimmed(text.substr(0, at)));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + by.size());
    }
}

[[noreturn]] void refuse(std::string_view state, const std::string& why)
{
    throw BadValue("limit state " + in_quotes(state) + ": " + why);
}

double number_of(std::string_view state, std::string_view text)
{
    try {
        return parse_quantity(text, "");
    } catch (const BadValue& bad) {
        refuse(state, bad.what());
    }
}

/// "0.7 yield", "yield", "drop 0.5"
void read_term(std::string_view name, std::string_view term, fragility::UserLimitState& state)
{
    const auto words = split(term, " ");
    const bool share = words.front() == "rise" || words.front() == "drop";
    if (share && words.size() != 2)
        refuse(name, in_quotes(term) + " has no share; write \"" + std::string(words.front()) +
                         " 0.5\"");
    if (share) {
        (words.front() == "rise" ? state.rise : state.drop) = number_of(name, words[1]);
        return;
    }
    const double weight = words.size() > 1 ? number_of(name, words.front()) : 1.0;
    const std::string_view what = words.back();
    if (words.size() > 2 || !(weight > 0.0))
        refuse(name, in_quotes(term) + " is no term; write a positive factor and one of " +
                         listed(kTerms));
    if (what == "yield") {
        state.yield += weight;
    } else if (what == "peak") {
        state.peak += weight;
    } else if (what == "ultimate") {
        state.ultimate += weight;
    } else {
        refuse(name, in_quotes(what) + " is not read off curves; " + suggestion(what, kTerms));
    }
}

double drift_of(std::string_view name, std::string_view text)
{
    if (!text.ends_with('%')) refuse(name, in_quotes(text) + " is no drift in %");
    const double percent = number_of(name, trimmed(text.substr(0, text.size() - 1)));
    if (!(percent > 0.0 && percent <= 100.0))
        refuse(name, in_quotes(text) + " is out of range; must be in (0, 100] %");
    return percent / 100.0;
}

UserState parse_state(std::string_view text)
{
    const std::size_t colon = text.find(':');
    const std::string_view name = trimmed(text.substr(0, colon));
    if (colon == std::string_view::npos || name.empty())
        throw BadValue(in_quotes(text) + " is no limit state; write \"name: 0.7 yield\"");
    UserState user;
    user.state.name = name;
    auto rules = split(text.substr(colon + 1), " or ");
    if (rules.back().ends_with('%')) {
        user.most_drift = drift_of(name, rules.back());
        rules.pop_back();
    }
    if (rules.size() > 1)
        refuse(name, "only a drift may follow \"or\", such as \"ultimate or 1.0 %\"");
    if (!rules.empty())
        for (const std::string_view term : split(rules.front(), "+"))
            read_term(name, term, user.state);
    return user;
}

fragility::UserLimitState with_cap(const UserState& user, double height)
{
    fragility::UserLimitState s = user.state;
    if (user.most_drift > 0.0) s.at_most = user.most_drift * height;
    return s;
}

/// Rises to 1 at 1, falls to 0 at 2: any rule can be read off it.
constexpr std::array<double, 3> kTrialX{0.0, 1.0, 2.0}, kTrialY{0.0, 1.0, 0.0};
const fragility::Curve kTrial{kTrialX, kTrialY};

} // namespace

std::vector<UserState> parse_user_states(std::string_view text)
{
    std::vector<UserState> states;
    std::set<std::string> names;
    for (const std::string_view part : split(text, ";")) {
        if (part.empty()) continue;
        states.push_back(parse_state(part));
        const fragility::UserLimitState& s = states.back().state;
        if (!names.insert(s.name).second) refuse(s.name, "given twice; keep one of them");
        const std::array trial{with_cap(states.back(), 1.0)};
        try {
            static_cast<void>(fragility::read_limit_states(kTrial, trial));
        } catch (const std::invalid_argument& e) {
            throw BadValue(e.what());
        }
    }
    return states;
}

WantedStates wanted_states(const Study& study)
{
    const FragilityInput& f = study.fragility;
    WantedStates wanted;
    wanted.options = {f.ultimate_share, f.crossing, f.bilinear_share};
    for (const std::string_view name : split(f.limit_states, ",")) {
        const auto set = fragility::limit_state_set(name);
        if (!set && name != "user")
            throw error_at(study.source, "fragility.limit_states",
                           in_quotes(name) + " is no set; " + suggestion(name, kSets));
        const auto& sets = wanted.sets;
        if (set && std::find(sets.begin(), sets.end(), *set) == sets.end())
            wanted.sets.push_back(*set);
        if (set) continue;
        try {
            wanted.user = parse_user_states(f.user_states);
        } catch (const BadValue& bad) {
            throw error_at(study.source, "fragility.user_states", bad.what());
        }
        if (wanted.user.empty())
            throw error_at(study.source, "fragility.user_states",
                           "missing for the set user; write \"name: 0.7 yield; ...\"");
    }
    return wanted;
}

std::vector<StateName> state_names(const WantedStates& wanted)
{
    std::vector<StateName> names;
    for (const fragility::LimitStateSet set : wanted.sets)
        for (const fragility::LimitState& s :
             fragility::read_limit_states(kTrial, set, wanted.options))
            names.push_back({std::string(name(set)), std::string(s.name), s.rule});
    for (const UserState& user : wanted.user) {
        const std::array trial{with_cap(user, 1.0)};
        std::string rule = fragility::read_limit_states(kTrial, trial).front().rule;
        if (const auto at = rule.find("the displacement given"); at != std::string::npos)
            rule = rule.substr(0, at) + number(100.0 * user.most_drift, 6) + " % drift";
        names.push_back({"user", user.state.name, rule});
    }
    return names;
}

std::vector<fragility::LimitDisplacement> read_states(const fragility::Curve& curve,
                                                      const WantedStates& wanted, double height)
{
    std::vector<fragility::LimitDisplacement> limits;
    for (const fragility::LimitStateSet set : wanted.sets)
        for (const auto& s : fragility::read_limit_states(curve, set, wanted.options))
            limits.push_back(s.limit);
    std::vector<fragility::UserLimitState> user;
    for (const UserState& u : wanted.user) user.push_back(with_cap(u, height));
    for (const auto& s : fragility::read_limit_states(curve, user, wanted.options))
        limits.push_back(s.limit);
    return limits;
}

} // namespace app
