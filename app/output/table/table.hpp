#pragma once
/// A table whose numbers stay numbers until a writer turns them into text. People get rounded
/// values with their doubt in one cell; programs get kAfterUnits digits, of inputs all, one
/// number per column.

#include <cstddef>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace app {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr int kShortest = -1; ///< decimals: as few digits as the value needs, at most 12

/// Sense in which a value states the quantity.
enum class Sense {
    equal,   ///< the quantity itself
    above,   ///< the quantity is larger; shown as "> 2.72"
    at_least ///< the quantity is as large or larger; shown as ">= 2.72"
};

/// A number with what is known of its error. NaN: not known. A number whose value and bounds
/// are all NaN is an empty cell.
struct Number {
    double value = kUnknown;
    double error = kUnknown;    ///< standard error, shown as "16.2 +- 0.3"
    double lower = kUnknown;    ///< interval, shown as "1.58 [1.40, 1.80]"; without a value as
    double upper = kUnknown;    ///< "1.40 to 1.80"; infinite: the data give no bound
    int decimals = kShortest;   ///< for people
    double known_to = kNoEnd;   ///< what lies beyond is extrapolated and gets a dagger
    Sense sense = Sense::equal; ///< of the value, or of the lower bound where there is none
};

/// Nothing (not defined), a text, or a number. A text is never read as a number.
using Cell = std::variant<std::monostate, std::string, Number>;

/// Parts that a column holds beside its value: each gives columns of its own to programs,
/// whatever the rows hold. Bits; of a head "median [%]":
enum : unsigned {
    kError = 1,        ///< "median std error [%]"
    kInterval = 2,     ///< "median lower [%]", "median upper [%]"
    kRange = 4,        ///< the same, and no column for a value
    kExtrapolated = 8, ///< "median extrapolated": 1 or 0
    kCensored =
        16, ///< "median censored": 1 where the value, or the lower end without one, is a lower bound, else 0
    kNote = 32, ///< sentences: a number in brackets for people, the sentence below the table
    kProgramsOnly = 64, ///< not shown to people
    kDetail = 128       ///< left out where a terminal is given the short of a table
};

struct Head {
    std::string name; ///< with unit: "peak [kN]"
    unsigned holds = 0;
    // NOLINTNEXTLINE: a plain name is a column of values
    Head(std::string n, unsigned bits = 0) : name(std::move(n)), holds(bits) {}
    Head(const char* n, unsigned bits = 0) : name(n), holds(bits) {}
};

using Row = std::vector<Cell>;

struct Table {
    std::string caption; ///< what the numbers are and how they were made
    std::vector<Head> head;
    std::vector<Row> rows; ///< as many cells as the head
    std::string title;     ///< one short line; empty: the caption stands above the table
    std::size_t keys = 1; ///< leading columns that name a row, repeated where a table is parted
};

/// Text that people read in a cell: "1.58 [1.40, 1.80]".
[[nodiscard]] std::string cell_text(const Cell& cell);

/// A table as programs get it: unique names, and cells that hold nothing, a text or a finite
/// number.
struct PlainTable {
    using Value = std::variant<std::monostate, std::string, double>;
    std::vector<std::string> head;
    std::vector<std::vector<Value>> rows;
};
[[nodiscard]] PlainTable plain(const Table& table);

/// Aligned columns. A table wider than `width` is parted into blocks of columns, each with the
/// keys.
/// @param width of the terminal in characters; 0: no limit
[[nodiscard]] std::string as_text(const Table& table, std::size_t width = 0);

/// The table without its columns of kDetail.
[[nodiscard]] Table without_details(const Table& all);
[[nodiscard]] std::string
as_csv(const Table& table); ///< RFC 4180, numbers as programs get them
[[nodiscard]] std::string as_markdown(const Table& table);
/// A table environment with booktabs rules, in \footnotesize; a table wider than an A4 page (16
/// cm of text) is parted into blocks of columns, each with the keys. Long tables are a
/// longtable. Packages booktabs, graphicx, longtable.
[[nodiscard]] std::string as_latex(const Table& table);

/// A table as people see it: texts of the cells in their columns, and the sentences below.
struct ShownTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> notes; ///< "[1] all walls stood"
};
[[nodiscard]] ShownTable shown(const Table& table);

} // namespace app
