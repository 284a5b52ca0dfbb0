#include "app/output/picture/markup.hpp"
#include "app/output/table/table.hpp"
#include "app/output/table/table_parts.hpp"

#include <algorithm>
#include <sstream>

namespace app {

namespace {

constexpr std::size_t kPageRows = 40; // of LaTeX tables on one page, all parts together
/// [characters] on 16 cm, the text of an A4 page, in \footnotesize: a digit of Computer Modern
/// at 8 pt is 4.25 pt wide, and
/// \tabcolsep of 4 pt on both sides of a column is less than kColumnGap.
constexpr std::size_t kLatexWidth = 105;
constexpr std::size_t kHeadLine =
    9; // [characters] of a head are broken to this, or to what stands below

/// The head of a column in lines about as long as its cells.
std::vector<std::string> head_lines(const std::string& head, std::size_t cells)
{
    std::vector<std::string> lines;
    std::istringstream in(wrapped(head, std::max(cells, kHeadLine)));
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<std::size_t> widths_of_cells(const ShownTable& t)
{
    return column_widths({std::vector<std::string>(t.head.size()), t.rows, {}});
}

/// With heads in lines.
std::vector<std::size_t> page_widths(const ShownTable& t)
{
    std::vector<std::size_t> widths = widths_of_cells(t);
    for (std::size_t c = 0; c < widths.size(); ++c)
        for (const std::string& line : head_lines(t.head[c], widths[c]))
            widths[c] = std::max(widths[c], shown_width(line));
    return widths;
}

std::string head_cell(const std::string& head, std::size_t cells)
{
    const std::vector<std::string> lines = head_lines(head, cells);
    if (lines.size() < 2) return latex_text(head);
    std::string text;
    for (const std::string& line : lines)
        text += (text.empty() ? "" : "\\\\") + latex_text(line);
    return "\\shortstack[r]{" + text + "}";
}

std::string row_text(const std::vector<std::string>& cells)
{
    std::string text;
    for (const std::string& cell : cells) text += (&cell == &cells.front() ? "" : " & ") + cell;
    return text + " \\\\\n";
}

std::string rows_text(const ShownTable& t, const std::string& after_head)
{
    const std::vector<std::size_t> widths = widths_of_cells(t);
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < t.head.size(); ++c)
        cells.push_back(head_cell(t.head[c], widths[c]));
    std::string text = "\\toprule\n" + row_text(cells) + "\\midrule\n" + after_head;
    for (const auto& row : t.rows) {
        cells.clear();
        for (const std::string& cell : row) cells.push_back(latex_text(cell));
        text += row_text(cells);
    }
    return text + "\\bottomrule\n";
}

std::string columns(const ShownTable& t)
{
    return "{" + std::string(t.head.size(), 'r') + "}\n";
}

std::string notes_text(const Table& table, const ShownTable& t)
{
    std::string notes;
    for (const std::string& note : t.notes) notes += latex_text(note) + "\\par\n";
    if (!table.title.empty() && !table.caption.empty())
        notes += latex_text(table.caption) + "\\par\n";
    if (notes.empty()) return notes;
    return "\\par\\smallskip\n{\\footnotesize\\raggedright\n" + notes + "}\n";
}

/// On as many pages as it needs.
std::string long_tables(const std::vector<ShownTable>& parts, const std::string& caption)
{
    std::string text;
    for (const ShownTable& part : parts) {
        const bool first = text.empty();
        text += "\\begin{longtable}" + columns(part) + (first ? caption + "\\\\\n" : "") +
                rows_text(part, "\\endhead\n") + "\\end{longtable}\n" +
                (first ? "" : "\\addtocounter{table}{-1}\n");
    }
    return text;
}

/// On one page. A part that one column makes too wide is made smaller.
std::string stacked(const std::vector<ShownTable>& parts)
{
    std::string text;
    for (const ShownTable& part : parts)
        text += std::string(text.empty() ? "" : "\\par\\medskip\n") +
                "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n"
                "\\begin{tabular}" +
                columns(part) + rows_text(part, "") + "\\end{tabular}}\n";
    return text;
}

} // namespace

std::string as_latex(const Table& table)
{
    const ShownTable t = shown(table);
    const std::vector<ShownTable> parts =
        parts_of(t, page_widths(t), std::min(table.keys, t.head.size()), kLatexWidth);
    const std::string caption =
        "\\caption{" + latex_text(table.title.empty() ? table.caption : table.title) + "}";
    const std::string size = "\\footnotesize\\setlength{\\tabcolsep}{4pt}\n";
    if (t.rows.size() * parts.size() > kPageRows)
        return "{" + size + long_tables(parts, caption) + notes_text(table, t) + "}\n";
    return "\\begin{table}\n\\centering\n" + caption + "\n" + size + stacked(parts) +
           notes_text(table, t) + "\\end{table}\n";
}

} // namespace app
