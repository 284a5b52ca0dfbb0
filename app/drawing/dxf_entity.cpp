#include "app/drawing/dxf_entity.hpp"

#include "app/drawing/outlines/drawing_file.hpp"
#include "app/text/text_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <system_error>

namespace app {
namespace {

/// Letters of the bytes 0x80 to 0x9f in the code page ANSI_1252; five have none.
constexpr std::array<unsigned, 32> kSpecial1252 = {
    0x20ac, 0x81,   0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8d,   0x017d, 0x8f,   0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0x9d,   0x017e, 0x0178};

/// Adds a letter, by its number in Unicode, as UTF-8.
void add_letter(std::string& text, unsigned letter)
{
    const auto tail = [&](int shift) {
        text += static_cast<char>(0x80 | (letter >> shift & 0x3f));
    };
    if (letter < 0x80) {
        text += static_cast<char>(letter);
    } else if (letter < 0x800) {
        text += static_cast<char>(0xc0 | letter >> 6);
        tail(0);
    } else if (letter < 0x10000) {
        text += static_cast<char>(0xe0 | letter >> 12);
        tail(6);
        tail(0);
    } else {
        text += static_cast<char>(0xf0 | letter >> 18);
        tail(12);
        tail(6);
        tail(0);
    }
}

struct Escape {
    std::size_t length = 0; ///< 0: there is none
    unsigned letter = 0;
};

/// The unit of UTF-16 of `\U+00FC` at the beginning of the text.
Escape unit_at(std::string_view text)
{
    constexpr std::size_t kLength = 7;
    if (text.size() < kLength || !(text.starts_with("\\U+") || text.starts_with("\\u+")))
        return {};
    unsigned unit = 0;
    const char *first = text.data() + 3, *last = text.data() + kLength;
    const auto [end, error] = std::from_chars(first, last, unit, 16);
    return error == std::errc() && end == last ? Escape{kLength, unit} : Escape{};
}

/// The letter of an escape at the beginning of the text; two units may make one letter.
Escape escape_at(std::string_view text)
{
    const Escape one = unit_at(text);
    const bool is_half = one.letter >= 0xd800 && one.letter < 0xe000;
    if (!is_half) return one;
    const Escape two = unit_at(text.substr(one.length));
    const bool is_pair = one.letter < 0xdc00 && two.letter >= 0xdc00 && two.letter < 0xe000;
    if (!is_pair) return {};
    return {one.length + two.length,
            0x10000 + ((one.letter - 0xd800) << 10) + (two.letter - 0xdc00)};
}

} // namespace

DxfEntity read_entity(DxfGroups& groups, const DxfGroup& head)
{
    DxfEntity entity{std::string(head.value), head.line, {}};
    while (const std::optional<DxfGroup> group = groups.next()) {
        if (group->code == 0) {
            groups.step_back();
            break;
        }
        entity.groups.push_back(*group);
    }
    return entity;
}

const DxfGroup* find_group(const DxfEntity& entity, int code)
{
    const DxfGroup* found = nullptr;
    for (const DxfGroup& group : entity.groups)
        if (group.code == code) found = &group;
    return found;
}

double number_of(const DrawingFrame& frame, const DxfEntity& entity, int code, double otherwise)
{
    const DxfGroup* group = find_group(entity, code);
    return group ? dxf_number(frame, *group) : otherwise;
}

int integer_of(const DrawingFrame& frame, const DxfEntity& entity, int code, int otherwise)
{
    const DxfGroup* group = find_group(entity, code);
    return group ? dxf_integer(frame, *group) : otherwise;
}

dem::Point point_of(const DrawingFrame& frame, const DxfEntity& entity, int x, int y)
{
    return checked_point(frame, entity.line, number_of(frame, entity, x, 0.0),
                         number_of(frame, entity, y, 0.0));
}

double extrusion_of(const DrawingFrame& frame, const DxfEntity& entity)
{
    const double nx = number_of(frame, entity, 210, 0.0),
                 ny = number_of(frame, entity, 220, 0.0);
    const double nz = number_of(frame, entity, 230, 1.0);
    if (std::hypot(nx, ny) > 1e-6 * std::abs(nz) || nz == 0.0) {
        refuse(frame, entity.line,
               entity.type + " is not drawn in the x-y plane; turn the wall into that plane");
    }
    return nz < 0 ? -1.0 : 1.0;
}

std::string dxf_name(std::string_view value)
{
    std::string name;
    for (const char c : value) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_special = byte >= 0x80 && byte < 0xa0;
        add_letter(name, is_special ? kSpecial1252[byte - 0x80] : byte);
    }
    if (is_text(value)) name = value; // UTF-8
    std::string plain;
    for (std::string_view rest = name; !rest.empty();) {
        const Escape escape = escape_at(rest);
        if (escape.length == 0)
            plain += rest.front();
        else
            add_letter(plain, escape.letter);
        rest.remove_prefix(std::max<std::size_t>(escape.length, 1));
    }
    return readable_name(plain);
}

std::string upper_case(std::string_view name)
{
    std::string upper(name);
    std::ranges::transform(upper, upper.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return upper;
}

} // namespace app
