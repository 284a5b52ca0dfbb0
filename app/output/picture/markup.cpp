#include "app/output/picture/markup.hpp"

#include <algorithm>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace app {

namespace {

constexpr Replacement kMarkdown[] = {{"\\", "\\\\"}, {"|", "\\|"}, {"<", "\\<"},
                                     {"`", "\\`"},   {"*", "\\*"}, {"](", "]\\("},
                                     {"\r\n", " "},  {"\n", " "},  {"\r", " "}};

constexpr Replacement kLatex[] = {{">=", "$\\geq$"},
                                  {"<=", "$\\leq$"},
                                  {"+-", "$\\pm$"},
                                  {"<", "$<$"}, // text fonts have other signs there
                                  {">", "$>$"},
                                  {"\u2020", "\\dag{}"}, // classic LaTeX does not know the sign
                                  {"^", "\\textasciicircum{}"},
                                  {"~", "\\textasciitilde{}"},
                                  {"\\", "\\textbackslash{}"},
                                  {"&", "\\&"},
                                  {"%", "\\%"},
                                  {"$", "\\$"},
                                  {"#", "\\#"},
                                  {"_", "\\_"},
                                  {"{", "\\{"},
                                  {"}", "\\}"},
                                  {"\r\n", " "},
                                  {"\n", " "},
                                  {"\r", " "}};

} // namespace

std::string replaced(std::string_view text, std::span<const Replacement> table)
{
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto hit = std::ranges::find_if(
            table, [&](const Replacement& r) { return text.starts_with(r.found); });
        const bool found = hit != table.end();
        result += found ? hit->written : text.substr(0, 1);
        text.remove_prefix(found ? hit->found.size() : 1);
    }
    return result;
}

std::string csv_cell(const std::string& text)
{
    const bool runs = text.size() > 1 &&
                      std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
    const std::string shown = (runs ? "'" : "") + text;
    if (shown.find_first_of(",\"\n\r") == std::string::npos) return shown;
    constexpr Replacement kQuote[] = {{"\"", "\"\""}};
    return '"' + replaced(shown, kQuote) + '"';
}

std::string markdown_text(std::string_view text) { return replaced(text, kMarkdown); }

std::string latex_text(std::string_view text)
{
    const bool obeyed = text.starts_with('[') || text.starts_with('*');
    return (obeyed ? "{}" : "") + replaced(text, kLatex);
}

std::string wrapped(const std::string& text, std::size_t width)
{
    std::string lines;
    std::size_t used = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        const std::string word = text.substr(at, end - at);
        const std::size_t size = shown_width(word);
        if (used > 0 && width > 0 && used + 1 + size > width) {
            lines += '\n';
            used = 0;
        } else if (used > 0) {
            lines += ' ';
            ++used;
        }
        lines += word;
        used += size;
        if (end < text.size() && text[end] == '\n') {
            lines += '\n';
            used = 0;
        }
        at = end + 1;
    }
    return lines;
}

namespace {

/// Column at which the words of a line that is too long go on: that of its last column, or a
/// little to the right of its beginning.
std::size_t hang_of(std::string_view line, std::size_t width)
{
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t gap = line.substr(0, width).rfind("  ");
    const bool columns = gap != std::string_view::npos && gap > begin && 2 * gap < width;
    return columns ? gap + 2 : begin + 2;
}

} // namespace

std::string hung(const std::string& text, std::size_t width)
{
    std::string lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line); lines += line + '\n') {
        const std::size_t hang = hang_of(line, width);
        while (shown_width(line) > width) {
            const std::size_t blank = line.rfind(' ', width);
            if (blank == std::string::npos || blank <= hang) break; // one word is longer
            lines += line.substr(0, blank) + '\n';
            line.replace(0, blank + 1, std::string(hang, ' '));
        }
    }
    return lines;
}

std::size_t shown_width(std::string_view text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::size_t terminal_width()
{
    constexpr std::size_t kElsewhere = 100;
    winsize size{};
    const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : kElsewhere;
}

} // namespace app
