#pragma once
/// The series for ParaView of the walls of one push, written while they are pushed.

#include "app/output/made_folder.hpp"
#include "app/output/series_folder.hpp"
#include "app/store/file_lock.hpp"
#include "dem/solver/push.hpp"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <string_view>
#include <vector>

namespace app {

/// Files of series that a push would replace and that none of our runs wrote, below `out`.
/// @param walls folder of each wall, below `out`
/// @param list of the files that an earlier run wrote (result_folder.hpp)
[[nodiscard]] std::vector<std::filesystem::path>
foreign_series(const std::filesystem::path& out,
               const std::vector<std::filesystem::path>& walls, std::string_view list);

/// Removes the series of the walls that the list of an earlier run names.
void remove_listed_series(const std::filesystem::path& out, std::string_view list);

/// Holds the folder of the push as long as it lives: two runs would write into the same files.
class PushedSeries {
  public:
    /// Removes what a killed run has left unfinished.
    /// @throws StoreError if another run holds `out`
    PushedSeries(const std::filesystem::path& out,
                 const std::vector<std::filesystem::path>& walls);

    /// Takes the snapshots of each wall.
    [[nodiscard]] dem::SnapshotSink sink();

    /// Of a wall whose push is over: all is on disk. A wall without snapshots shows its peak and its end.
    /// @throws as SeriesFolder::seal
    void seal(std::size_t wall, const dem::PushResult& result);
    /// Puts what is sealed in its place.
    void publish();

  private:
    MadeFolder out_;
    FileLock lock_;
    std::deque<SeriesFolder> series_;
};

} // namespace app
