#include "fragility/codes/code.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace fragility {
namespace {

/// The drift limit of a mode; nullptr: none.
const CodeDrift* drift_of(const CodeState& state, std::string_view mode)
{
    const CodeDrift* other = nullptr;
    for (const auto& [name, drift] : state.drifts) {
        if (name == mode) return &drift;
        if (name == "other") other = &drift;
    }
    return other;
}

double value_of(const CodeState& state, const CodeDrift& drift, double slenderness)
{
    return state.times * (drift.by_slenderness ? drift.drift * slenderness : drift.drift);
}

std::string when(std::string_view mode, bool alone, bool first)
{
    if (mode == "other") return alone ? "" : " if not";
    const std::string who = first ? " if the wall " : " if it ";
    if (mode == "rocking") return who + "rocks";
    if (mode == "sliding") return who + "slides";
    return who + "fails in a mixed mode";
}

} // namespace

double drift_limit(const CodeState& state, std::string_view mode, double slenderness)
{
    const CodeDrift* const drift = drift_of(state, mode);
    return drift == nullptr ? 0.0 : value_of(state, *drift, slenderness);
}

bool limits_drift(const Code& code)
{
    return std::ranges::any_of(code.states,
                               [](const CodeState& s) { return !s.drifts.empty(); });
}

std::string source_text(const CodeState& state)
{
    std::string text;
    for (const std::string& part : {state.source, state.article, state.remark})
        if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
    return text;
}

std::string drift_text(const CodeState& state, double slenderness)
{
    std::string text;
    for (const auto& [mode, drift] : state.drifts) {
        text += text.empty() ? "a drift of " : ", ";
        text += percent(state.times * drift.drift);
        if (drift.by_slenderness) text += " x H0/D";
        if (drift.by_slenderness && slenderness > 0.0)
            text += " = " + percent(value_of(state, drift, slenderness));
        text += when(mode, state.drifts.size() == 1, &mode == &state.drifts.front().first);
    }
    return text;
}

std::string percent(double share)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), 100.0 * share,
                                   std::chars_format::general, 4);
    return std::string(text.data(), end.ptr) + " %";
}

} // namespace fragility
