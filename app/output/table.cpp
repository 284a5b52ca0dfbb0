#include "app/output/table.hpp"

#include <algorithm>

namespace app {

namespace {

/// Columns the text takes on a screen: UTF-8 continuation bytes do not count.
std::size_t width(const std::string& text)
{
    return std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
}

std::vector<std::size_t> column_widths(const Table& t)
{
    std::vector<std::size_t> w;
    for (const std::string& h : t.head) w.push_back(width(h));
    for (const auto& row : t.rows)
        for (std::size_t c = 0; c < row.size(); ++c) w[c] = std::max(w[c], width(row[c]));
    return w;
}

std::string padded_row(const std::vector<std::string>& cells,
                       const std::vector<std::size_t>& widths, const std::string& left,
                       const std::string& between, const std::string& right)
{
    std::string line = left;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (c > 0) line += between;
        line += std::string(widths[c] - width(cells[c]), ' ') + cells[c];
    }
    return line + right + "\n";
}

std::string csv_cell(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

/// A character as LaTeX text.
std::string as_latex(char c)
{
    switch (c) {
    case '^':
        return "\\textasciicircum{}";
    case '~':
        return "\\textasciitilde{}";
    case '\\':
        return "\\textbackslash{}";
    case '<':
    case '>':
        return std::string("$") + c + "$"; // text fonts have other signs there
    default:
        break;
    }
    const bool special = std::string_view("&%$#_{}").find(c) != std::string_view::npos;
    return (special ? "\\" : "") + std::string(1, c);
}

std::string latex_cell(const std::string& text)
{
    constexpr std::string_view kDagger = "\u2020"; // classic LaTeX does not know the sign
    std::string escaped;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool dagger = text.compare(i, kDagger.size(), kDagger) == 0;
        escaped += dagger ? "\\dag{}" : as_latex(text[i]);
        if (dagger) i += kDagger.size() - 1;
    }
    return escaped;
}

/// A bar would open a column.
std::string markdown_cell(const std::string& text)
{
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return escaped;
}

Table markdown_cells(Table t)
{
    for (std::string& cell : t.head) cell = markdown_cell(cell);
    for (auto& row : t.rows)
        for (std::string& cell : row) cell = markdown_cell(cell);
    return t;
}

template <class Cell>
std::string joined(const std::vector<std::string>& cells, const char* between, Cell cell)
{
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c)
        line += (c > 0 ? between : "") + cell(cells[c]);
    return line;
}

} // namespace

std::string as_text(const Table& t)
{
    const auto widths = column_widths(t);
    std::string text = padded_row(t.head, widths, "", "  ", "");
    for (const auto& row : t.rows) text += padded_row(row, widths, "", "  ", "");
    return text;
}

std::string as_csv(const Table& t)
{
    std::string text = joined(t.head, ",", csv_cell) + "\n";
    for (const auto& row : t.rows) text += joined(row, ",", csv_cell) + "\n";
    return text;
}

std::string as_markdown(const Table& table)
{
    const Table t = markdown_cells(table);
    const auto widths = column_widths(t);
    std::string text = t.caption.empty() ? "" : t.caption + "\n\n";
    text += padded_row(t.head, widths, "| ", " | ", " |") + "|";
    for (const std::size_t w : widths) text += std::string(w + 1, '-') + ":|";
    text += "\n";
    for (const auto& row : t.rows) text += padded_row(row, widths, "| ", " | ", " |");
    return text;
}

std::string as_latex(const Table& t)
{
    std::string text = "\\begin{table}\n\\centering\n\\caption{" + latex_cell(t.caption) +
                       "}\n\\begin{tabular}{" + std::string(t.head.size(), 'r') +
                       "}\n\\toprule\n";
    text += joined(t.head, " & ", latex_cell) + " \\\\\n\\midrule\n";
    for (const auto& row : t.rows) text += joined(row, " & ", latex_cell) + " \\\\\n";
    return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

} // namespace app
