#pragma once
/// Style of an SVG element, only the little that matters to outlines: whether it is shown, and
/// its transform.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Declarations of a style: "display:none; fill:#aaa". Names are in lower case, values without
/// "!important".
using SvgStyle = std::map<std::string, std::string, std::less<>>;

/// Important declarations are stronger than usual ones, wherever they stand.
enum class Importance { usual, important };

/// Adds the declarations of one importance. Later ones replace earlier ones.
void add_declarations(SvgStyle& style, std::string_view text, Importance of);

[[nodiscard]] std::string_view without_blanks(std::string_view text);

/// The parts of a text between separators, without the blanks around them.
[[nodiscard]] std::vector<std::string_view> style_parts(std::string_view text, char separator);

/// The numbers of a CSS transform without units: "translate(10px, 0)" as the attribute has it,
/// "translate(10, 0)". Empty if a number has another unit than px or deg.
[[nodiscard]] std::string plain_transform(std::string_view text);

} // namespace app
