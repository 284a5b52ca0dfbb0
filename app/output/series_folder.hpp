#pragma once
/// The folder of a series for ParaView, written while the wall is pushed.

#include "app/output/made_folder.hpp"
#include "app/output/result_folder.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// Walls go to disk one by one, into a folder beside the one that is named: "series.part". They
/// are moved under their name when the push is over and all of them are there
/// (result_folder.hpp). A run that ends before leaves the series of an earlier run as it was; a
/// kill leaves "series.part", marked as unfinished, which the next run removes.
///
/// Files: wall_0000.vtu ..., joints_0000.vtu ..., then wall.pvd and joints.pvd, which name
/// them. Time is the way of the load line in mm: its displacement in a monotonic push. Of walls
/// at the same time the last is kept.
class SeriesFolder {
  public:
    /// Writes nothing before the first wall.
    explicit SeriesFolder(std::filesystem::path folder);
    /// Removes what was not moved.
    ~SeriesFolder();
    SeriesFolder(const SeriesFolder&) = delete;
    SeriesFolder& operator=(const SeriesFolder&) = delete;

    /// A value that is not finite is told by seal(): the push may yet start anew, or turn out
    /// to have failed.
    /// @throws std::runtime_error if a file cannot be written
    void add(const dem::Snapshot& wall);
    /// The same of a wall that is shaken, whose time is that of its history [s].
    void add_at(double time, const dem::Snapshot& wall);
    /// Removes all that was added, because the push starts anew.
    void begin_anew();
    [[nodiscard]] bool empty() const { return times_.empty(); }

    /// Writes what names the files. No wall is added afterwards.
    /// @return the files, to be moved to where they belong by write_results(): names below the
    /// folder around that of the
    /// series
    /// @throws std::runtime_error if a file cannot be written, std::invalid_argument if a value
    /// was not finite
    [[nodiscard]] std::vector<OutputFile> seal();

  private:
    void open();

    std::filesystem::path folder_, part_;
    std::optional<MadeFolder> parent_; ///< once something is written
    std::vector<double> times_;        ///< [mm], of histories [s]
    double last_ = 0.0, way_ = 0.0;    ///< displacement of the last wall, and way up to it [m]
    std::string trouble_;
};

/// Removes what a killed run has left unfinished of the series in `folder`.
void remove_unfinished_series(const std::filesystem::path& folder);

/// Files with names of a series that are in `folder` already, and in "series.part" unless it is
/// marked as ours.
[[nodiscard]] std::vector<std::filesystem::path>
in_the_way_of_series(const std::filesystem::path& folder);

} // namespace app
