#pragma once
/// A folder that holds the results of one run and never those of two.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct OutputFile {
    std::filesystem::path name; ///< below the folder: "tables/modes.csv"
    std::string content;
    std::filesystem::path from =
        {}; ///< of a file that is finished: it is moved from there, content is empty
};

/// The list of files that a run wrote, with their check sums: how the next run knows what is
/// ours.
constexpr std::string_view kFileList = "drystone_files.txt";

/// Asks before a run what write_results would refuse after it.
/// @return a line for people where results of an earlier run will be replaced, else nothing
/// @throws ConfigError if a file of one of these names is there and not on the list of an
/// earlier run
[[nodiscard]] std::string check_results(const std::filesystem::path& folder,
                                        const std::vector<std::filesystem::path>& names,
                                        std::string_view list = kFileList);

/// Writes all files and the list of them. Files that the list of an earlier run names and this
/// run does not write are removed, unless they have been changed since; other files stay as
/// they are. Files that are moved here come last in `files`, in an order in which none of them
/// names one that is not there yet; those of an earlier run are removed before the first of
/// them.
/// @return how many were removed
/// @throws ConfigError before anything is written: a file that this run would replace is there
/// and is
/// not on the list of an earlier run
/// @throws std::runtime_error as write_file
std::size_t write_results(const std::filesystem::path& folder,
                          const std::vector<OutputFile>& files,
                          std::string_view list = kFileList);

/// Writes files beside those of an earlier run, which stay and remain on the list; the next
/// write_results removes both.
/// @param files none of them is moved here
/// @throws as write_results
void add_results(const std::filesystem::path& folder, const std::vector<OutputFile>& files,
                 std::string_view list = kFileList);

} // namespace app
