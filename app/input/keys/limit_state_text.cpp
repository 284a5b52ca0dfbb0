#include "app/input/keys/limit_state_text.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/words.hpp"
#include "fragility/codes/code_table.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace app {
namespace {

constexpr std::array<std::string_view, 5> kTerms = {"yield", "peak", "ultimate", "rise",
                                                    "drop"};

[[noreturn]] void refuse_state(std::string_view state, const std::string& why)
{
    throw BadValue("limit state " + in_quotes(state) + ": " + why);
}

double number_of(std::string_view state, std::string_view text)
{
    try {
        return parse_quantity(text, "");
    } catch (const BadValue& bad) {
        refuse_state(state, bad.what());
    }
}

/// "0.7 yield", "yield", "drop 0.5"
void read_term(std::string_view name, std::string_view term, fragility::UserLimitState& state)
{
    const auto words = split(term, " ");
    const bool share = words.front() == "rise" || words.front() == "drop";
    if (share && words.size() != 2)
        refuse_state(name, in_quotes(term) + " has no share; write \"" +
                               std::string(words.front()) + " 0.5\"");
    if (share) {
        (words.front() == "rise" ? state.rise : state.drop) = number_of(name, words[1]);
        return;
    }
    const double weight = words.size() > 1 ? number_of(name, words.front()) : 1.0;
    const std::string_view what = words.back();
    if (words.size() > 2 || !(weight > 0.0))
        refuse_state(name, in_quotes(term) +
                               " is not a term; write a positive factor and one of " +
                               listed(kTerms));
    if (what == "yield") {
        state.yield += weight;
    } else if (what == "peak") {
        state.peak += weight;
    } else if (what == "ultimate") {
        state.ultimate += weight;
    } else {
        refuse_state(name,
                     in_quotes(what) + " is not read off curves; " + suggestion(what, kTerms));
    }
}

double drift_of(std::string_view name, std::string_view text)
{
    if (!text.ends_with('%')) refuse_state(name, in_quotes(text) + " is not a drift in %");
    const double percent = number_of(name, trimmed(text.substr(0, text.size() - 1)));
    if (!(percent > 0.0 && percent <= 100.0))
        refuse_state(name, in_quotes(text) + " is out of range; must be in (0, 100] %");
    return percent / 100.0;
}

UserState parse_state(std::string_view text)
{
    const std::size_t colon = text.find(':');
    const std::string_view name = trimmed(text.substr(0, colon));
    if (colon == std::string_view::npos || name.empty())
        throw BadValue(in_quotes(text) + " is not a limit state; write \"name: 0.7 yield\"");
    UserState user;
    user.state.name = name;
    auto rules = split(text.substr(colon + 1), " or ");
    if (rules.back().ends_with('%')) {
        user.most_drift = drift_of(name, rules.back());
        user.cap = rules.back();
        rules.pop_back();
    }
    if (rules.size() > 1)
        refuse_state(name, "only a drift may follow \"or\", such as \"ultimate or 1.0 %\"");
    if (!rules.empty())
        for (const std::string_view term : split(rules.front(), "+"))
            read_term(name, term, user.state);
    return user;
}

/// From the foot of the wall, where its flexural capacity is attained, to the contraflexure
/// point [m]: half-way up where the beam does not turn.
double shear_span(const dem::Beam& beam, const LoadInput& load)
{
    const bool turns = !beam.present || beam.rotation == dem::BeamRotation::free;
    return turns ? load.height : 0.5 * load.height;
}

/// Asks for the rule of a state: what contradicts itself is refused.
void check_state(const UserState& user)
{
    ReadingRules rules;
    rules.user = {user};
    static_cast<void>(state_names(rules));
}

/// Sets that a study may ask for, "user" among them.
std::vector<std::string_view> set_words(const std::vector<fragility::Code>& codes)
{
    std::vector<std::string_view> words;
    for (const fragility::Code& code : codes)
        if (!code.states.empty()) words.push_back(code.name);
    words.emplace_back("user");
    return words;
}

void add_set(const FragilityInput& fragility, const StudyFile& source, std::string_view name,
             ReadingRules& rules)
{
    if (name == "user") {
        rules.user = parse_user_states(fragility.user_states);
        if (rules.user.empty())
            throw BadValue(
                "is missing, and the set user needs it; write \"name: 0.7 yield; ...\"");
        return;
    }
    const std::vector<fragility::Code> codes = known_codes(fragility);
    const fragility::Code* const code = fragility::find_code(codes, name);
    if (code == nullptr)
        throw error_at(source, "fragility.limit_states",
                       in_quotes(name) + " is not a set; " +
                           suggestion(name, set_words(codes)));
    if (code->states.empty())
        throw error_at(source, "fragility.limit_states",
                       "of " + in_quotes(name) + ", " + code->title +
                           ", nothing is given here: " + code->missing +
                           "; write its limit states into a file of your own "
                           "(fragility.codes, docs/codes.md)");
    if (fragility::find_code(rules.sets, name) == nullptr) rules.sets.push_back(*code);
}

} // namespace

std::vector<UserState> parse_user_states(std::string_view text)
{
    std::vector<UserState> states;
    std::set<std::string> names;
    for (const std::string_view part : split(text, ";")) {
        if (part.empty()) continue;
        states.push_back(parse_state(part));
        const fragility::UserLimitState& s = states.back().state;
        if (!names.insert(s.name).second) refuse_state(s.name, "given twice; keep one of them");
        check_state(states.back());
    }
    return states;
}

std::vector<fragility::Code> known_codes(const FragilityInput& fragility)
{
    std::vector<fragility::Code> codes = fragility.own_codes;
    for (const fragility::Code& code : fragility::built_in_codes())
        if (fragility::find_code(codes, code.name) == nullptr) codes.push_back(code);
    return codes;
}

std::vector<fragility::Code> pier_codes(const FragilityInput& fragility,
                                        const ReadingRules& rules)
{
    std::vector<fragility::Code> codes;
    const std::vector<fragility::Code> known = known_codes(fragility);
    for (const std::string_view name : {"ntc", "ec8"})
        codes.push_back(*fragility::find_code(known, name));
    for (const fragility::Code& set : rules.sets)
        if (limits_drift(set) && fragility::find_code(codes, set.name) == nullptr)
            codes.push_back(set);
    return codes;
}

ReadingRules reading_rules(const Study& study)
{
    const FragilityInput& f = study.fragility;
    ReadingRules rules;
    rules.options = {f.ultimate_share, f.crossing, f.bilinear_share};
    rules.mode = f.mode;
    rules.height = study.load.height;
    rules.slenderness = shear_span(study.beam, study.load) / wall_length(study);
    rules.direction = push_way(study.load).direction;
    rules.backbone = f.backbone;
    rules.accuracy = study.solver.accuracy;
    read_at(study.source, "fragility.user_states", [&] {
        static_cast<void>(parse_user_states(f.user_states)); // also where no set asks for them
        for (const std::string_view name : split(f.limit_states, ","))
            add_set(study.fragility, study.source, name, rules);
    });
    return rules;
}

} // namespace app
