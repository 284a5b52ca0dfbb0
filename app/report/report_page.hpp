#pragma once
/// The page: everything in one HTML file.

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace app {

/// By which a page is known as one of ours.
constexpr std::string_view kPageMark = R"(<meta name="generator" content="drystone report">)";

/// Text between tags, and in attributes in double quotes.
[[nodiscard]] std::string html_text(std::string_view text);

/// JSON that may stand inside <script>: no "<", numbers that are not finite become null, bytes
/// that are not UTF-8 the replacement character.
[[nodiscard]] std::string script_json(const nlohmann::ordered_json& data);

/// The same, a third to a tenth as long: base64 of a zlib stream.
[[nodiscard]] std::string packed(const nlohmann::ordered_json& data);

/// @param title any text
/// @param data, films as in report_data.hpp; films are packed already
[[nodiscard]] std::string report_page(const std::string& title,
                                      const nlohmann::ordered_json& data,
                                      const nlohmann::ordered_json& films);

} // namespace app
