#pragma once
/// One A4 page of a wall as HTML: what a client is given.

#include "app/sheet/sheet_words.hpp"

#include <string>
#include <vector>

namespace app {

/// A limit state in the table of the sheet, as text.
struct SheetLimit {
    std::string state, displacement, drift;
    std::string rule;   ///< that governs it
    std::string spread; ///< of random walls; empty: none
};

struct Sheet {
    std::string title, subtitle;
    std::vector<std::string> answer;       ///< sentences
    std::string moves = "top";             ///< whose movement the displacements are
    std::string drift_words;               ///< a sentence that defines the drift
    std::string drawing, curve, mechanism; ///< SVG
    std::vector<SheetLimit> limits;
    std::string
        spread_head; ///< of SheetLimit::spread: "drift [%] of 16, 50, 84 % of 48 random walls"; empty: no such column
    std::vector<std::string> piers; ///< a paragraph for each direction; may be empty
    std::vector<Assumption> assumed;
    std::vector<std::string> certainty; ///< sentences
    std::string footer;
};

constexpr std::string_view kSheetMark = "<meta name=\"generator\" content=\"drystone sheet\">";
constexpr std::size_t kMostSheetLimits = 9; ///< rows; more are counted in a last row

/// HTML that prints on one page of A4, whatever the sheet holds.
[[nodiscard]] std::string sheet_page(const Sheet& sheet);

} // namespace app
