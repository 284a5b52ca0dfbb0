#pragma once
/// `drystone report`: one page from a study's file.

#include "app/input/command.hpp"
#include "app/report/film_shelf.hpp"

namespace app {

/// Asks before a run what the page would refuse after it.
/// @throws ConfigError if there is a file of its name that is not a page of ours
void check_report(const Command& command);

/// @param shelf films of walls that need not be pushed again
/// @return exit code 0
/// @throws StoreError; ConfigError; std::runtime_error if the page cannot be written
[[nodiscard]] int report_command(const Command& command, const FilmShelf& shelf = {});

} // namespace app
