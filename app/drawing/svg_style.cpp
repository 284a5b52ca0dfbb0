#include "app/drawing/svg_style.hpp"

#include <algorithm>
#include <cstddef>

namespace app {
namespace {

constexpr std::string_view kStyleBlank = " \t\r\n\f";

std::string_view without_blanks(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kStyleBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kStyleBlank) - first + 1);
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%'; }

std::string lower_case(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower;
}

/// Calls `use` with each part between separators.
template <class Use> void for_parts(std::string_view text, char separator, const Use& use)
{
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        use(without_blanks(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

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

} // namespace

void add_declarations(SvgStyle& style, std::string_view text)
{
    for_parts(text, ';', [&](std::string_view declaration) {
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos) return;
        std::string_view value = declaration.substr(colon + 1);
        value = without_blanks(value.substr(0, value.find('!')));
        style[lower_case(without_blanks(declaration.substr(0, colon)))] = value;
    });
}

void SvgStyleSheet::add(std::string_view text)
{
    const std::string plain = without_comments(text);
    std::string_view rest = plain;
    while (true) {
        const std::size_t open = rest.find('{'), close = rest.find('}');
        if (open == std::string_view::npos || close == std::string_view::npos) return;
        if (open < close)
            for_parts(rest.substr(0, open), ',', [&](std::string_view selector) {
                if (!selector.starts_with('.') ||
                    selector.find_first_of(" \t\r\n.:>+~[#", 1) != std::string_view::npos)
                    return;
                add_declarations(rules_[std::string(selector.substr(1))],
                                 rest.substr(open + 1, close - open - 1));
            });
        rest.remove_prefix(close + 1);
    }
}

void SvgStyleSheet::apply(SvgStyle& style, std::string_view classes) const
{
    for_parts(classes, ' ', [&](std::string_view name) {
        const auto rule = rules_.find(name);
        if (rule == rules_.end()) return;
        for (const auto& [property, value] : rule->second) style[property] = value;
    });
}

std::string plain_transform(std::string_view text)
{
    std::string plain;
    bool in_brackets = false;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '(' || text[i] == ')') in_brackets = text[i] == '(';
        std::size_t end = i;
        while (end < text.size() && is_letter(text[end])) ++end;
        if (!in_brackets || end == i) {
            plain += text[i++];
            continue;
        }
        const std::string_view unit = text.substr(i, end - i);
        if (unit != "px" && unit != "deg" && unit != "e") return "";
        if (unit == "e") plain += unit;
        i = end;
    }
    return plain;
}

} // namespace app
