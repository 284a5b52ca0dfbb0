#include "app/output/table/table_parts.hpp"

#include "app/output/picture/markup.hpp"

#include <algorithm>

namespace app {

namespace {

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

} // namespace

std::vector<std::size_t> column_widths(const ShownTable& t)
{
    std::vector<std::size_t> w;
    for (const std::string& h : t.head) w.push_back(shown_width(h));
    for (const auto& row : t.rows)
        for (std::size_t c = 0; c < row.size(); ++c) w[c] = std::max(w[c], shown_width(row[c]));
    return w;
}

std::vector<ShownTable> parts_of(const ShownTable& t, const std::vector<std::size_t>& widths,
                                 std::size_t keys, std::size_t most)
{
    std::size_t start = 0, whole = 0;
    for (std::size_t c = 0; c < widths.size(); ++c)
        (c < keys ? start : whole) += widths[c] + kColumnGap;
    const bool fits = most == 0 || start + whole <= most + kColumnGap;
    if (fits || keys >= t.head.size()) return {t};
    std::vector<ShownTable> parts;
    for (std::size_t first = keys; first < t.head.size();) {
        std::size_t last = first, used = start + widths[first];
        while (++last < t.head.size() && used + kColumnGap + widths[last] <= most)
            used += kColumnGap + widths[last];
        parts.push_back(part_of(t, keys, first, last));
        first = last;
    }
    return parts;
}

} // namespace app
