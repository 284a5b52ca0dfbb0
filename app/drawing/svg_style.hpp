#pragma once
/// Style of an SVG element, only the little that matters to outlines: whether it is shown, and
/// its transform.

#include <map>
#include <string>
#include <string_view>

namespace app {

/// Declarations of a style: "display:none; fill:#aaa". Names are in lower case, values without
/// "!important".
using SvgStyle = std::map<std::string, std::string, std::less<>>;

/// Later declarations replace earlier ones.
void add_declarations(SvgStyle& style, std::string_view text);

/// The rules of a style sheet whose selectors are single classes (".st0, .st1 {display:
/// none}"), as drawing programs write them; others are passed over.
class SvgStyleSheet {
  public:
    void add(std::string_view text);

    /// Adds what the rules of the classes "st0 st1" declare.
    void apply(SvgStyle& style, std::string_view classes) const;

  private:
    std::map<std::string, SvgStyle, std::less<>> rules_;
};

/// The numbers of a CSS transform without units: "translate(10px, 0)" as the attribute has it,
/// "translate(10, 0)". Empty if a number has another unit than px or deg.
[[nodiscard]] std::string plain_transform(std::string_view text);

} // namespace app
