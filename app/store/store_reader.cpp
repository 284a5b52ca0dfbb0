#include "app/store/store_reader.hpp"

#include "app/store/store_disk.hpp"
#include "app/store/store_parts.hpp"
#include "app/store/wall_file.hpp"

#include <algorithm>
#include <iterator>
#include <string>

namespace app {

namespace {

namespace fs = std::filesystem;

/// Where a wall is.
struct Place {
    StoredWall wall;
    std::uint32_t file = 0, row = 0;
};

[[noreturn]] void not_there(const fs::path& file)
{
    throw StoreError("cannot open '" + file.string() + "': no such file" +
                     (part_numbers(file).empty()
                          ? ""
                          : "; bring it back, '" + parts_of(file).string() + "' is there"));
}

void check_study(const WallFile& whole, const WallFile& part)
{
    const std::string why = text_difference(study_text(whole.head()), study_text(part.head()));
    if (!why.empty())
        throw StoreError("'" + part.path().string() +
                         "' is not of the study beside it (- there, + here):\n" + why +
                         "Move it away, or bring its file back.");
}

/// FILE.h5, then its parts. They are opened before it: what is merged into it meanwhile is then seen in
/// both, and a part that is gone by now is in it.
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

struct StoreReader::Impl {
    std::vector<WallFile> files;
    std::vector<Place> places;
    std::vector<WallStatus> statuses;

    explicit Impl(std::vector<WallFile> from) : files(std::move(from))
    {
        for (std::uint32_t f = 0; f < files.size(); ++f) {
            const std::vector<StoredWall>& walls = files[f].walls();
            for (std::uint32_t i = 0; i < walls.size(); ++i) places.push_back({walls[i], f, i});
        }
        const auto key = [](const Place& place) { return place.wall.key; };
        std::ranges::stable_sort(places, {}, key);
        std::size_t kept = 0;
        for (const Place& place : places) { // the last of those with one key
            if (kept > 0 && key(places[kept - 1]) == key(place)) --kept;
            places[kept++] = place;
        }
        places.resize(kept);
        statuses.reserve(kept);
        for (const Place& place : places)
            statuses.push_back({place.wall.key, place.wall.status});
    }
};

StoreReader::StoreReader(const fs::path& file) : impl_(std::make_unique<Impl>(open_study(file)))
{
}

StoreReader::StoreReader(std::vector<StoreReader> several)
{
    std::vector<WallFile> files;
    for (StoreReader& reader : several)
        std::ranges::move(reader.impl_->files, std::back_inserter(files));
    impl_ = std::make_unique<Impl>(std::move(files));
}

StoreReader::~StoreReader() = default;
StoreReader::StoreReader(StoreReader&&) noexcept = default;
StoreReader& StoreReader::operator=(StoreReader&&) noexcept = default;

const StoreHead& StoreReader::head() const { return impl_->files.back().head(); }
const std::vector<WallStatus>& StoreReader::statuses() const { return impl_->statuses; }

WallRow StoreReader::row(std::size_t i)
{
    const Place& place = impl_->places.at(i);
    return impl_->files[place.file].row(place.row);
}

std::optional<WallRow> StoreReader::row(WallKey key)
{
    const auto found = std::ranges::lower_bound(impl_->statuses, key, {}, &WallStatus::key);
    if (found == impl_->statuses.end() || found->key != key) return {};
    return row(static_cast<std::size_t>(found - impl_->statuses.begin()));
}

void StoreReader::for_each_row(const std::function<void(const WallRow&)>& visit)
{
    for (std::size_t i = 0; i < impl_->places.size(); ++i) visit(row(i));
}

RowSource StoreReader::walls()
{
    RowSource all{impl_->places.size(), 0, [this](std::size_t i) { return row(i); }};
    for (const Place& place : impl_->places) all.points += place.wall.points;
    return all;
}

StoreHead read_head(const fs::path& file) { return StoreReader(file).head(); }

std::vector<WallKey> missing_walls(const StoreHead& head, const std::vector<WallStatus>& there)
{
    std::vector<WallKey> missing;
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
