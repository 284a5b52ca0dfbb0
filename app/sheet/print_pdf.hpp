#pragma once
/// A page of HTML as PDF, by a program that may be installed.

#include <filesystem>
#include <string>

namespace app {

/// Prints an HTML file by WeasyPrint, found on PATH.
/// @return a sentence for people: where the PDF is, or what to install, or why there is none
[[nodiscard]] std::string print_pdf(const std::filesystem::path& html,
                                    const std::filesystem::path& pdf);

} // namespace app
