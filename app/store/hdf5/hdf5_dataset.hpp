#pragma once
/// Datasets of numbers or texts, row by row, in chunks that are shuffled, deflated and end with
/// HDF5's Fletcher-32 checksum. Files come from strangers: what is opened or read here is
/// refused before the first value is read unless it is as this program writes it.

#include "app/store/hdf5/hdf5_file.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace app::hdf5 {

/// HDF5 type of T in memory.
template <class T> [[nodiscard]] hid_t type_of()
{
    if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
    if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::is_same_v<T, std::uint32_t>) return H5T_NATIVE_UINT32;
    if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
}

/// Rows of `width` values each. The file must outlive it.
class Dataset {
  public:
    /// Makes a dataset of `sizes`: rows, and their width if it is a matrix.
    Dataset(const File& file, std::string name, hid_t type, std::vector<hsize_t> sizes);
    /// Opens one of `rank` axes (1 or 2) that is there. Throws StoreError if it is not in the
    /// file itself, has another rank, filters that this program does not use, or more values
    /// than the bytes stored for it can hold.
    Dataset(const File& file, std::string name, int rank = 1);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::uint64_t rows() const { return sizes_[0]; }
    [[nodiscard]] std::uint64_t width() const { return sizes_.size() > 1 ? sizes_[1] : 1; }
    [[nodiscard]] std::size_t value_bytes() const; ///< in the file

    /// Rows [first, first + n), `values` of n x width. Throw StoreError. Numbers are read as
    /// the type that they are stored as, or float as double; texts of fixed length.
    void write(std::uint64_t first, std::uint64_t n, hid_t type, const void* values);
    void read(std::uint64_t first, std::uint64_t n, hid_t type, void* values) const;

    template <class T> void write(std::uint64_t first, std::span<const T> values)
    {
        if (!values.empty()) write(first, values.size() / width(), type_of<T>(), values.data());
    }
    template <class T>
    [[nodiscard]] std::vector<T> read(std::uint64_t first, std::uint64_t n) const
    {
        std::vector<T> values(static_cast<std::size_t>(n * width()));
        read(first, n, type_of<T>(), values.data());
        return values;
    }

    /// Throws StoreError if it does not have this many rows.
    void require_rows(std::uint64_t rows) const;

  private:
    void check_storage(const Handle& list) const;
    void check_size(const Handle& list) const;
    void check_type(hid_t type) const;
    [[nodiscard]] Handle selected(std::uint64_t first, std::uint64_t n) const;
    [[nodiscard]] Handle space(std::uint64_t rows) const;

    const File* file_;
    std::string name_;
    std::vector<hsize_t> sizes_; ///< rows, and width if it is a matrix
    Handle id_, type_;
};

/// A dataset of texts, padded with NUL to the longest of them or to `bytes`.
void put_texts(const File& file, const std::string& name,
               const std::vector<std::string>& texts);
/// All texts of a dataset, each of at most `most_bytes`. Throws StoreError.
[[nodiscard]] std::vector<std::string> texts_of(const File& file, const std::string& name,
                                                std::size_t most_bytes);

/// Texts of rows [first, first + n), without padding, each of at most `most_bytes`. Throws
/// StoreError.
[[nodiscard]] std::vector<std::string> read_texts(const File& file, const Dataset& from,
                                                  std::uint64_t first, std::uint64_t n,
                                                  std::size_t most_bytes);

} // namespace app::hdf5
