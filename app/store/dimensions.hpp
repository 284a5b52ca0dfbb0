#pragma once
/// Names for the dimensions of all datasets of a study's file, as HDF5's dimension scales and
/// netCDF-4 have them, so that xarray, ncdf4 and others see tables with named axes.

#include "app/store/hdf5/hdf5_file.hpp"
#include "app/store/store_head.hpp"

#include <cstdint>

namespace app {

/// Called when all datasets of the file are there.
/// @param walls, points numbers of rows of walls and of curves
void put_dimensions(const hdf5::File& file, const StoreHead& head, std::uint64_t walls,
                    std::uint64_t points);

} // namespace app
