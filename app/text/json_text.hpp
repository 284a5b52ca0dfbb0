#pragma once
/// JSON and its text. What reads and writes the text is compiled once for all of app.

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace app {

using Json = nlohmann::ordered_json;

/// @throws Json::exception
[[nodiscard]] Json json_of(const std::string& text);

/// `x` times `scale`, to kAfterUnits digits; null where it is not known or not finite, for
/// which JSON has no number.
[[nodiscard]] Json or_null(std::optional<double> x, double scale = 1.0);

/// The number of this key; nothing where there is none, or something else.
[[nodiscard]] std::optional<double> number_in(const Json& object, const std::string& key);

/// Bytes that are not UTF-8 become the replacement character.
/// @param indent spaces for each level; -1: all on one line
[[nodiscard]] std::string text_of(const Json& json, int indent = -1);

} // namespace app
