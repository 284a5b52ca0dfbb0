#pragma once
/// The verbs that write one file: what they may replace.

#include <filesystem>
#include <string_view>

namespace app {

/// A file of this name that is there must be one that the same verb wrote, as its mark tells; it is replaced, with a note on stderr.
/// For folders of results: check_results.
/// @param mark that stands in the first 1000 bytes of every file of the verb
/// @throws ConfigError about --out if the file is another's
void check_replaced(const std::filesystem::path& file, std::string_view mark, bool quiet);

} // namespace app
