#include "app/store/hdf5_dataset.hpp"

#include <algorithm>
#include <utility>

namespace app::hdf5 {

namespace {

constexpr std::uint64_t kChunkBytes = 64 << 10;
constexpr unsigned kDeflate = 1; ///< level 4 takes a third longer and saves 2 %

} // namespace

Dataset::Dataset(const File& file, std::string name, hid_t type, std::vector<hsize_t> sizes)
    : file_(&file), name_(std::move(name)), sizes_(std::move(sizes))
{
    const Handle list = file_->owned(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "set up");
    file_->checked(H5Pset_obj_track_times(list.get(), false), "set up");
    const std::uint64_t row_bytes = width() * H5Tget_size(type);
    if (rows() > 0 && row_bytes > 0) { // else there is nothing to cut into chunks
        std::vector<hsize_t> chunk = sizes_;
        chunk[0] = std::clamp<hsize_t>(kChunkBytes / row_bytes, 1, rows());
        file_->checked(H5Pset_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data()),
                       "set up");
        file_->checked(H5Pset_shuffle(list.get()), "set up");
        file_->checked(H5Pset_deflate(list.get(), kDeflate), "set up");
        file_->checked(H5Pset_fletcher32(list.get()), "set up");
    }
    const Handle all = space(rows());
    id_ = file_->owned(H5Dcreate2(file_->id.get(), name_.c_str(), type, all.get(), H5P_DEFAULT,
                                  list.get(), H5P_DEFAULT),
                       H5Dclose, "add " + name_ + " to");
}

Dataset::Dataset(const File& file, std::string name) : file_(&file), name_(std::move(name))
{
    id_ = file.owned(H5Dopen2(file.id.get(), name_.c_str(), H5P_DEFAULT), H5Dclose,
                     "find " + name_ + " in");
    const Handle space = file.owned(H5Dget_space(id_.get()), H5Sclose, "read");
    const int rank = H5Sget_simple_extent_ndims(space.get());
    if (rank != 1 && rank != 2) damaged(file.path, name_ + " is not a table");
    sizes_.resize(static_cast<std::size_t>(rank));
    file.checked(H5Sget_simple_extent_dims(space.get(), sizes_.data(), nullptr), "read");
}

std::size_t Dataset::value_bytes() const
{
    const Handle type = file_->owned(H5Dget_type(id_.get()), H5Tclose, "read");
    return H5Tget_size(type.get());
}

Handle Dataset::space(std::uint64_t rows) const
{
    std::vector<hsize_t> sizes = sizes_;
    sizes[0] = rows;
    return file_->owned(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr),
                        H5Sclose, "read or write");
}

Handle Dataset::selected(std::uint64_t first, std::uint64_t n) const
{
    Handle all = space(rows());
    std::vector<hsize_t> start(sizes_.size(), 0), count = sizes_;
    start[0] = first;
    count[0] = n;
    file_->checked(H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, start.data(), nullptr,
                                       count.data(), nullptr),
                   "read or write");
    return all;
}

void Dataset::write(std::uint64_t first, std::uint64_t n, hid_t type, const void* values)
{
    if (n == 0 || width() == 0) return;
    const Handle memory = space(n), place = selected(first, n);
    file_->checked(H5Dwrite(id_.get(), type, memory.get(), place.get(), H5P_DEFAULT, values),
                   "write");
}

void Dataset::read(std::uint64_t first, std::uint64_t n, hid_t type, void* values) const
{
    if (n == 0 || width() == 0) return;
    if (first > rows() || n > rows() - first) require_rows(first + n);
    const Handle memory = space(n), place = selected(first, n);
    file_->checked(H5Dread(id_.get(), type, memory.get(), place.get(), H5P_DEFAULT, values),
                   "read " + name_ + " of");
}

void Dataset::require_rows(std::uint64_t wanted) const
{
    if (rows() != wanted)
        damaged(file_->path, name_ + " has " + std::to_string(rows()) + " rows instead of " +
                                 std::to_string(wanted));
}

void put_texts(const File& file, const std::string& name, const std::vector<std::string>& texts)
{
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::string padded;
    for (const std::string& text : texts) {
        padded += text;
        padded.append(longest - text.size(), '\0');
    }
    const Handle type = text_type(file, longest);
    Dataset(file, name, type.get(), {texts.size()})
        .write(0, texts.size(), type.get(), padded.data());
}

std::vector<std::string> read_texts(const File& file, const Dataset& from, std::uint64_t first,
                                    std::uint64_t n)
{
    const std::size_t bytes = from.value_bytes();
    std::string padded(static_cast<std::size_t>(n) * bytes, '\0');
    from.read(first, n, text_type(file, bytes).get(), padded.data());
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < n; ++i) {
        texts.push_back(padded.substr(i * bytes, bytes));
        texts.back().resize(std::min(texts.back().find('\0'), bytes));
    }
    return texts;
}

std::vector<std::string> texts_of(const File& file, const std::string& name)
{
    const Dataset from(file, name);
    return read_texts(file, from, 0, from.rows());
}

} // namespace app::hdf5
