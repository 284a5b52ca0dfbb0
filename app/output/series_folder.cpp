#include "app/output/series_folder.hpp"

#include "app/output/atomic_output.hpp"
#include "dem/scene/mechanism/snapshot_vtu.hpp"

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

void remove_all_but_mark(const fs::path& part)
{
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(part, ignored))
        if (entry.path().filename() != kMark) fs::remove_all(entry.path(), ignored);
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
    way_ += std::abs(wall.displacement - last_);
    last_ = wall.displacement;
    add_at(way_ * 1e3, wall);
}

void SeriesFolder::add_at(double time, const dem::Snapshot& wall)
{
    if (!trouble_.empty()) return;
    if (!parent_) open();
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
    if (parent_) remove_all_but_mark(part_);
    times_.clear();
    last_ = way_ = 0.0;
    trouble_.clear();
}

std::vector<OutputFile> SeriesFolder::seal()
{
    if (!trouble_.empty()) throw std::invalid_argument(trouble_);
    if (!parent_) open();
    std::vector<OutputFile> files, indices;
    const auto finished = [&](const std::string& name) {
        return OutputFile{folder_.filename() / name, {}, part_ / name};
    };
    for (const char* stem : kStems) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < times_.size(); ++i) names.push_back(file_name(stem, i));
        write_file(part_ / index_name(stem), dem::pvd_text(times_, names));
        for (const std::string& name : names) files.push_back(finished(name));
        indices.push_back(finished(index_name(stem)));
    }
    files.insert(files.end(), indices.begin(), indices.end());
    return files;
}

void remove_unfinished_series(const fs::path& folder)
{
    const fs::path part = part_of(folder);
    std::error_code ignored;
    if (!fs::exists(part / kMark, ignored)) return;
    remove_all_but_mark(part); // a kill leaves what is still known as ours
    fs::remove(part / kMark, ignored);
    fs::remove(part, ignored);
}

std::vector<fs::path> in_the_way_of_series(const fs::path& folder)
{
    std::vector<fs::path> found;
    std::error_code nothing_there;
    const fs::path part = part_of(folder);
    for (const fs::path& place : {folder, part})
        if (!fs::exists(place / kMark, nothing_there))
            for (const fs::directory_entry& entry :
                 fs::directory_iterator(place, nothing_there))
                if (is_series_name(entry.path().filename().string()))
                    found.push_back(entry.path());
    return found;
}

} // namespace app
