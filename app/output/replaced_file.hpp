#pragma once
/// The verbs that write one file: what they may replace.

#include <filesystem>
#include <string>
#include <string_view>

namespace app {

/// A file of this name that is there must be one that the same verb wrote, as its mark tells;
/// it is replaced. For folders of results: check_results.
/// @param mark that stands in the first 1000 bytes of every file of the verb
/// @return a line for people where a file will be replaced, else nothing
/// @throws ConfigError about --out if the file is another's
[[nodiscard]] std::string check_replaced(const std::filesystem::path& file,
                                         std::string_view mark);

} // namespace app
