#pragma once
/// The page of a study whose walls were shaken: films, pictures and tables of its fragility, in
/// one HTML file without script.

#include "app/fragility/numbers/fragility_output.hpp"
#include "app/input/command.hpp"

#include <span>
#include <string>

namespace app {

/// A moving picture with what it shows.
struct ReportFilm {
    std::string caption;
    std::string svg;
};

/// @param note a sentence about the films; empty: none
[[nodiscard]] std::string shaken_page(const std::string& title, const FragilityOutput& output,
                                      std::span<const ReportFilm> films,
                                      const std::string& note);

/// Writes the page. Under each stress the history that went farthest and stood is shaken again
/// for its film, or the first one that fell.
/// @return exit code 0
/// @throws StoreError, ConfigError; std::runtime_error if the page cannot be written
[[nodiscard]] int shaken_report_command(const Command& command);

} // namespace app
