#include "app/input/command_line.hpp"
#include "app/input/key_effects.hpp"
#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/option.hpp"
#include "app/input/study/distribution_text.hpp"
#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

namespace app {
namespace {

/// At least one blank before the next column.
void fill_to(std::string& line, std::size_t column)
{
    line.resize(std::max(line.size() + 1, column), ' ');
}

/// Keys of a study, section by section: name, default, values allowed, meaning.
std::string keys_text(const std::vector<Key>& keys)
{
    std::string text;
    std::string_view section;
    for (const Key& key : keys) {
        if (section_of(key.name) != section) {
            section = section_of(key.name);
            text += "\n[" + std::string(section) + "]\n";
        }
        std::string line = "  " + std::string(name_in_section(key.name));
        fill_to(line, 28);
        line += default_text(key);
        fill_to(line, 52);
        text += line + allowed_values(key) + "\n      " + std::string(key.meaning) + "\n";
    }
    return text;
}

std::vector<Key> keys_of(const Verb& verb)
{
    std::vector<Key> keys;
    for (const Key& key : study_keys())
        if (reads(verb, key)) keys.push_back(key);
    return keys;
}

std::string usage_line(const Verb& verb)
{
    const std::string words = verb.words.empty() ? "" : " " + std::string(verb.words);
    return "  drystone " + std::string(verb.name) + words +
           (verb.out == OutKind::none ? "" : " [options]");
}

std::string help_of_program(std::span<const Verb> verbs)
{
    std::string text =
        "Drystone: in-plane push of dry-joint stone masonry walls by the discrete "
        "element method.\n\n";
    for (const Verb& verb : verbs) {
        std::string line = usage_line(verb);
        fill_to(line, 48);
        text += line + std::string(verb.meaning) + "\n";
    }
    return text +
           "\n\"drystone help VERB\" and \"drystone VERB --help\" list the options of a "
           "verb and the keys that it reads, \"drystone help KEY\" tells of one key, and "
           "\"drystone help WORD\" finds what speaks of a word.\n";
}

std::vector<Key> all_keys()
{
    std::vector<Key> keys(study_keys().begin(), study_keys().end());
    for (const Key& key : program_keys())
        if (find_key(key.name) == nullptr) keys.push_back(key);
    return keys;
}

/// One key, or those of this name in several sections.
std::vector<Key> keys_named(std::string_view topic)
{
    std::vector<Key> keys = all_keys();
    std::erase_if(keys, [&](const Key& key) {
        return key.name != topic && name_in_section(key.name) != topic;
    });
    return keys;
}

std::string_view who_varies(Varies varies)
{
    switch (varies) {
    case Varies::never:
        return "";
    case Varies::by_wall:
        return ", or a distribution: one value for each wall";
    default:
        return ", or a distribution: one value for each wall, or with uq.spatial one for each "
               "joint or crack";
    }
}

std::string help_of(std::span<const Verb> verbs, const Key& key)
{
    std::string readers;
    for (const Verb& verb : verbs)
        if (reads(verb, key)) readers += (readers.empty() ? "" : ", ") + std::string(verb.name);
    std::string text = std::string(key.name) + "\n      " + std::string(key.meaning) + "\n" +
                       "  default   " + default_text(key) + "\n" + "  values    " +
                       allowed_values(key) + std::string(who_varies(key.varies)) + "\n";
    if (!readers.empty()) text += "  read by   " + readers + "\n";
    for (const Condition& c : {key.used, key.effect})
        if (c.holds != nullptr) text += "  no effect where " + std::string(c.otherwise) + "\n";
    return text;
}

std::string help_of(std::span<const Verb> verbs, const Option& option)
{
    std::string takers;
    for (const Verb& verb : verbs)
        if (takes(verb, option))
            takers += (takers.empty() ? "" : ", ") + std::string(verb.name);
    return "--" + option.name + (option.value_name.empty() ? "" : " " + option.value_name) +
           "\n      " + option.meaning + "\n  taken by  " + takers + "\n";
}

bool speaks_of(std::string_view text, std::string_view word)
{
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

/// Every verb, key and option whose name or meaning has this word.
std::string found(std::span<const Verb> verbs, std::string_view word)
{
    std::string text;
    const auto add = [&](const std::string& name, std::string_view meaning) {
        if (!speaks_of(name, word) && !speaks_of(meaning, word)) return;
        std::string line = "  " + name;
        fill_to(line, 34);
        text += line + std::string(meaning) + "\n";
    };
    for (const Verb& verb : verbs) add(std::string(verb.name), verb.meaning);
    for (const Option& option : options()) add("--" + option.name, option.meaning);
    for (const Key& key : all_keys()) add(std::string(key.name), key.meaning);
    return text;
}

[[noreturn]] void refuse_topic(std::span<const Verb> verbs, std::string_view topic)
{
    std::vector<std::string> hyphened;
    for (const Option& option : options()) hyphened.push_back("--" + option.name);
    std::vector<std::string_view> names(hyphened.begin(), hyphened.end());
    for (const Verb& verb : verbs) names.push_back(verb.name);
    for (const Key& key : study_keys()) {
        names.push_back(key.name);
        names.push_back(name_in_section(key.name));
    }
    const std::string_view nearest = nearest_word(topic, names);
    throw ConfigError("drystone", 0, topic,
                      "no verb, key or option has this word; " +
                          (nearest.empty() ? "\"drystone help\" lists the verbs"
                                           : "did you mean " + in_quotes(nearest) + "?"));
}

std::string help_of(const Verb& verb)
{
    std::ostringstream text;
    text << usage_line(verb) << "\n      " << verb.meaning << "\n\n" << described(&verb);
    if (!verb.sections.empty())
        text << "\nKeys of the study file that " << verb.name
             << " reads: name, default, values allowed, meaning.\n"
             << keys_text(keys_of(verb));
    if (is_listed("model", verb.sections))
        text << "\nA study of another program has these sections, and no others:\n"
             << keys_text({program_keys().begin(), program_keys().end()})
             << "\n[variables]\n  NAME                      required                number or "
                "distribution\n      a value that the program takes, in its unit and "
                "written without one\n";
    if (is_listed("joint", verb.sections)) text << '\n' << distribution_help();
    return text.str();
}

} // namespace

std::string help_text(std::span<const Verb> verbs, std::string_view topic)
{
    constexpr std::string_view kCodes =
        "\nExit codes: 0 done, 1 failed, 2 error in the input, 130 told to end.\n";
    if (topic.empty()) return help_of_program(verbs) + std::string(kCodes);
    if (const Verb* verb = find_verb(verbs, topic)) return help_of(*verb) + std::string(kCodes);
    if (const Option* option = topic.starts_with("--") ? find_option(topic.substr(2)) : nullptr)
        return help_of(verbs, *option);
    std::string text;
    for (const Key& key : keys_named(topic)) text += help_of(verbs, key);
    if (text.empty()) text = found(verbs, topic);
    if (topic.starts_with("distribution") ||
        speaks_of(distribution_help(), std::string(topic) + "("))
        text += (text.empty() ? "" : "\n") + distribution_help();
    if (text.empty()) refuse_topic(verbs, topic);
    return text;
}

} // namespace app
