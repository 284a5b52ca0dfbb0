#include "app/drawing/svg_sheet.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace app {
namespace {

std::string without_comments(std::string_view text)
{
    std::string kept;
    while (!text.empty()) {
        const std::size_t begin = std::min(text.find("/*"), text.size());
        kept += text.substr(0, begin);
        text.remove_prefix(begin);
        const std::size_t end = text.find("*/");
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    }
    return kept;
}

/// Without statements that stand before a rule: "@import url(a.css); .old" is ".old".
std::string_view without_statements(std::string_view text)
{
    const std::size_t end = text.rfind(';');
    return end == std::string_view::npos ? text : text.substr(end + 1);
}

/// Nothing for selectors of more than one element, of attributes or of states.
std::optional<SvgSelector> selector_of(std::string_view text)
{
    if (text.empty() || text.find_first_of(" \t\r\n\f:>+~[") != std::string_view::npos)
        return {};
    SvgSelector selector;
    for (char kind = 'e'; !text.empty();) {
        const std::size_t end = std::min(text.find_first_of(".#"), text.size());
        const std::string name(text.substr(0, end));
        if (kind == '.') selector.classes.push_back(name);
        if (kind == '#') selector.id = name;
        if (kind == 'e' && name != "*") selector.element = name;
        kind = end < text.size() ? text[end] : 'e';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return selector;
}

/// True for states that only a pointer on a screen makes.
bool is_of_pointer(std::string_view selector)
{
    constexpr std::array<std::string_view, 3> kStates = {":hover", ":active", ":focus"};
    return std::ranges::any_of(kStates, [&](std::string_view state) {
        return selector.find(state) != std::string_view::npos;
    });
}

bool hides_or_moves(const SvgStyle& style)
{
    constexpr std::array<std::string_view, 7> kProperties = {
        "display", "visibility", "opacity", "transform", "translate", "rotate", "scale"};
    return std::ranges::any_of(kProperties,
                               [&](std::string_view name) { return style.contains(name); });
}

bool selects(const SvgSelector& selector, std::string_view element, std::string_view id,
             const std::vector<std::string_view>& classes)
{
    return (selector.element.empty() || selector.element == element) &&
           (selector.id.empty() || selector.id == id) &&
           std::ranges::all_of(selector.classes, [&](const std::string& wanted) {
               return std::ranges::find(classes, wanted) != classes.end();
           });
}

} // namespace

std::string SvgStyleSheet::add(std::string_view text)
{
    const std::string plain = without_comments(text);
    std::string_view rest = plain;
    std::string unread;
    while (true) {
        const std::size_t open = rest.find('{'), close = rest.find('}');
        if (open == std::string_view::npos || close == std::string_view::npos) break;
        if (open < close) {
            SvgStyle style, important;
            const std::string_view inside = rest.substr(open + 1, close - open - 1);
            add_declarations(style, inside, Importance::usual);
            add_declarations(important, inside, Importance::important);
            for (const std::string_view part :
                 style_parts(without_statements(rest.substr(0, open)), ',')) {
                std::optional<SvgSelector> selector = selector_of(part);
                if (selector) {
                    const std::size_t rank = (selector->id.empty() ? 0 : 10'000) +
                                             10 * selector->classes.size() +
                                             (selector->element.empty() ? 0 : 1);
                    rules_.push_back({std::move(*selector), rank, style, important});
                } else if (unread.empty() &&
                           (hides_or_moves(style) || hides_or_moves(important)) &&
                           !is_of_pointer(part)) {
                    unread = part;
                }
            }
        }
        rest.remove_prefix(close + 1);
    }
    std::ranges::stable_sort(rules_, {}, &SvgRule::rank);
    return unread;
}

void SvgStyleSheet::apply(SvgStyle& style, Importance of, std::string_view element,
                          std::string_view id, std::string_view classes) const
{
    std::string blanks(classes);
    std::ranges::replace_if(
        blanks, [](char c) { return c == '\t' || c == '\n' || c == '\r' || c == '\f'; }, ' ');
    const std::vector<std::string_view> of_element = style_parts(blanks, ' ');
    for (const SvgRule& rule : rules_)
        if (selects(rule.selector, element, id, of_element))
            for (const auto& [property, value] :
                 of == Importance::usual ? rule.style : rule.important)
                style[property] = value;
}

} // namespace app
