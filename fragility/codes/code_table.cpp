#include "fragility/codes/code_table.hpp"

#include "fragility/codes/code_rule.hpp"
#include "fragility/codes/code_text.hpp"
#include "fragility/codes/codes_text.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <mutex>
#include <set>
#include <utility>

namespace fragility {
namespace {

constexpr std::array<std::string_view, 4> kModes = {"rocking", "sliding", "mixed", "other"};
constexpr std::string_view kUser = "user"; // the set of fragility.user_states

/// Reasons of displacements refer to these words, and outlive the table.
std::string_view kept(const std::string& words)
{
    static std::set<std::string> all;
    static std::mutex alone;
    const std::lock_guard lock(alone);
    return *all.insert(words).first;
}

std::string listed(std::initializer_list<std::string_view> words)
{
    std::string text;
    for (const std::string_view word : words)
        text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

/// Refuses keys that no table has.
void check_keys(const CodeNode& object, const std::string& name,
                std::initializer_list<std::string_view> known)
{
    for (const CodeNode& member : object.members)
        if (std::ranges::find(known, member.key) == known.end())
            throw CodeTableError(member.line, name,
                                 "\"" + member.key +
                                     "\" is not a key here; known: " + listed(known));
}

const CodeNode* find(const CodeNode& object, std::string_view key)
{
    const auto found = std::ranges::find(object.members, key, &CodeNode::key);
    return found == object.members.end() ? nullptr : &*found;
}

/// The text of a key; empty where it is not written.
std::string text_of(const CodeNode& object, std::string_view key, const std::string& where)
{
    const CodeNode* const value = find(object, key);
    if (value == nullptr) return {};
    if (value->kind == CodeNode::Kind::text && !value->text.empty()) return value->text;
    throw CodeTableError(value->line, where + std::string(key),
                         "is not a text; write it between \" and \"");
}

std::string needed(const CodeNode& object, std::string_view key, const std::string& where,
                   const char* example)
{
    std::string text = text_of(object, key, where);
    if (text.empty())
        throw CodeTableError(object.line, where + std::string(key),
                             std::string("is missing; write ") + example);
    return text;
}

/// The elements of a list of objects.
const std::vector<CodeNode>& list_of(const CodeNode& object, std::string_view key,
                                     const std::string& where, const char* example)
{
    const CodeNode* const value = find(object, key);
    const int line = value == nullptr ? object.line : value->line;
    const bool good =
        value != nullptr && value->kind == CodeNode::Kind::list && !value->elements.empty() &&
        std::ranges::all_of(value->elements,
                            [](const CodeNode& e) { return e.kind == CodeNode::Kind::object; });
    if (!good)
        throw CodeTableError(line, where + std::string(key),
                             std::string("must be a list of objects; write ") + example);
    return value->elements;
}

void read_drifts(const CodeNode& drifts, const std::string& where, CodeState& state)
{
    if (drifts.kind != CodeNode::Kind::object)
        throw CodeTableError(
            drifts.line, where,
            R"(must be an object; write {"rocking": "1 %", "other": "0.5 %"})");
    check_keys(drifts, where, {"times", "rocking", "sliding", "mixed", "other"});
    const auto read_at = [&](const CodeNode& value, const std::string& key, auto read) {
        try {
            return read();
        } catch (const std::invalid_argument& bad) {
            throw CodeTableError(value.line, where + "." + key, bad.what());
        }
    };
    for (const CodeNode& value : drifts.members) {
        const std::string& key = value.key;
        const std::string text = text_of(drifts, key, where + ".");
        if (key == "times")
            state.times = read_at(value, key, [&] { return positive_number(text); });
        else
            state.drifts.emplace_back(key,
                                      read_at(value, key, [&] { return drift_of_text(text); }));
    }
    if (state.drifts.empty())
        throw CodeTableError(drifts.line, where,
                             "names no mode; write \"other\": \"0.5 %\", the drift of all");
}

CodeState read_state(const CodeNode& object, const std::string& code)
{
    CodeState state;
    state.name = needed(object, "name", code + ".", "\"name\": \"SLC\"");
    const std::string where = code + "." + state.name;
    check_keys(object, where,
               {"name", "rule", "drift", "source", "article", "remark", "governs"});
    const std::string rule = text_of(object, "rule", where + ".");
    if (!rule.empty()) {
        try {
            read_rule(rule, state);
        } catch (const std::invalid_argument& bad) {
            throw CodeTableError(find(object, "rule")->line, where + ".rule", bad.what());
        }
    }
    if (const CodeNode* const drift = find(object, "drift"))
        read_drifts(*drift, where + ".drift", state);
    if (rule.empty() && state.drifts.empty())
        throw CodeTableError(object.line, where,
                             "says neither rule nor drift; write \"rule\": \"ultimate\", or "
                             "\"drift\": {\"other\": \"0.5 %\"}");
    state.source = needed(object, "source", where + ".",
                          "where it stands, such as \"source\": \"EN 1998-3:2005\"");
    state.article = text_of(object, "article", where + ".");
    state.remark = text_of(object, "remark", where + ".");
    const std::string governs = text_of(object, "governs", where + ".");
    state.governs =
        kept("governed by " + (governs.empty() ? "the code's drift limit" : governs));
    return state;
}

/// Finds the limit states that others are shares of.
void join_states(Code& code, const std::vector<CodeNode>& objects)
{
    std::size_t curve_ends = 0;
    for (std::size_t i = 0; i < code.states.size(); ++i) {
        CodeState& state = code.states[i];
        const std::string key = code.name + "." + state.name;
        const auto same = [&](const CodeState& s) { return s.name == state.name; };
        if (std::ranges::count_if(code.states, same) > 1)
            throw CodeTableError(objects[i].line, key, "stands twice; keep one of them");
        const bool ends = state.part == CodePart::ultimate && state.factor_text.empty() &&
                          !state.drifts.empty();
        if (ends && ++curve_ends > 1)
            throw CodeTableError(
                objects[i].line, key,
                "is the second limit state of rule ultimate with a drift limit; keep one, and "
                "write the other as a share of it, such as \"rule\": \"3/4 NC\"");
        if (state.part != CodePart::state) continue;
        const auto of = std::ranges::find(code.states, state.of_name, &CodeState::name);
        const int line = find(objects[i], "rule")->line;
        if (of == code.states.end())
            throw CodeTableError(line, key + ".rule",
                                 "\"" + state.of_name +
                                     "\" is no limit state of this code, nor " +
                                     std::string(rule_words()));
        if (of->part == CodePart::state)
            throw CodeTableError(line, key + ".rule",
                                 "is a share of " + state.of_name +
                                     ", which is a share itself; write it as a share of " +
                                     of->of_name);
        state.of = static_cast<int>(of - code.states.begin());
    }
}

Code read_code(const CodeNode& object)
{
    Code code;
    code.name = needed(object, "name", "codes.", "\"name\": \"mine\"");
    check_keys(object, code.name, {"name", "title", "states", "missing"});
    if (!is_name(code.name) || code.name == kUser)
        throw CodeTableError(
            object.line, code.name,
            "is no name of a code; write letters, digits and _ alone, and not \"user\"");
    code.title = needed(object, "title", code.name + ".", "the name of the code and its year");
    code.missing = text_of(object, "missing", code.name + ".");
    if (find(object, "states") == nullptr && !code.missing.empty()) return code;
    const auto& states = list_of(object, "states", code.name + ".",
                                 R"([{"name": "NC", "rule": "ultimate", "source": "..."}])");
    for (const CodeNode& state : states) code.states.push_back(read_state(state, code.name));
    join_states(code, states);
    return code;
}

} // namespace

std::vector<Code> read_code_table(std::string_view text)
{
    const CodeNode root = parse_code_text(text);
    if (root.kind != CodeNode::Kind::object)
        throw CodeTableError(root.line, "", R"(is no table of codes; write {"codes": [...]})");
    check_keys(root, "", {"codes"});
    std::vector<Code> codes;
    for (const CodeNode& object :
         list_of(root, "codes", "", R"({"codes": [{"name": "mine", ...}]})")) {
        codes.push_back(read_code(object));
        if (find_code(codes, codes.back().name) != &codes.back())
            throw CodeTableError(object.line, codes.back().name,
                                 "stands twice; keep one of them");
    }
    return codes;
}

const std::vector<Code>& built_in_codes()
{
    static const std::vector<Code> codes = read_code_table(codes_text());
    return codes;
}

const Code* find_code(const std::vector<Code>& codes, std::string_view name)
{
    const auto found = std::ranges::find(codes, name, &Code::name);
    return found == codes.end() ? nullptr : &*found;
}

} // namespace fragility
