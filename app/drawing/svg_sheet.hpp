#pragma once
/// The style sheets of an SVG drawing: which elements they hide or move.

#include "app/drawing/svg_style.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// A selector of one element: "rect", "#old", ".st0", "g.old", "*".
struct SvgSelector {
    std::string element, id; ///< empty: any
    std::vector<std::string> classes;
};

struct SvgRule {
    SvgSelector selector;
    std::size_t rank = 0; ///< rules of a higher rank win: ids over classes over elements
    SvgStyle style, important;
};

class SvgStyleSheet {
  public:
    /// Adds the rules of a sheet.
    /// @return the first selector that cannot be read though its rule may hide or move
    /// elements, such as "g > rect"; else empty
    [[nodiscard]] std::string add(std::string_view text);

    /// Adds what the rules for such an element declare with this importance, the strongest
    /// last.
    void apply(SvgStyle& style, Importance of, std::string_view element, std::string_view id,
               std::string_view classes) const;

  private:
    std::vector<SvgRule> rules_; ///< by rank, of one rank in the order of the sheets
};

} // namespace app
