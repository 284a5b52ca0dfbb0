#include "app/input/keys_page.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"

#include <span>
#include <string_view>

namespace app {
namespace {

/// Text that is no mark of a table or of HTML.
std::string cell(std::string_view text)
{
    std::string plain;
    for (const char c : text) {
        if (c == '|' || c == '<' || c == '*') plain += '\\';
        plain += c;
    }
    return plain;
}

std::string_view who_draws(Varies varies)
{
    switch (varies) {
    case Varies::never:
        return "";
    case Varies::by_wall:
        return "wall";
    case Varies::by_joint:
        return "wall, joint";
    case Varies::by_crack:
        return "wall, crack";
    }
    return "";
}

std::string meaning(const Key& key)
{
    std::string text(key.meaning);
    for (const Condition& c : {key.used, key.effect})
        if (c.holds != nullptr && !c.otherwise.empty())
            text += (text.ends_with('.') ? "" : ".") +
                    std::string(c.refused ? " Refused where " : " No effect where ") +
                    std::string(c.otherwise.substr(0, c.otherwise.find(';')));
    return text;
}

std::string row(const Key& key)
{
    return "| `" + std::string(name_in_section(key.name)) + "` | " + cell(default_text(key)) +
           " | " + cell(allowed_values(key)) + " | " + std::string(who_draws(key.varies)) +
           " | " + cell(meaning(key)) + " |\n";
}

std::string tables(std::span<const Key> keys)
{
    std::string text;
    std::string_view section;
    for (const Key& key : keys) {
        if (section_of(key.name) != section) {
            section = section_of(key.name);
            text +=
                "\n### [" + std::string(section) +
                "]\n| key | default | values | drawn by | meaning |\n|---|---|---|---|---|\n";
        }
        text += row(key);
    }
    return text;
}

} // namespace

std::string keys_page()
{
    return "# Keys of study files\n\n"
           "Written by `drystone help keys > docs/keys.md`; a test keeps it current. `drystone "
           "help KEY` tells of one key and names the verbs that\n"
           "read it. *Drawn by*: a distribution may stand for the value, one draw for each "
           "wall, or with `uq.spatial` for each joint or crack.\n\n"
           "## Walls\n" +
           tables(study_keys()) +
           "\n## Another program\nA study with a section [model] has these sections and no "
           "others; its section [variables] names what the program takes\n"
           "([external_program.md](external_program.md)).\n" +
           tables(program_keys());
}

} // namespace app
