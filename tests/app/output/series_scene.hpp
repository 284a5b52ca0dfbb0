#pragma once
/// A whole series for ParaView at once.

#include "app/output/series_folder.hpp"

namespace scenes {

/// With a list of its files in the folder around `folder`. @throws as SeriesFolder and
/// write_results
inline void write_series(const std::filesystem::path& folder,
                         const std::vector<dem::Snapshot>& walls)
{
    app::SeriesFolder series(folder);
    for (const dem::Snapshot& wall : walls) series.add(wall);
    app::write_results(folder.parent_path(), series.seal());
}

} // namespace scenes
