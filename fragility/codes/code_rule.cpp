#include "fragility/codes/code_rule.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fragility {
namespace {

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// A part that needs neither share nor name; CodePart::state: none of them.
CodePart part_of(std::string_view word)
{
    if (word == "yield") return CodePart::yield;
    if (word == "yield or peak") return CodePart::yield_or_peak;
    if (word == "peak") return CodePart::peak;
    if (word == "ultimate") return CodePart::ultimate;
    if (word == "collapse") return CodePart::collapse;
    return CodePart::state;
}

/// A number whose every character counts; NaN: it is none.
double whole_number(std::string_view text)
{
    double value = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    return end.ec == std::errc() && end.ptr == text.data() + text.size() ? value : NAN;
}

void read_share(std::string_view word, std::string_view share, CodeState& state)
{
    state.factor = positive_number(share);
    state.part = word == "rise" ? CodePart::rise : CodePart::drop;
    const bool good = state.factor < 1.0 || (word == "rise" && state.factor == 1.0);
    if (!good)
        throw std::invalid_argument(quoted(share) + " is no share of the peak; write \"" +
                                    std::string(word) + " 0.5\"");
}

} // namespace

void read_rule(std::string_view text, CodeState& state)
{
    text = trimmed(text);
    state.part = part_of(text);
    if (state.part != CodePart::state) return;
    const auto space = text.find(' ');
    if (space == std::string_view::npos)
        throw std::invalid_argument(quoted(text) + " is not " + std::string(rule_words()));
    const std::string_view first = text.substr(0, space), rest = trimmed(text.substr(space));
    if (first == "rise" || first == "drop") return read_share(first, rest, state);
    state.factor = positive_number(first);
    state.factor_text = first;
    state.part = part_of(rest);
    if (state.part == CodePart::state) state.of_name = rest;
}

std::string_view rule_words()
{
    return "a rule; write yield, yield or peak, peak, ultimate, collapse, a share of one of "
           "them or of another limit state such as 3/4 NC, rise 0.33 or drop 0.5";
}

CodeDrift drift_of_text(std::string_view text)
{
    CodeDrift drift;
    std::string_view rest = trimmed(text);
    constexpr std::string_view kSlender = "H0/D";
    if (rest.ends_with(kSlender)) {
        drift.by_slenderness = true;
        rest = trimmed(rest.substr(0, rest.size() - kSlender.size()));
    }
    const bool percent = rest.ends_with('%');
    if (percent) rest = trimmed(rest.substr(0, rest.size() - 1));
    drift.drift = whole_number(rest) / 100.0;
    if (!percent || !(drift.drift > 0.0 && drift.drift <= 1.0))
        throw std::invalid_argument(
            quoted(text) + " is no drift in (0, 100] %; write \"1.0 %\" or \"0.8 % H0/D\"");
    return drift;
}

double positive_number(std::string_view text)
{
    const auto stroke = text.find('/');
    double value = whole_number(text.substr(0, stroke));
    if (stroke != std::string_view::npos) value /= whole_number(text.substr(stroke + 1));
    if (!(value > 0.0 && value < 1e6))
        throw std::invalid_argument(quoted(text) + " is no positive number; write 0.75 or 3/4");
    return value;
}

bool is_name(std::string_view text)
{
    return !text.empty() && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    });
}

} // namespace fragility
