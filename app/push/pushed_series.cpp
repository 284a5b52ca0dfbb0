#include "app/push/pushed_series.hpp"

#include <system_error>

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSeries = "series";

/// Also of walls that this push does not have.
void remove_all_unfinished(const fs::path& out)
{
    std::vector<fs::path> folders = {out};
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(out, ignored))
        if (entry.is_directory(ignored)) folders.push_back(entry.path());
    for (const fs::path& folder : folders) remove_unfinished_series(folder / kSeries);
}

} // namespace

std::vector<fs::path> series_there(const fs::path& out, const std::vector<fs::path>& walls)
{
    std::vector<fs::path> found;
    for (const fs::path& wall : walls)
        for (const fs::path& file : in_the_way_of_series(out / wall / kSeries))
            found.push_back(file.lexically_relative(out));
    return found;
}

PushedSeries::PushedSeries(const fs::path& out, const std::vector<fs::path>& walls)
    : out_(out), lock_(out / "drystone_push.lock")
{
    remove_all_unfinished(out);
    for (const fs::path& wall : walls) series_.emplace_back(out / wall / kSeries);
}

dem::SnapshotSink PushedSeries::sink()
{
    return {
        .take = [this](std::size_t wall, dem::Snapshot&& shot) { series_.at(wall).add(shot); },
        .forget = [this](std::size_t wall) { series_.at(wall).begin_anew(); }};
}

std::vector<OutputFile> PushedSeries::seal(std::size_t wall, const dem::PushResult& r)
{
    SeriesFolder& series = series_.at(wall);
    if (series.empty()) {
        // A wall that comes down under its vertical load has no peak.
        series.add(r.at_peak.blocks.empty() ? r.at_end : r.at_peak);
        series.add(r.at_end);
    }
    return series.seal();
}

} // namespace app
