#pragma once
/// Text such as `half_sine(peak 0.5 g, duration 0.3 s)`. Internal to ground/.

#include <string>
#include <string_view>
#include <vector>

namespace ground {

struct CallText {
    struct Argument {
        std::string name;  ///< empty: the value alone
        std::string value; ///< "0.5 g"
    };
    std::string name;
    std::vector<Argument> arguments;
};

/// @throws std::invalid_argument
[[nodiscard]] CallText parse_call(std::string_view text);

enum class Dimension { none, acceleration, velocity, length, time, frequency, angle };

/// A number with its unit, in SI (angles in rad).
/// @throws std::invalid_argument
[[nodiscard]] double quantity(std::string_view text, Dimension dimension);

/// With up to six digits.
[[nodiscard]] std::string plain_text(double x);

} // namespace ground
