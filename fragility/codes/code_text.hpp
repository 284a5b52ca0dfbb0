#pragma once
/// The text of a table of codes: JSON whose parts know their lines.

#include <string>
#include <string_view>
#include <vector>

namespace fragility {

struct CodeNode {
    enum class Kind { text, list, object, other };
    Kind kind = Kind::other;
    int line = 1;    ///< of the key, or where the part begins, from 1
    std::string key; ///< of a member of an object
    std::string text;
    std::vector<CodeNode> elements;
    std::vector<CodeNode> members; ///< of an object, in the order of the text
};

/// @throws CodeTableError where it is no JSON, or a key stands twice in an object
[[nodiscard]] CodeNode parse_code_text(std::string_view text);

} // namespace fragility
