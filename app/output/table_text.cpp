#include "app/output/table.hpp"

#include "app/output/markup.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>

namespace app {

namespace {

constexpr std::size_t kPageRows = 40; // of a LaTeX table on one page

std::vector<std::size_t> column_widths(const ShownTable& t)
{
    std::vector<std::size_t> w;
    for (const std::string& h : t.head) w.push_back(shown_width(h));
    for (const auto& row : t.rows)
        for (std::size_t c = 0; c < row.size(); ++c) w[c] = std::max(w[c], shown_width(row[c]));
    return w;
}

std::string padded_row(const std::vector<std::string>& cells,
                       const std::vector<std::size_t>& widths, const std::string& left,
                       const std::string& between, const std::string& right)
{
    std::string line = left;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (c > 0) line += between;
        line += std::string(widths[c] - shown_width(cells[c]), ' ') + cells[c];
    }
    return line + right + "\n";
}

template <class Escape>
std::string joined(const std::vector<std::string>& cells, const char* between, Escape escape)
{
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c)
        line += (c > 0 ? between : "") + escape(cells[c]);
    return line;
}

std::string csv_value(const PlainTable::Value& v)
{
    if (const auto* const text = std::get_if<std::string>(&v)) return csv_cell(*text);
    const auto* const x = std::get_if<double>(&v);
    return x ? number(*x, 17) : std::string();
}

/// Columns `first` to `last` of a table, after its keys.
ShownTable part_of(const ShownTable& t, std::size_t keys, std::size_t first, std::size_t last)
{
    const auto cut = [&](const std::vector<std::string>& cells) {
        std::vector<std::string> part(cells.begin(),
                                      cells.begin() + static_cast<std::ptrdiff_t>(keys));
        part.insert(part.end(), cells.begin() + static_cast<std::ptrdiff_t>(first),
                    cells.begin() + static_cast<std::ptrdiff_t>(last));
        return part;
    };
    ShownTable part{cut(t.head), {}, {}};
    for (const auto& row : t.rows) part.rows.push_back(cut(row));
    return part;
}

std::string aligned(const ShownTable& t)
{
    const auto widths = column_widths(t);
    std::string text = padded_row(t.head, widths, "", "  ", "");
    for (const auto& row : t.rows) text += padded_row(row, widths, "", "  ", "");
    return text;
}

std::string blocks(const ShownTable& t, std::size_t keys, std::size_t most)
{
    const auto widths = column_widths(t);
    std::size_t start = 0;
    for (std::size_t c = 0; c < keys; ++c) start += widths[c] + 2;
    std::string text;
    for (std::size_t first = keys; first < t.head.size();) {
        std::size_t last = first, used = start + widths[first];
        while (++last < t.head.size() && used + 2 + widths[last] <= most)
            used += 2 + widths[last];
        text += (text.empty() ? "" : "\n") + aligned(part_of(t, keys, first, last));
        first = last;
    }
    return text;
}

std::string latex_rows(const ShownTable& t, const std::string& after_head)
{
    std::string text =
        "\\toprule\n" + joined(t.head, " & ", latex_text) + " \\\\\n\\midrule\n" + after_head;
    for (const auto& row : t.rows) text += joined(row, " & ", latex_text) + " \\\\\n";
    return text + "\\bottomrule\n";
}

} // namespace

std::string as_text(const Table& table, std::size_t most)
{
    const ShownTable t = shown(table);
    const auto widths = column_widths(t);
    std::size_t whole = 0;
    for (const std::size_t w : widths) whole += w + 2;
    const std::size_t keys = std::min(table.keys, t.head.size());
    const bool parted = most > 0 && whole > most + 2 && keys < t.head.size();
    std::string text = parted ? blocks(t, keys, most) : aligned(t);
    for (const std::string& note : t.notes) text += wrapped(note, most) + "\n";
    return text;
}

std::string as_csv(const Table& table)
{
    const PlainTable t = plain(table);
    std::string text = joined(t.head, ",", csv_cell) + "\n";
    for (const auto& row : t.rows)
        for (std::size_t c = 0; c < row.size(); ++c)
            text += csv_value(row[c]) + (c + 1 < row.size() ? "," : "\n");
    return text;
}

std::string as_markdown(const Table& table)
{
    ShownTable t = shown(table);
    for (std::string& cell : t.head) cell = markdown_text(cell);
    for (auto& row : t.rows)
        for (std::string& cell : row) cell = markdown_text(cell);
    const auto widths = column_widths(t);
    const std::string above = table.title.empty() ? table.caption : table.title;
    std::string text = above.empty() ? "" : markdown_text(above) + "\n\n";
    text += padded_row(t.head, widths, "| ", " | ", " |") + "|";
    for (const std::size_t w : widths) text += std::string(w + 1, '-') + ":|";
    text += "\n";
    for (const auto& row : t.rows) text += padded_row(row, widths, "| ", " | ", " |");
    for (const std::string& note : t.notes) text += "\n" + markdown_text(note) + "\n";
    if (!table.title.empty() && !table.caption.empty())
        text += "\n" + markdown_text(table.caption) + "\n";
    return text;
}

std::string as_latex(const Table& table)
{
    const ShownTable t = shown(table);
    const bool titled = !table.title.empty();
    const std::string columns(t.head.size(), 'r');
    const std::string caption =
        "\\caption{" + latex_text(titled ? table.title : table.caption) + "}";
    std::string notes;
    for (const std::string& note : t.notes) notes += latex_text(note) + "\\par\n";
    if (titled && !table.caption.empty()) notes += latex_text(table.caption) + "\\par\n";
    if (!notes.empty())
        notes = "\\par\\smallskip\n{\\footnotesize\\raggedright\n" + notes + "}\n";
    if (t.rows.size() > kPageRows)
        return "{\\small\n\\begin{longtable}{" + columns + "}\n" + caption + "\\\\\n" +
               latex_rows(t, "\\endhead\n") + "\\end{longtable}\n" + notes + "}\n";
    return "\\begin{table}\n\\centering\n" + caption +
           "\n\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n" +
           "\\begin{tabular}{" + columns + "}\n" + latex_rows(t, "") + "\\end{tabular}}\n" +
           notes + "\\end{table}\n";
}

} // namespace app
