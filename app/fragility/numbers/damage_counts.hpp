#pragma once
/// A table of counts: at each intensity, how many walls (or analyses, or buildings) there were
/// and how many had reached each limit state.

#include "app/text/csv.hpp"
#include "fragility/modes/ordinal_fit.hpp"

#include <string>
#include <vector>

namespace app {

/// Columns of a table, by name. Either `failed` or `state` is given.
struct CountColumns {
    std::string intensity;
    std::vector<std::string>
        failed;        ///< numbers that reached a limit state, mildest state first
    std::string state; ///< the damage state of a row: 0 for none, 1, 2, ...
    std::string of;    ///< number of all; empty: one for each row, only with `state`
};

struct DamageCounts {
    std::string source;                       ///< name of the file
    std::string intensity;                    ///< head of its column
    std::vector<std::string> states;          ///< names of state 1, 2, ...
    std::vector<fragility::StateCounts> rows; ///< one for each intensity, ascending
};

/// @throws ConfigError naming row and column: no such column; an empty cell, a negative number,
/// text;
/// an intensity of 0; more walls in a state than in total, or than reached a milder state
[[nodiscard]] DamageCounts damage_counts(const Csv& csv, const CountColumns& columns);

} // namespace app
