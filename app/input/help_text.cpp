#include "app/input/command_line.hpp"
#include "app/input/distribution_text.hpp"
#include "app/input/key_effects.hpp"
#include "app/input/key_values.hpp"
#include "app/input/option.hpp"
#include "app/input/study_keys.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

namespace app {
namespace {

std::string default_text(const Key& key)
{
    if (!key.example.empty()) return "required";
    if (!key.derived.rule.empty()) return std::string(key.derived.rule);
    return value_text(key, Study{});
}

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
        fill_to(line, 46);
        text += line + std::string(verb.meaning) + "\n";
    }
    return text + "\n\"drystone help VERB\" and \"drystone VERB --help\" list the options of a "
                  "verb and the keys that it reads.\n";
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
    return (topic.empty() ? help_of_program(verbs) : help_of(known_verb(verbs, topic))) +
           "\nExit codes: 0 done, 1 failed, 2 error in the input.\n";
}

} // namespace app
