#include "app/output/series_folder.hpp"

#include "app/output/atomic_output.hpp"
#include "dem/scene/snapshot_vtu.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 2> kStems = {"wall", "joints"};
constexpr std::string_view kMark = "drystone_unfinished.txt";
constexpr std::string_view kMarkText =
    "A series for ParaView that drystone is writing, or that a run left when it was killed.\n"
    "The next run into the folder above removes it.\n";

fs::path part_of(const fs::path& folder)
{
    fs::path part = folder;
    return part += ".part";
}

std::string file_name(const std::string& stem, std::size_t index)
{
    const std::string digits = std::to_string(index);
    return stem + '_' + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits +
           ".vtu";
}

std::string index_name(const std::string& stem) { return stem + ".pvd"; }

/// "wall.pvd", "joints_0012.vtu".
bool is_series_name(const std::string& name)
{
    return std::ranges::any_of(kStems, [&](const std::string stem) {
        if (name == index_name(stem)) return true;
        if (!name.starts_with(stem + '_') || !name.ends_with(".vtu")) return false;
        const std::string digits =
            name.substr(stem.size() + 1, name.size() - stem.size() - 1 - 4);
        return digits.size() >= 4 &&
               digits.find_first_not_of("0123456789") == std::string::npos;
    });
}

/// What names the others goes first, then the last file: a kill leaves a series that can be removed again.
void remove_files(const fs::path& folder)
{
    std::error_code nothing_there;
    for (const char* stem : kStems) fs::remove(folder / index_name(stem), nothing_there);
    for (const char* stem : kStems) {
        std::size_t n = 0;
        while (fs::exists(folder / file_name(stem, n), nothing_there)) ++n;
        while (n > 0) fs::remove(folder / file_name(stem, --n), nothing_there);
    }
}

void move_file(const fs::path& from, const fs::path& to, const std::string& name)
{
    std::error_code error;
    fs::rename(from / name, to / name, error);
    if (error)
        throw std::runtime_error("cannot write '" + (to / name).string() +
                                 "': " + error.message());
}

std::optional<fs::path> first_series_file(const fs::path& folder)
{
    std::error_code nothing_there;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, nothing_there))
        if (is_series_name(entry.path().filename().string())) return entry.path();
    return {};
}

/// What a kill leaves of a file that was being written: ".NAME.PROCESS-NUMBER.tmp" (atomic_output.hpp).
void remove_temporaries(const fs::path& folder)
{
    std::error_code ignored;
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const fs::path name = entry.path().filename();
        if (name.extension() != ".tmp" || !name.string().starts_with('.')) continue;
        const std::string whole = name.stem().stem().string().substr(1);
        if (whole == kMark || is_series_name(whole)) found.push_back(entry.path());
    }
    for (const fs::path& path : found) fs::remove(path, ignored);
}

} // namespace

SeriesFolder::SeriesFolder(fs::path folder)
    : folder_(std::move(folder)), part_(part_of(folder_))
{
}

SeriesFolder::~SeriesFolder()
{
    if (parent_) remove_unfinished_series(folder_);
}

void SeriesFolder::open()
{
    remove_unfinished_series(folder_);
    parent_.emplace(fs::absolute(folder_).parent_path());
    make_folder(part_);
    write_file(part_ / kMark, kMarkText);
}

void SeriesFolder::add(const dem::Snapshot& wall)
{
    if (!trouble_.empty()) return;
    if (!parent_) open();
    way_ += std::abs(wall.displacement - last_);
    last_ = wall.displacement;
    const double time = way_ * 1e3;
    if (times_.empty() || times_.back() != time) // two at one time would overlap
        times_.push_back(time);
    try {
        write_file(part_ / file_name("wall", times_.size() - 1), dem::blocks_vtu(wall));
        write_file(part_ / file_name("joints", times_.size() - 1), dem::joints_vtu(wall));
    } catch (const std::invalid_argument& not_finite) {
        trouble_ = not_finite.what();
    }
}

void SeriesFolder::begin_anew()
{
    if (parent_) remove_files(part_);
    times_.clear();
    last_ = way_ = 0.0;
    trouble_.clear();
}

void SeriesFolder::seal()
{
    if (!trouble_.empty()) throw std::invalid_argument(trouble_);
    if (!parent_) open();
    for (const char* stem : kStems) {
        std::vector<std::string> files;
        for (std::size_t i = 0; i < times_.size(); ++i) files.push_back(file_name(stem, i));
        write_file(part_ / index_name(stem), dem::pvd_text(times_, files));
    }
    sealed_ = true;
}

void SeriesFolder::publish()
{
    if (!sealed_) return;
    remove_vtk_series(folder_);
    make_folder(folder_);
    for (const char* stem : kStems)
        for (std::size_t i = 0; i < times_.size(); ++i)
            move_file(part_, folder_, file_name(stem, i));
    // last, so that they never name a file that is not there
    for (const char* stem : kStems) move_file(part_, folder_, index_name(stem));
    sealed_ = false;
}

void write_vtk_series(const fs::path& folder, const std::vector<dem::Snapshot>& walls)
{
    SeriesFolder series(folder);
    for (const dem::Snapshot& wall : walls) series.add(wall);
    series.seal();
    series.publish();
}

void remove_vtk_series(const fs::path& folder)
{
    remove_files(folder);
    std::error_code not_empty;
    fs::remove(folder, not_empty); // stays if others have put something there
}

void remove_unfinished_series(const fs::path& folder)
{
    const fs::path part = part_of(folder);
    std::error_code ignored;
    if (!fs::exists(part / kMark, ignored)) return;
    remove_files(part);
    remove_temporaries(part);
    fs::remove(part / kMark, ignored);
    fs::remove(part, ignored);
}

std::optional<fs::path> in_the_way_of_series(const fs::path& folder, bool ours)
{
    const fs::path part = part_of(folder);
    std::error_code ignored;
    std::optional<fs::path> found;
    if (!ours) found = first_series_file(folder);
    if (!found && !fs::exists(part / kMark, ignored)) found = first_series_file(part);
    return found;
}

} // namespace app
