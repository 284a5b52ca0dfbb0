#include "app/input/study/code_file.hpp"

#include "app/input/study/study.hpp"
#include "app/text/text_file.hpp"
#include "fragility/codes/code_table.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string_view>

namespace app {
namespace {

bool is_written_out(std::string_view value) { return value.starts_with('{'); }

std::string text_of_file(const StudyFile& source, const std::string& name)
{
    const std::filesystem::path path = path_from(source, "fragility.codes", name);
    constexpr std::size_t kMost = 1 << 20; // bytes
    return read_bytes(path.string(), kMost, "is larger than 1 MiB, and no table of codes",
                      "fragility.codes names a file like fragility/codes/codes.json");
}

/// On one line, and without the sign that begins a comment.
std::string on_one_line(const std::string& text)
{
    std::string line;
    for (const char c : nlohmann::ordered_json::parse(text).dump(-1, ' ', true))
        line += c == '#' ? std::string("\\u0023") : std::string(1, c);
    return line;
}

std::string drift_cell(const fragility::CodeState& s)
{
    return s.drifts.empty() ? "none" : fragility::drift_text(s, 0.0);
}

std::string read_at_text(const fragility::CodeState& s)
{
    using fragility::CodePart;
    const std::string share = s.factor_text.empty() ? "" : s.factor_text + " of ";
    switch (s.part) {
    case CodePart::yield:
        return share + "the yield";
    case CodePart::yield_or_peak:
        return share + "the yield, or the peak if it comes first";
    case CodePart::peak:
        return share + "the peak";
    case CodePart::ultimate:
        return share + "the fall to `ultimate_share` of the peak";
    case CodePart::collapse:
        return share + "no force left";
    case CodePart::rise:
        return "rise to " + fragility::percent(s.factor) + " of the peak";
    case CodePart::drop:
        return "drop to " + fragility::percent(s.factor) + " of the peak";
    case CodePart::state:
        return share + s.of_name;
    default:
        return "its drift limit alone";
    }
}

std::string code_section(const fragility::Code& code)
{
    std::string page = "\n## " + code.name + "\n" + code.title + ".\n";
    if (code.states.empty()) return page + "\nNot given here: " + code.missing + ".\n";
    page += "\n| limit state | read at | drift limit | source |\n|---|---|---|---|\n";
    for (const fragility::CodeState& s : code.states)
        page += "| " + s.name + " | " + read_at_text(s) + " | " + drift_cell(s) + " | " +
                source_text(s) + " |\n";
    if (!code.missing.empty()) page += "\nMissing: " + code.missing + ".\n";
    return page;
}

constexpr std::string_view kHead =
    "# Codes\n\n"
    "Written by `drystone help codes > docs/codes.md`; a test keeps it current. "
    "The table is [fragility/codes/codes.json](../fragility/codes/codes.json).\n"
    "`fragility.limit_states = paper, ntc, ec8` names the codes by which a study is read. "
    "A drift limit counts if the wall reaches it before the rule of its limit\n"
    "state. Walls with openings are read pier by pier, each by its own mode, height and H0/D; "
    "the pier that reaches its limit first governs.\n"
    "H0/D: distance from the section of largest moment to the point without moment, over the "
    "length of the wall. No code is quoted: compare with your copy.\n\n"
    "## A table of your own\n"
    "`fragility.codes = mine.json` adds codes, or replaces those of the same name; "
    "`fragility.limit_states = mine` asks for them.\n"
    "The path starts at the folder of the study. Results carry the text of the file.\n"
    "```json\n"
    "{\"codes\": [{\n"
    "  \"name\": \"mine\", \"title\": \"Guideline of the city, 2030\",\n"
    "  \"states\": [\n"
    "    {\"name\": \"LS\", \"rule\": \"3/4 CP\", \"source\": \"guideline\"},\n"
    "    {\"name\": \"CP\", \"rule\": \"ultimate\", \"source\": \"guideline\", \"article\": "
    "\"5.2\",\n"
    "     \"drift\": {\"times\": \"4/3\", \"rocking\": \"0.6 % H0/D\", \"other\": \"0.3 %\"}}\n"
    "  ]\n"
    "}]}\n"
    "```\n"
    "| key | meaning |\n|---|---|\n"
    "| rule | yield, yield or peak, peak, ultimate, collapse, a share of one of them or of "
    "another limit state such as 3/4 CP, rise 0.33 or drop 0.5 |\n"
    "| drift | drift limit by mode: rocking, sliding, mixed, other; `H0/D` after a drift "
    "multiplies it, `times` multiplies all drifts. Without a rule the drift limit stands alone "
    "|\n"
    "| source | document of the limit; must be written |\n"
    "| article, remark | the same in more detail |\n"
    "| governs | the note of a displacement that is the drift limit: \"governed by ...\" |\n"
    "| missing | parts of the code that are left out |\n";

} // namespace

void read_own_codes(Study& study)
{
    std::string& codes = study.fragility.codes;
    if (codes.empty()) return;
    const bool inside = is_written_out(codes);
    const std::string text = inside ? codes : text_of_file(study.source, codes);
    try {
        study.fragility.own_codes = fragility::read_code_table(text);
    } catch (const fragility::CodeTableError& bad) {
        if (inside)
            throw error_at(study.source, "fragility.codes",
                           bad.key + (bad.key.empty() ? "" : ": ") + bad.what());
        throw ConfigError(path_from(study.source, "fragility.codes", codes).string(), bad.line,
                          bad.key, bad.what());
    }
    codes = on_one_line(text);
}

std::string codes_page()
{
    std::string page(kHead);
    for (const fragility::Code& code : fragility::built_in_codes()) page += code_section(code);
    return page;
}

} // namespace app
