#include "app/input/sheet_offer.hpp"

#include <algorithm>
#include <cctype>

namespace app {
namespace {

/// As a shell reads it again.
std::string in_shell(const std::string& text)
{
    const bool plain = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '/' || c == '.' || c == '_' || c == '-' || c == '+';
    });
    if (plain) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

} // namespace

std::string sheet_offer(const std::filesystem::path& read, const std::string& title)
{
    std::string text = "one page to print: drystone sheet " + in_shell(read.string());
    if (read.extension() != ".h5")
        text += " --out " + in_shell((read.parent_path() / "sheet.html").string());
    if (!title.empty()) text += " --title " + in_shell(title);
    return text;
}

} // namespace app
