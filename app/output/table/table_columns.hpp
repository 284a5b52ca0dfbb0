#pragma once
/// Tables written by column: the head of a column and its cell in a row stand in one place.

#include "app/output/table/table.hpp"

#include <functional>
#include <iterator>
#include <vector>

namespace app {

/// @tparam Of what a row is made of
template <class Of> struct TableColumn {
    Head head;
    std::function<Cell(const Of&)> cell; ///< of the column of notes a text
};

template <class Of> using TableColumns = std::vector<TableColumn<Of>>;

/// Adds columns behind others.
template <class Of> void append(TableColumns<Of>& columns, TableColumns<Of> more)
{
    columns.insert(columns.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
}

/// Adds the heads, and one row of each.
template <class Of, class All>
void fill(Table& table, const TableColumns<Of>& columns, const All& all)
{
    for (const TableColumn<Of>& c : columns) table.head.push_back(c.head);
    for (const Of& of : all) {
        Row row;
        for (const TableColumn<Of>& c : columns) row.push_back(c.cell(of));
        table.rows.push_back(std::move(row));
    }
}

} // namespace app
