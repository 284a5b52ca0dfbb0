#include "app/store/hdf5/hdf5_dataset.hpp"

#include <algorithm>
#include <utility>

namespace app::hdf5 {

namespace {

constexpr std::uint64_t kChunkBytes = 64 << 10;
constexpr unsigned kDeflate = 1; ///< level 4 takes a third longer and saves 2 %
/// The most that deflate makes of one byte: what a dataset declares beyond it is not in the
/// file.
constexpr std::uint64_t kMostInflation = 1032;
constexpr std::uint64_t kMostChunkBytes = 64 << 20;
constexpr std::uint64_t kMostTexts = 1'000'000;

/// [bytes]; the largest number if that is exceeded.
std::uint64_t size_of(const std::vector<hsize_t>& sizes, std::uint64_t value_bytes)
{
    for (const hsize_t size : sizes)
        if (__builtin_mul_overflow(value_bytes, std::uint64_t{size}, &value_bytes))
            return UINT64_MAX;
    return value_bytes;
}

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
    type_ = file_->owned(H5Tcopy(type), H5Tclose, "set up");
    const Handle all = space(rows());
    id_ = file_->owned(H5Dcreate2(file_->id.get(), name_.c_str(), type, all.get(), H5P_DEFAULT,
                                  list.get(), H5P_DEFAULT),
                       H5Dclose, "add " + name_ + " to");
}

Dataset::Dataset(const File& file, std::string name, int rank)
    : file_(&file), name_(std::move(name)), id_(opened_object(file, name_))
{
    if (H5Iget_type(id_.get()) != H5I_DATASET) damaged(file.path, name_ + " is no dataset");
    const Handle list =
        file.owned(H5Dget_create_plist(id_.get()), H5Pclose, "read " + name_ + " of");
    check_storage(list);
    type_ = file.owned(H5Dget_type(id_.get()), H5Tclose, "read " + name_ + " of");
    const Handle space = file.owned(H5Dget_space(id_.get()), H5Sclose, "read " + name_ + " of");
    if (H5Sget_simple_extent_ndims(space.get()) != rank)
        damaged(file.path, name_ + (rank == 1 ? " is not a list" : " is not a table"));
    sizes_.resize(static_cast<std::size_t>(rank));
    file.checked(H5Sget_simple_extent_dims(space.get(), sizes_.data(), nullptr),
                 "read " + name_ + " of");
    check_size(list);
}

/// Values of other files (external storage, virtual datasets) and filters, which run code, are
/// not followed.
void Dataset::check_storage(const Handle& list) const
{
    const H5D_layout_t layout = H5Pget_layout(list.get());
    const bool own = layout == H5D_COMPACT || layout == H5D_CONTIGUOUS || layout == H5D_CHUNKED;
    if (!own || H5Pget_external_count(list.get()) != 0)
        damaged(file_->path, name_ + " has its values in another file");
    const int filters =
        file_->checked(H5Pget_nfilters(list.get()), "read the filters of " + name_ + " in");
    for (int k = 0; k < filters; ++k) {
        unsigned flags = 0, config = 0;
        std::size_t values = 0;
        const H5Z_filter_t filter = H5Pget_filter2(list.get(), static_cast<unsigned>(k), &flags,
                                                   &values, nullptr, 0, nullptr, &config);
        if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE &&
            filter != H5Z_FILTER_FLETCHER32)
            damaged(file_->path, name_ + " has a filter that this program does not use (" +
                                     std::to_string(filter) + ")");
    }
}

/// Checks that the file holds as many bytes as the dataset and each of its chunks declare,
/// since all of them are read into memory.
void Dataset::check_size(const Handle& list) const
{
    if (size_of(sizes_, value_bytes()) / kMostInflation > H5Dget_storage_size(id_.get()))
        damaged(file_->path, name_ + " declares " + std::to_string(rows()) +
                                 " rows, more than the file can hold");
    if (H5Pget_layout(list.get()) != H5D_CHUNKED) return;
    std::vector<hsize_t> chunk(sizes_.size());
    file_->checked(H5Pget_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data()),
                   "read the chunks of " + name_ + " in");
    if (size_of(chunk, value_bytes()) > kMostChunkBytes)
        damaged(file_->path, name_ + " has chunks of more than 64 MiB");
}

void Dataset::check_type(hid_t type) const
{
    const bool same =
        H5Tget_class(type) == H5T_STRING
            ? is_fixed_text(type_.get())
            : H5Tequal(type_.get(), type) > 0 || (H5Tequal(type, H5T_NATIVE_DOUBLE) > 0 &&
                                                  H5Tequal(type_.get(), H5T_NATIVE_FLOAT) > 0);
    if (!same) damaged(file_->path, name_ + " has values of another type");
}

std::size_t Dataset::value_bytes() const { return H5Tget_size(type_.get()); }

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
    check_type(type);
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
                                    std::uint64_t n, std::size_t most_bytes)
{
    const std::size_t bytes = from.value_bytes();
    if (bytes > most_bytes)
        damaged(file.path, from.name() + " has texts of more than " +
                               std::to_string(most_bytes) + " bytes");
    std::string padded(static_cast<std::size_t>(n) * bytes, '\0');
    from.read(first, n, text_type(file, bytes).get(), padded.data());
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < n; ++i) {
        texts.push_back(padded.substr(i * bytes, bytes));
        texts.back().resize(std::min(texts.back().find('\0'), bytes));
    }
    return texts;
}

std::vector<std::string> texts_of(const File& file, const std::string& name,
                                  std::size_t most_bytes)
{
    const Dataset from(file, name);
    if (from.rows() > kMostTexts)
        damaged(file.path, name + " has more than " + std::to_string(kMostTexts) + " texts");
    return read_texts(file, from, 0, from.rows(), most_bytes);
}

} // namespace app::hdf5
