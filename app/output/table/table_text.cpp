#include "app/output/table/table.hpp"

#include "app/output/picture/markup.hpp"
#include "app/output/table/table_parts.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>

namespace app {

namespace {

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

std::string aligned(const ShownTable& t)
{
    const auto widths = column_widths(t);
    std::string text = padded_row(t.head, widths, "", "  ", "");
    for (const auto& row : t.rows) text += padded_row(row, widths, "", "  ", "");
    return text;
}

std::string blocks(const ShownTable& t, std::size_t keys, std::size_t most)
{
    std::string text;
    for (const ShownTable& part : parts_of(t, column_widths(t), keys, most))
        text += (text.empty() ? "" : "\n") + aligned(part);
    return text;
}

} // namespace

Table without_details(const Table& all)
{
    Table t{
        .caption = all.caption, .head = {}, .rows = {}, .title = all.title, .keys = all.keys};
    t.rows.resize(all.rows.size());
    for (std::size_t c = 0; c < all.head.size(); ++c) {
        if (all.head[c].holds & kDetail) continue;
        t.head.push_back(all.head[c]);
        for (std::size_t r = 0; r < all.rows.size(); ++r) t.rows[r].push_back(all.rows[r][c]);
    }
    return t;
}

std::string as_text(const Table& table, std::size_t most)
{
    const ShownTable t = shown(table);
    std::string text = blocks(t, std::min(table.keys, t.head.size()), most);
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

} // namespace app
