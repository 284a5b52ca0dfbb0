#pragma once
/// How wide a table of LaTeX will be on paper.

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace scenes {

constexpr double kPagePoints = 455.24; ///< 16 cm: text of an A4 page with margins of 2.5 cm

/// Signs on paper of a text: \% is one, \\ ends a line of \shortstack. @return of its longest
/// line
inline std::size_t latex_signs(const std::string& text)
{
    std::string t = text;
    const std::string stack = "\\shortstack[r]{";
    if (t.starts_with(stack)) t = t.substr(stack.size(), t.size() - stack.size() - 1);
    std::size_t longest = 0, signs = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (t.compare(i, 2, "\\\\") == 0) {
            signs = 0;
            ++i;
        } else if (t[i] == '\\' && i + 1 < t.size() && std::isalpha(t[i + 1]) != 0) {
            while (i + 1 < t.size() && std::isalpha(t[i + 1]) != 0) ++i;
            ++signs;
        } else {
            signs += std::string("\\{}$").find(t[i]) == std::string::npos ? 1 : 0;
        }
        longest = std::max(longest, signs);
    }
    return longest;
}

/// Width of the widest tabular or longtable in `text` [pt], every sign as wide as a digit of 8
/// pt, 8 pt beside each column.
inline double widest_latex(const std::string& text)
{
    double widest = 0.0;
    for (std::size_t at = 0; (at = text.find("\\toprule\n", at)) != std::string::npos;) {
        const std::size_t end = text.find("\\bottomrule", at);
        std::vector<std::size_t> widths;
        for (std::size_t line = at + 9; line < end;) {
            const std::size_t stop = text.find('\n', line);
            std::string row = text.substr(line, stop - line);
            line = stop + 1;
            if (!row.ends_with(" \\\\")) continue;
            row.resize(row.size() - 3);
            for (std::size_t c = 0, from = 0; from <= row.size(); ++c) {
                const std::size_t to = std::min(row.find(" & ", from), row.size());
                if (c >= widths.size()) widths.push_back(0);
                widths[c] = std::max(widths[c], latex_signs(row.substr(from, to - from)));
                from = to + 3;
            }
        }
        double points = 0.0;
        for (const std::size_t w : widths) points += 4.25 * static_cast<double>(w) + 8.0;
        widest = std::max(widest, points);
        at = end;
    }
    return widest;
}

} // namespace scenes
