#pragma once
/// JSON and its text. What reads and writes the text is compiled once for all of app.

#include <nlohmann/json.hpp>

#include <string>

namespace app {

using Json = nlohmann::ordered_json;

/// @throws Json::exception
[[nodiscard]] Json json_of(const std::string& text);

/// Bytes that are no UTF-8 become the sign that stands for them.
/// @param indent spaces for each level; -1: all on one line
[[nodiscard]] std::string text_of(const Json& json, int indent = -1);

} // namespace app
