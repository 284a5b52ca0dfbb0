#pragma once
/// The datasets of a wall file with one row per wall, or per point of a curve.

#include "app/store/hdf5/hdf5_dataset.hpp"
#include "app/store/pier_datasets.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// docs/store.md says what they hold. They are made for writing or opened for reading; the file
/// and the head must outlive them.
class WallDatasets {
  public:
    /// For this many walls, whose curves have `points` points together. Throws StoreError.
    WallDatasets(const hdf5::File& file, const StoreHead& head, std::uint64_t walls,
                 std::uint64_t points);
    /// Throws StoreError if one is missing or has another number of rows than it should.
    WallDatasets(const hdf5::File& file, const StoreHead& head);

    /// Keys and statuses of all walls and how long their curves are. Throws StoreError if they
    /// contradict each other or the head.
    [[nodiscard]] std::vector<StoredWall> index() const;
    /// Writes rows from `first` on and their curves from `point` on. Returns where the next
    /// begins.
    std::uint64_t write(std::uint64_t first, std::uint64_t point,
                        std::span<const WallRow> rows);
    /// Reads rows from `first` on, whose index is known. Throws StoreError naming the wall
    /// whose numbers are none.
    [[nodiscard]] std::vector<WallRow> read(std::uint64_t first,
                                            std::span<const StoredWall> walls) const;

  private:
    void require_sound(const WallRow& row) const;

    const hdf5::File* file_;
    const StoreHead* head_;
    std::vector<hdf5::Dataset> numbers_; ///< one number per wall each: key, status, columns
    hdf5::Dataset reason_, inputs_, offset_, displacement_, force_;
    std::vector<PierDatasets> parts_; ///< piers and spandrels, where they are told apart
};

} // namespace app
