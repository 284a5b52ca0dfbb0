#pragma once
/// The datasets of a wall file that hold piers, in the group /piers: one row per wall, or per
/// point of a curve, and one column per pier.

#include "app/store/hdf5_dataset.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace app {

/// docs/store.md says what they hold. Made for writing or opened for reading; file and head
/// must outlive them.
class PierDatasets {
  public:
    PierDatasets(const hdf5::File& file, const StoreHead& head, std::uint64_t walls,
                 std::uint64_t points);
    PierDatasets(const hdf5::File& file, const StoreHead& head);

    /// Throws StoreError if they have not these numbers of rows.
    void require(std::uint64_t walls, std::uint64_t points) const;
    /// Writes the piers of rows from `first` on, whose curves begin at `point`.
    void write(std::uint64_t first, std::uint64_t point, std::span<const WallRow> rows);
    /// Reads them into rows whose curves are there.
    void read(std::uint64_t first, std::uint64_t point, std::span<WallRow> rows) const;

  private:
    const hdf5::File* file_;
    std::size_t piers_;
    std::vector<hdf5::Dataset> facts_; ///< in the order of StorePiers::facts
    hdf5::Dataset movement_, shear_;
};

/// Places of the piers, and units and meanings of the datasets, which must be there.
void put_piers(const hdf5::File& file, const StorePiers& piers);
/// Nothing where the file has no piers. Throws StoreError.
[[nodiscard]] StorePiers stored_piers(const hdf5::File& file);

} // namespace app
