#include "app/drawing/svg_style.hpp"

#include "app/text/words.hpp"

#include <algorithm>
#include <cstddef>

namespace app {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%'; }

} // namespace

std::string_view without_blanks(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r\n\f";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> style_parts(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        parts.push_back(without_blanks(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

void add_declarations(SvgStyle& style, std::string_view text, Importance of)
{
    for (const std::string_view declaration : style_parts(text, ';')) {
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos) continue;
        const std::string_view value = declaration.substr(colon + 1);
        const std::size_t mark = std::min(value.find('!'), value.size());
        if ((mark < value.size()) == (of == Importance::important))
            style[lower_case(without_blanks(declaration.substr(0, colon)))] =
                without_blanks(value.substr(0, mark));
    }
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
