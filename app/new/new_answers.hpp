#pragma once
/// Answers that a study of one's own wall is written from: by options, or to questions.

#include <iosfwd>
#include <map>
#include <string>

namespace app {

/// By the name of the option: "length" and "3 m".
using Answers = std::map<std::string, std::string>;

/// All answers, each one a value of its key. A question is asked again until its answer is one.
/// @param given by options
/// @param in of a person, who answers what is not given; nullptr: there is none
/// @throws ConfigError about an option whose value cannot be, or that is missing where nobody
/// can be asked
[[nodiscard]] Answers answers(const Answers& given, std::istream* in, std::ostream& out);

/// Length and height of a stone, as text with units.
struct StoneSize {
    std::string length, height;
};

/// @param text "0.6 x 0.3 m", or "0.6 m x 30 cm"
/// @throws BadValue
[[nodiscard]] StoneSize stone_size(const std::string& text);

} // namespace app
