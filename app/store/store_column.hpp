#pragma once
/// Datasets of numbers with one row per wall (or per point of a curve), read and written chunk by chunk.

#include "app/store/store_hdf5.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace app::hdf5 {

/// What a dataset holds: one of the element types below, `width` of them per row; rank 2 if `matrix`.
struct Shape {
    hid_t file_type;   ///< as stored
    hid_t memory_type; ///< as handed over
    std::uint64_t rows = 0;
    std::uint64_t width = 1;
    bool matrix = false;
    [[nodiscard]] std::size_t row_bytes() const;
    [[nodiscard]] std::uint64_t block_rows() const; ///< of one chunk, about 64 KiB
};

/// Rows handed over one after another, written in whole chunks.
class ColumnWriter {
  public:
    ColumnWriter(const File& file, const std::string& name, const Shape& shape,
                 int compression);
    void append(const void* rows, std::uint64_t n);
    void finish(); ///< writes what is left; throws if not all rows were handed over

  private:
    void write_block();

    const File* file_;
    Shape shape_;
    Handle dataset_;
    std::vector<char> block_;
    std::uint64_t written_ = 0; ///< [rows]
};

/// Rows read by number; one chunk is kept.
class ColumnReader {
  public:
    /// Throws StoreError if there is no such dataset or its type or size is not that of `shape`.
    ColumnReader(const File& file, const std::string& name, const Shape& shape);
    void read(std::uint64_t first, std::uint64_t n, void* rows);

  private:
    void load(std::uint64_t block);

    const File* file_;
    std::string name_;
    Shape shape_;
    Handle dataset_;
    std::vector<char> block_;
    std::uint64_t loaded_ = ~std::uint64_t{0};
};

/// Rows of a dataset of rank 1. Throws StoreError.
[[nodiscard]] std::uint64_t rows_of(const File& file, const std::string& name);
/// Bytes of one element. Throws StoreError.
[[nodiscard]] std::size_t element_bytes(const File& file, const std::string& name);

} // namespace app::hdf5
