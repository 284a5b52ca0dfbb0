#include "app/store/wall_file.hpp"

#include "app/store/dimensions.hpp"
#include "app/store/hdf5/store_disk.hpp"
#include "app/store/hdf5/store_error.hpp"
#include "app/store/stored_head.hpp"
#include "app/store/wall_datasets.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kBlock = 16; ///< walls that are read or written together

void write_rows(const hdf5::File& file, const StoreHead& head, const RowSource& source)
{
    WallDatasets to(file, head, source.walls, source.points);
    std::uint64_t point = 0;
    std::vector<WallRow> rows;
    for (std::uint64_t first = 0; first < source.walls; first += rows.size()) {
        rows.clear();
        for (std::uint64_t i = first; i < std::min(first + kBlock, source.walls); ++i)
            rows.push_back(source.row(i));
        point = to.write(first, point, rows);
    }
}

void tell(const StageHook& reached, StoreStage stage)
{
    if (reached) reached(stage);
}

/// A file under its temporary name; leaves nothing behind unless renamed.
class Temporary {
  public:
    explicit Temporary(fs::path path) : path_(std::move(path)) { ::unlink(path_.c_str()); }
    ~Temporary()
    {
        if (renamed_) return;
        // HDF5 may keep the file open after an error: give its space back at once
        OpenFile(::open(path_.c_str(), O_WRONLY | O_TRUNC | O_NOFOLLOW | O_CLOEXEC)).close();
        ::unlink(path_.c_str());
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    void rename_to(const fs::path& file)
    {
        if (::rename(path_.c_str(), file.c_str()) != 0) disk_error("write", file, errno);
        renamed_ = true;
    }

  private:
    fs::path path_;
    bool renamed_ = false;
};

} // namespace

void write_wall_file(const fs::path& file, const StoreHead& head, const RowSource& source,
                     const StageHook& reached)
{
    fs::path path = file;
    path += ".tmp";
    Temporary temporary(path);
    hdf5::File written = hdf5::create_file(path);
    put_head(written, head);
    write_rows(written, head, source);
    put_columns(written, head);
    put_dimensions(written, head, source.walls, source.points);
    hdf5::close_file(std::move(written));
    tell(reached, StoreStage::rows_written);
    sync_file(path);
    tell(reached, StoreStage::synced);
    temporary.rename_to(file);
    sync_folder_of(file);
    tell(reached, StoreStage::renamed);
}

struct WallFile::Impl {
    hdf5::File file;
    StoreHead head;
    WallDatasets from;
    std::vector<StoredWall> walls;
    std::vector<WallRow> block{}; ///< the rows read last
    std::size_t first = 0;        ///< of them

    explicit Impl(const fs::path& path)
        : file(hdf5::open_file(path)), head(stored_head(file)), from(file, head),
          walls(from.index())
    {
    }
};

std::optional<WallFile> WallFile::open(const fs::path& file)
{
    if (!open_to_read(file).is_open()) return {};
    try {
        if (!begins_as_hdf5(file))
            damaged(file, "it is empty, not the file of a study, or its beginning is lost");
        return WallFile(std::make_unique<Impl>(file));
    } catch (const StoreError&) {
        if (!open_to_read(file).is_open()) return {}; // removed meanwhile
        throw;
    }
}

WallFile::WallFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WallFile::~WallFile() = default;
WallFile::WallFile(WallFile&&) noexcept = default;
WallFile& WallFile::operator=(WallFile&&) noexcept = default;

const fs::path& WallFile::path() const { return impl_->file.path; }
const StoreHead& WallFile::head() const { return impl_->head; }
const std::vector<StoredWall>& WallFile::walls() const { return impl_->walls; }

WallRow WallFile::row(std::size_t i)
{
    const std::size_t first = i / kBlock * kBlock;
    if (impl_->block.empty() || impl_->first != first) {
        impl_->block.clear();
        const std::span<const StoredWall> walls(impl_->walls);
        const std::size_t n = std::min<std::size_t>(kBlock, walls.size() - first);
        impl_->block = impl_->from.read(first, walls.subspan(first, n));
        impl_->first = first;
    }
    return impl_->block.at(i - first);
}

bool begins_as_hdf5(const fs::path& file)
{
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    std::ifstream in(file, std::ios::binary);
    std::string beginning(512 + signature.size(), '\0');
    in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    return beginning.starts_with(signature) ||
           beginning.ends_with(signature); // after a user block
}

} // namespace app
