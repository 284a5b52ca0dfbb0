#include "app/new/new_answers.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/material_presets.hpp"
#include "app/input/study/units.hpp"
#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <iostream>
#include <span>
#include <string_view>
#include <vector>

namespace app {
namespace {

struct Question {
    std::string_view option, text;
    std::string_view usual; ///< the answer of an empty line; empty: there has to be one
    std::string_view example;
    void (*check)(const std::string&); ///< throws BadValue
};

void check_by_key(std::string_view key, const std::string& text)
{
    static_cast<void>(parse_value(*find_key(key), text));
}

void check_material(const std::string& text)
{
    check_by_key("wall.material", text);
    if (text != "none") return;
    const std::span<const std::string_view> names(kMaterialNames);
    throw BadValue("\"none\" is no material; write " + listed(names.subspan(1)));
}

constexpr Question kQuestions[] = {
    {"length", "Length of the wall, along the push", "", "3 m",
     [](const std::string& t) { check_by_key("wall.length", t); }},
    {"height", "Height of the wall", "", "2.7 m",
     [](const std::string& t) { check_by_key("wall.length", t); }},
    {"thickness", "Thickness of the wall", "", "0.5 m",
     [](const std::string& t) { check_by_key("wall.thickness", t); }},
    {"material",
     "Material: rubble_lime, roughly_squared, ashlar_lime, dry_sandstone or dry_granite", "",
     "roughly_squared", check_material},
    {"unit", "A usual stone, length x height", "", "0.4 x 0.2 m",
     [](const std::string& t) { static_cast<void>(stone_size(t)); }},
    {"bond", "Bond: running, stack, english, flemish, header or rubble", "running", "running",
     [](const std::string& t) { check_by_key("wall.bond", t); }},
    {"openings", "Doors and windows as x, z, width, height; ...", "none",
     "0.3 m, 0 m, 0.9 m, 2.1 m", [](const std::string&) {}},
    {"stress", "Vertical stress on top of the wall", "", "0.20 MPa",
     [](const std::string& t) { check_by_key("load.vertical_stress", t); }},
};

/// One line of the person; empty where there is an usual answer to take.
std::string reply(const Question& q, std::istream& in, std::ostream& out)
{
    out << q.text
        << (q.usual.empty() ? ", such as " + std::string(q.example)
                            : " [" + std::string(q.usual) + "]")
        << ": " << std::flush;
    std::string line;
    if (!std::getline(in, line))
        throw ConfigError("drystone", 0, "new", "the questions were not answered to the end");
    return std::string(trimmed(line));
}

std::string asked(const Question& q, std::istream& in, std::ostream& out)
{
    while (true) {
        std::string text = reply(q, in, out);
        if (text.empty()) text = std::string(q.usual);
        try {
            if (text.empty())
                throw BadValue("there is no usual value; write e.g. " + in_quotes(q.example));
            q.check(text);
            return text;
        } catch (const BadValue& bad) {
            out << "  " << bad.what() << '\n';
        }
    }
}

std::string checked(const Question& q, const std::string& text)
{
    try {
        q.check(text);
    } catch (const BadValue& bad) {
        throw ConfigError("drystone", 0, "--" + std::string(q.option), bad.what());
    }
    return text;
}

/// "0.6 m" of "0.6", where the other of two lengths is "0.3 m".
std::string with_unit_of(std::string_view length, std::string_view other)
{
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
    std::string text(length);
    const std::size_t unit = other.find_first_of(kLetters);
    if (length.find_first_of(kLetters) == std::string_view::npos &&
        unit != std::string_view::npos)
        text.append(" ").append(other.substr(unit));
    return text;
}

} // namespace

Answers answers(const Answers& given, std::istream* in, std::ostream& out)
{
    Answers all;
    for (const Question& q : kQuestions) {
        const std::string option(q.option);
        const auto found = given.find(option);
        if (found != given.end())
            all[option] = checked(q, found->second);
        else if (in != nullptr)
            all[option] = asked(q, *in, out);
        else if (q.usual.empty())
            throw ConfigError("drystone", 0, "--" + option,
                              "missing; write e.g. --" + option + " " + in_quotes(q.example));
        else
            all[option] = std::string(q.usual);
    }
    return all;
}

StoneSize stone_size(const std::string& text)
{
    const std::vector<std::string_view> parts = split(text, "x");
    if (parts.size() != 2)
        throw BadValue(in_quotes(text) +
                       " is not a length x height; write e.g. \"0.4 x 0.2 m\"");
    const StoneSize size{with_unit_of(parts[0], parts[1]), with_unit_of(parts[1], parts[0])};
    check_by_key("wall.unit_length", size.length);
    check_by_key("wall.course_height", size.height);
    return size;
}

} // namespace app
