#pragma once
/// The series for ParaView of the walls of one push, written while they are pushed.

#include "app/output/made_folder.hpp"
#include "app/output/series_folder.hpp"
#include "app/store/hdf5/file_lock.hpp"
#include "dem/solver/push.hpp"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <vector>

namespace app {

/// Files of series that are there already and that a push could replace, below `out`.
/// @param walls folder of each wall, below `out`
[[nodiscard]] std::vector<std::filesystem::path>
series_there(const std::filesystem::path& out, const std::vector<std::filesystem::path>& walls);

/// Holds the folder of the push as long as it lives: two runs would write into the same files.
class PushedSeries {
  public:
    /// Removes what a killed run has left unfinished.
    /// @throws StoreError if another run holds `out`
    PushedSeries(const std::filesystem::path& out,
                 const std::vector<std::filesystem::path>& walls);

    /// Takes the snapshots of each wall.
    [[nodiscard]] dem::SnapshotSink sink();

    /// Files of a wall whose push is over, with names below its folder. A wall without
    /// snapshots shows its peak and its end.
    /// @throws as SeriesFolder::seal
    [[nodiscard]] std::vector<OutputFile> seal(std::size_t wall, const dem::PushResult& result);

  private:
    MadeFolder out_;
    FileLock lock_;
    std::deque<SeriesFolder> series_;
};

} // namespace app
