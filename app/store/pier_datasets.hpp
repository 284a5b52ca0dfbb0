#pragma once
/// The datasets of a wall file that hold piers and spandrels, in the groups /piers and
/// /spandrels: one row per wall, or per point of a curve, and one column per pier.

#include "app/store/hdf5/hdf5_dataset.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace app {

/// A group of parts: where they are in a head, in a row and in a file.
struct PartGroup {
    std::string group; ///< "/piers"
    std::string noun;  ///< "pier"
    StorePiers StoreHead::*stored;
    PierRow WallRow::*row;
    bool curves; ///< whether it has storeys and curves
};
[[nodiscard]] const std::vector<PartGroup>& part_groups();

/// docs/store.md says what they hold. Made for writing or opened for reading; file and head
/// must outlive them.
class PierDatasets {
  public:
    PierDatasets(const hdf5::File& file, const StoreHead& head, const PartGroup& parts,
                 std::uint64_t walls, std::uint64_t points);
    PierDatasets(const hdf5::File& file, const StoreHead& head, const PartGroup& parts);

    /// Throws StoreError if they have not these numbers of rows.
    void require(std::uint64_t walls, std::uint64_t points) const;
    /// Writes the piers of rows from `first` on, whose curves begin at `point`.
    void write(std::uint64_t first, std::uint64_t point, std::span<const WallRow> rows);
    /// Reads them into rows whose curves are there.
    void read(std::uint64_t first, std::uint64_t point, std::span<WallRow> rows) const;

  private:
    const hdf5::File* file_;
    const PartGroup* parts_;
    std::size_t piers_;
    std::vector<hdf5::Dataset> facts_;  ///< in the order of StorePiers::facts
    std::vector<hdf5::Dataset> curves_; ///< movement and shear, or nothing
};

/// Places of the piers, and units and meanings of the datasets, which must be there.
void put_parts(const hdf5::File& file, const StoreHead& head);
/// Sets those of a head; nothing where the file has none. Throws StoreError.
void read_parts(const hdf5::File& file, StoreHead& head);

} // namespace app
