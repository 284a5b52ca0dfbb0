#include "bench/tested/measured_walls.hpp"

#include <algorithm>
#include <cstddef>

namespace bench {

std::vector<MeasuredWall> read_series(const std::filesystem::path& folder,
                                      std::string_view series)
{
    std::vector<MeasuredWall> walls;
    if (series.empty()) return walls;
    const std::string start = "FD_SW" + std::string(series);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        const std::size_t n = start.size(); // then one digit, then '_'
        if (!file.starts_with(start) || !file.ends_with(".csv")) continue;
        if (file[n] < '0' || file[n] > '9' || file[n + 1] != '_') continue;
        const CurveTable table =
            read_curve_table(entry.path(), "top_displacement", "horizontal_force");
        walls.push_back({"SW." + std::string(series) + "." + file[n], never_backwards(table)});
    }
    std::ranges::sort(walls, {}, &MeasuredWall::name);
    return walls;
}

} // namespace bench
