#include "app/store/store_reader.hpp"

#include "app/store/continued_head.hpp"
#include "app/store/hdf5/store_disk.hpp"
#include "app/store/store_parts.hpp"
#include "app/store/wall_file.hpp"

#include <algorithm>
#include <iterator>
#include <string>

namespace app {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void not_there(const fs::path& file)
{
    throw BadStoredStudy(
        "cannot open '" + file.string() + "': no such file" +
        (part_numbers(file).empty()
             ? ""
             : "; restore it; its folder '" + parts_of(file).string() + "' is still there"));
}

void check_study(const WallFile& whole, const WallFile& part)
{
    const std::string why = study_difference(whole.head(), part.head());
    if (!why.empty())
        throw BadStoredStudy(
            "'" + part.path().string() +
            "' is not of the study beside it (-: in this file, +: in the part):\n" + why +
            "Move it away, or restore its file.");
}

/// FILE.h5, then its parts. They are opened before it: what is merged into it meanwhile is then
/// seen in both, and a part that is gone by now is in it.
std::vector<WallFile> open_study(const fs::path& file)
{
    std::vector<WallFile> files;
    for (const std::uint32_t number : part_numbers(file))
        if (auto part = WallFile::open(part_of(file, number)))
            files.push_back(std::move(*part));
    auto whole = WallFile::open(file);
    if (!whole) not_there(file);
    for (const WallFile& part : files) check_study(*whole, part);
    files.insert(files.begin(), std::move(*whole));
    return files;
}

} // namespace

StoreReader::StoreReader(std::vector<WallFile> files) : files_(std::move(files))
{
    for (std::uint32_t f = 0; f < files_.size(); ++f) {
        const std::vector<StoredWall>& walls = files_[f].walls();
        for (std::uint32_t i = 0; i < walls.size(); ++i) places_.push_back({walls[i], f, i});
    }
    const auto key = [](const Place& place) { return place.wall.key; };
    std::ranges::stable_sort(places_, {}, key);
    std::size_t kept = 0;
    for (const Place& place : places_) { // the last of those with one key
        if (kept > 0 && key(places_[kept - 1]) == key(place)) --kept;
        places_[kept++] = place;
    }
    places_.resize(kept);
    statuses_.reserve(kept);
    for (const Place& place : places_) statuses_.push_back({place.wall.key, place.wall.status});
}

StoreReader::StoreReader(const fs::path& file) : StoreReader(open_study(file)) {}

StoreReader::StoreReader(std::vector<StoreReader> several)
    : StoreReader(files_of(std::move(several)))
{
}

std::vector<WallFile> StoreReader::files_of(std::vector<StoreReader> several)
{
    std::vector<WallFile> files;
    for (StoreReader& reader : several)
        std::ranges::move(reader.files_, std::back_inserter(files));
    return files;
}

const StoreHead& StoreReader::head() const { return files_.back().head(); }

WallRow StoreReader::row(std::size_t i)
{
    const Place& place = places_.at(i);
    return files_[place.file].row(place.row);
}

const fs::path& StoreReader::file_of(std::size_t i) const
{
    return files_[places_.at(i).file].path();
}

std::optional<WallRow> StoreReader::row(WallKey key)
{
    const auto found = std::ranges::lower_bound(statuses_, key, {}, &WallStatus::key);
    if (found == statuses_.end() || found->key != key) return {};
    return row(static_cast<std::size_t>(found - statuses_.begin()));
}

void StoreReader::visit_rows(Round round, const std::function<void(const WallRow&)>& visit)
{
    for (std::size_t i = 0; i < places_.size(); ++i)
        if (round_of(head(), statuses_[i].key) == round) visit(row(i));
}

void StoreReader::for_each_row(const std::function<void(const WallRow&)>& visit)
{
    visit_rows(Round::own, visit);
}

void StoreReader::for_each_turned_row(const std::function<void(const WallRow&)>& visit)
{
    visit_rows(Round::turned, visit);
}

void StoreReader::for_each_audit_row(const std::function<void(const WallRow&)>& visit)
{
    visit_rows(Round::audit, visit);
}

RowSource StoreReader::walls()
{
    RowSource all{places_.size(), 0, [this](std::size_t i) { return row(i); }};
    for (const Place& place : places_) all.points += place.wall.points;
    return all;
}

StoreHead read_head(const fs::path& file) { return StoreReader(file).head(); }

std::vector<WallKey> missing_walls(const StoreHead& head, const std::vector<WallStatus>& there)
{
    std::vector<WallKey> missing;
    missing.reserve(walls_wanted(head) - std::min(walls_wanted(head), there.size()));
    auto next = there.begin();
    for (std::uint32_t level = 0; level < head.levels.size(); ++level)
        for (std::uint32_t sample = 0; sample < head.levels[level].samples; ++sample) {
            while (next != there.end() && next->key < WallKey{level, sample}) ++next;
            if (next == there.end() || next->key != WallKey{level, sample})
                missing.push_back({level, sample});
        }
    return missing;
}

} // namespace app
