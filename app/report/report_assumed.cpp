#include "app/report/report_parts.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/distribution_text.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <sstream>
#include <string_view>

namespace app {
namespace {

/// Words of a distribution in a study file, and what they mean.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kWords = {
    {{"cov", "coefficient of variation"},
     {"sd", "standard deviation"},
     {"sigma_log", "standard deviation of the logarithm"},
     {"from", "cut off below"},
     {"to", "cut off above"}}};

std::string part_words(std::string_view part)
{
    part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
    for (const auto& [word, meaning] : kWords)
        if (part.starts_with(word) && part.size() > word.size() && part[word.size()] == ' ')
            return std::string(meaning) + std::string(part.substr(word.size()));
    return std::string(part);
}

/// Keys that a stored configuration marks as not given: "wall.bond".
std::set<std::string> defaults_in(const std::string& configuration)
{
    std::set<std::string> keys;
    std::istringstream in(configuration);
    std::string section;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("[")) section = line.substr(1, line.find(']') - 1) + ".";
        if (line.find("# default") == std::string::npos) continue;
        const std::size_t from = line.find_first_not_of("# ");
        keys.insert(section + line.substr(from, line.find_first_of(" =", from) - from));
    }
    return keys;
}

/// "3.3668205267445015, 4.7264822636109765 GPa/m": "3.3668, 4.7265 GPa/m"
std::string five_digits(const std::string& text)
{
    constexpr int kDigits = 5;
    std::string shorter;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool comma = word.ends_with(",");
        if (comma) word.pop_back();
        double x = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
        const bool number_alone = error == std::errc() && end == word.data() + word.size();
        shorter += (shorter.empty() ? "" : " ") + (number_alone ? number(x, kDigits) : word) +
                   (comma ? "," : "");
    }
    return shorter;
}

/// "joint.friction_angle": "joint: friction angle"
std::string quantity(std::string_view key)
{
    std::string text(section_of(key));
    text += ": ";
    text += name_in_section(key);
    std::ranges::replace(text, '_', ' ');
    return text;
}

std::string drawn_words(const StudyWalls& study, std::string_view key)
{
    for (const StoredInput& input : study.inputs)
        if (input.key == key)
            return input.count > 1 ? "drawn for each joint or crack" : "drawn for each wall";
    return "";
}

/// "study file", "default", "drawn for each wall"
std::string origin(std::string_view key, const StudyWalls& study,
                   const std::set<std::string>& defaults)
{
    const std::string drawn = drawn_words(study, key);
    if (!drawn.empty()) return drawn;
    return defaults.count(std::string(key)) > 0 ? "default" : "study file";
}

Table assumed(const StudyWalls& all, std::string_view sections)
{
    const Study& study = all.study;
    const std::set<std::string> defaults = defaults_in(all.head.configuration);
    Table t;
    t.head = {"quantity", "value", "how it was chosen", "meaning"};
    for (const Key& key : study_keys()) {
        const std::string name(key.name);
        const std::string section = " " + std::string(section_of(key.name)) + " ";
        if (sections.find(section) == std::string_view::npos || name == "wall.outlines")
            continue;
        if (!is_used(key, study) || !why_no_effect(key, study).empty()) continue;
        const std::string drawn = drawn_words(all, key.name);
        const Entry* const entry = find_entry(study.source, key.name);
        const std::string value = !drawn.empty() && entry ? distribution_words(entry->value)
                                                          : five_digits(value_text(key, study));
        if (value.empty()) continue;
        t.rows.push_back({quantity(key.name), value, origin(key.name, all, defaults),
                          std::string(key.meaning)});
    }
    return t;
}

} // namespace

std::string distribution_words(const std::string& text)
{
    if (!is_distribution(text)) return text;
    const std::size_t open = text.find('('), close = text.rfind(')');
    std::string words = text.substr(0, open);
    std::istringstream parts(text.substr(open + 1, close - open - 1));
    for (std::string part; std::getline(parts, part, ',');) words += ", " + part_words(part);
    return words;
}

Table material_table(const StudyWalls& study)
{
    Table t = assumed(study, " stone lintel joint unit beam base ");
    t.title = "Materials";
    t.caption =
        "What the study takes the wall to be made of. Values that change nothing in this "
        "study are left out; \"default\" marks those that its file does not give.";
    return t;
}

Table choice_table(const StudyWalls& study)
{
    const std::set<std::string> defaults = defaults_in(study.head.configuration);
    Table t;
    t.title = "Choices that move a drift limit";
    t.caption =
        "What was chosen about the model, and what it does to the drift at which a wall fails.";
    t.head = {"choice", "value", "how it was chosen", "what it does"};
    for (const LimitChoice& choice : limit_choices(study.study))
        t.rows.push_back({quantity(choice.key),
                          five_digits(value_text(*find_key(choice.key), study.study)),
                          origin(choice.key, study, defaults), std::string(choice.effect)});
    return t;
}

Table wall_and_load_table(const StudyWalls& study)
{
    Table t = assumed(study, " wall load ");
    t.title = "Wall and loads";
    t.caption =
        "Geometry, supports and loads; \"default\" marks what the file of the study does "
        "not give.";
    return t;
}

} // namespace app
