#pragma once
/// Words in messages: quoted, listed, and the one that was probably meant.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// The text without blanks, tabs and carriage returns at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text with its ASCII letters in lower case.
[[nodiscard]] std::string lower_case(std::string_view text);

/// The parts of the text between occurrences of `by`, trimmed; empty parts are kept.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, std::string_view by);

/// The parts of the text between commas that stand in no brackets, trimmed.
[[nodiscard]] std::vector<std::string> split_outside_brackets(std::string_view text);

/// The text in double quotes, on one line: control characters become '?', a long text is cut.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The text as a shell reads it again: in single quotes where it needs them.
[[nodiscard]] std::string in_shell(const std::string& text);

/// The words in one phrase: "m, cm or mm".
[[nodiscard]] std::string listed(std::span<const std::string_view> words);

/// The number with its noun: "1 block", "2 blocks".
[[nodiscard]] std::string counted(std::size_t n, std::string_view one, std::string_view more);

/// The fewest letters to insert, delete or replace, or neighbours to swap (optimal string
/// alignment).
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The word fewest edits away, if at most a third of its letters differ; otherwise empty.
[[nodiscard]] std::string_view nearest_word(std::string_view wrong,
                                            std::span<const std::string_view> words);

/// `did you mean "push"?`, or `use m, cm or mm` if no word is near.
[[nodiscard]] std::string suggestion(std::string_view wrong,
                                     std::span<const std::string_view> words);

} // namespace app
