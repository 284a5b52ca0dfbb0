#pragma once
/// The head of a study in its HDF5 file.

#include "app/store/hdf5/hdf5_file.hpp"
#include "app/store/store_head.hpp"

namespace app {

/// Writes all of the head but the columns; makes the groups.
void put_head(const hdf5::File& file, const StoreHead& head);
/// Writes names, units and meanings of the columns, whose datasets must be there.
void put_columns(const hdf5::File& file, const StoreHead& head);
/// Throws StoreError if the file is of another layout, of something else or damaged.
[[nodiscard]] StoreHead stored_head(const hdf5::File& file);

} // namespace app
