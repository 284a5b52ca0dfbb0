#include "app/store/store_column.hpp"

#include "app/store/store_error.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace app::hdf5 {

namespace {

constexpr std::uint64_t kChunkBytes = 64 << 10;

std::vector<hsize_t> sizes_of(const Shape& shape, std::uint64_t rows)
{
    if (shape.matrix) return {rows, shape.width};
    return {rows};
}

Handle creation_list(const File& file, const Shape& shape, int compression)
{
    Handle list =
        file.owned(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a creation list for");
    file.checked(H5Pset_obj_track_times(list.get(), false), "set up");
    if (shape.rows == 0 || shape.row_bytes() == 0) return list; // nothing to cut into chunks
    const std::vector<hsize_t> chunk = sizes_of(shape, shape.block_rows());
    file.checked(H5Pset_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data()),
                 "set chunks in");
    if (compression > 0) {
        file.checked(H5Pset_shuffle(list.get()), "set up");
        file.checked(H5Pset_deflate(list.get(), static_cast<unsigned>(compression)), "set up");
    }
    return list;
}

/// Selects rows [first, first + n) of a dataset.
Handle rows_selected(const File& file, hid_t dataset, const Shape& shape, std::uint64_t first,
                     std::uint64_t n)
{
    Handle space = file.owned(H5Dget_space(dataset), H5Sclose, "read a data space of");
    const std::vector<hsize_t> start =
        shape.matrix ? std::vector<hsize_t>{first, 0} : std::vector<hsize_t>{first};
    const std::vector<hsize_t> count = sizes_of(shape, n);
    file.checked(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr,
                                     count.data(), nullptr),
                 "select rows of");
    return space;
}

} // namespace

std::size_t Shape::row_bytes() const
{
    return static_cast<std::size_t>(width) * H5Tget_size(memory_type);
}

std::uint64_t Shape::block_rows() const
{
    const std::uint64_t fit = kChunkBytes / std::max<std::uint64_t>(1, row_bytes());
    return std::clamp<std::uint64_t>(fit, 1, std::max<std::uint64_t>(1, rows));
}

ColumnWriter::ColumnWriter(const File& file, const std::string& name, const Shape& shape,
                           int compression)
    : file_(&file), shape_(shape)
{
    const Handle space = space_of(file, sizes_of(shape, shape.rows));
    const Handle list = creation_list(file, shape, compression);
    dataset_ = file.owned(H5Dcreate2(file.id.get(), name.c_str(), shape.file_type, space.get(),
                                     H5P_DEFAULT, list.get(), H5P_DEFAULT),
                          H5Dclose, "add a dataset to");
}

void ColumnWriter::append(const void* rows, std::uint64_t n)
{
    const auto* bytes = static_cast<const char*>(rows);
    std::size_t left = static_cast<std::size_t>(n) * shape_.row_bytes();
    const std::size_t full = static_cast<std::size_t>(shape_.block_rows()) * shape_.row_bytes();
    while (left > 0) {
        const std::size_t now = std::min(left, full - block_.size());
        block_.insert(block_.end(), bytes, bytes + now);
        bytes += now;
        left -= now;
        if (block_.size() == full) write_block();
    }
}

void ColumnWriter::write_block()
{
    if (block_.empty()) return;
    const std::uint64_t n = block_.size() / shape_.row_bytes();
    const Handle memory = space_of(*file_, sizes_of(shape_, n));
    const Handle place = rows_selected(*file_, dataset_.get(), shape_, written_, n);
    file_->checked(H5Dwrite(dataset_.get(), shape_.memory_type, memory.get(), place.get(),
                            H5P_DEFAULT, block_.data()),
                   "write");
    written_ += n;
    block_.clear();
}

void ColumnWriter::finish()
{
    write_block();
    if (shape_.row_bytes() > 0 && written_ != shape_.rows) file_->fail("finish a dataset of");
    dataset_.close();
}

ColumnReader::ColumnReader(const File& file, const std::string& name, const Shape& shape)
    : file_(&file), name_(name), shape_(shape)
{
    dataset_ = file.owned(H5Dopen2(file.id.get(), name.c_str(), H5P_DEFAULT), H5Dclose,
                          ("open " + name + " in").c_str());
    const Handle space = file.owned(H5Dget_space(dataset_.get()), H5Sclose, "read");
    const std::vector<hsize_t> wanted = sizes_of(shape, shape.rows);
    std::array<hsize_t, H5S_MAX_RANK> sizes{};
    const int rank = H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
    const Handle type = file.owned(H5Dget_type(dataset_.get()), H5Tclose, "read");
    if (rank != static_cast<int>(wanted.size()) ||
        !std::equal(wanted.begin(), wanted.end(), sizes.begin()) ||
        H5Tequal(type.get(), shape.file_type) <= 0)
        throw StoreError("'" + file.path.string() + "' is damaged: " + name +
                         " has another size or type than the head says");
}

void ColumnReader::load(std::uint64_t block)
{
    const std::uint64_t first = block * shape_.block_rows();
    const std::uint64_t n = std::min(shape_.block_rows(), shape_.rows - first);
    loaded_ = ~std::uint64_t{0};
    block_.resize(static_cast<std::size_t>(n) * shape_.row_bytes());
    const Handle memory = space_of(*file_, sizes_of(shape_, n));
    const Handle place = rows_selected(*file_, dataset_.get(), shape_, first, n);
    file_->checked(H5Dread(dataset_.get(), shape_.memory_type, memory.get(), place.get(),
                           H5P_DEFAULT, block_.data()),
                   ("read " + name_ + " of").c_str());
    loaded_ = block;
}

void ColumnReader::read(std::uint64_t first, std::uint64_t n, void* rows)
{
    if (first > shape_.rows || n > shape_.rows - first)
        throw StoreError("'" + file_->path.string() + "' is damaged: " + name_ +
                         " has fewer rows than it should");
    const std::size_t row_bytes = shape_.row_bytes();
    if (row_bytes == 0) return;
    auto* to = static_cast<char*>(rows);
    while (n > 0) {
        const std::uint64_t block = first / shape_.block_rows();
        if (block != loaded_) load(block);
        const std::uint64_t skip = first - block * shape_.block_rows();
        const std::uint64_t now = std::min(n, block_.size() / row_bytes - skip);
        std::memcpy(to, block_.data() + skip * row_bytes,
                    static_cast<std::size_t>(now) * row_bytes);
        to += now * row_bytes;
        first += now;
        n -= now;
    }
}

namespace {

Handle dataset_of(const File& file, const std::string& name)
{
    return file.owned(H5Dopen2(file.id.get(), name.c_str(), H5P_DEFAULT), H5Dclose,
                      ("open " + name + " in").c_str());
}

} // namespace

std::uint64_t rows_of(const File& file, const std::string& name)
{
    const Handle dataset = dataset_of(file, name);
    const Handle space = file.owned(H5Dget_space(dataset.get()), H5Sclose, "read");
    hsize_t rows = 0;
    if (H5Sget_simple_extent_ndims(space.get()) != 1 ||
        H5Sget_simple_extent_dims(space.get(), &rows, nullptr) != 1)
        throw StoreError("'" + file.path.string() + "' is damaged: " + name + " is no list");
    return rows;
}

std::size_t element_bytes(const File& file, const std::string& name)
{
    const Handle dataset = dataset_of(file, name);
    const Handle type = file.owned(H5Dget_type(dataset.get()), H5Tclose, "read");
    return H5Tget_size(type.get());
}

} // namespace app::hdf5
