#pragma once
/// The table of codes (fragility/codes/codes.json, in the program), and tables of users in the
/// same format.

#include "fragility/codes/code.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fragility {

/// A table that cannot be read. what() says what is wrong and what to write.
struct CodeTableError : std::invalid_argument {
    CodeTableError(int at, std::string which, const std::string& why)
        : std::invalid_argument(why), line(at), key(std::move(which))
    {
    }
    int line;        ///< from 1
    std::string key; ///< "mine.SLC.rule"; empty: of the whole text
};

/// In the order of the file. Codes of which nothing is given here are among them.
[[nodiscard]] const std::vector<Code>& built_in_codes();

/// nullptr: there is none.
[[nodiscard]] const Code* find_code(const std::vector<Code>& codes, std::string_view name);

/// @throws CodeTableError
[[nodiscard]] std::vector<Code> read_code_table(std::string_view text);

} // namespace fragility
