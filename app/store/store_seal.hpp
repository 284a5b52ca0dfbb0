#pragma once
/// The first 512 bytes of FILE.h5, which HDF5 leaves to the user (its user block): text that says what
/// the file is, its length and its CRC-32. Damage is found before the HDF5 library, which can crash on
/// damaged files, sees any of it.

#include "app/store/store_disk.hpp"

#include <cstdint>
#include <filesystem>

namespace app {

constexpr std::uint64_t kSealBytes = 512; ///< the least user block of HDF5

/// Sums bytes 512 to the end and writes the seal. Throws StoreError.
void write_seal(const OpenFile& file, const std::filesystem::path& path);

/// Whether the file begins as a study's, damaged or not, or as another HDF5 file: what
/// check_seal() has something to say about.
[[nodiscard]] bool begins_as_study(const std::filesystem::path& path);

/// Throws StoreError if the file is not as it was sealed: another layout, damaged, cut, changed by
/// another program, or of something else; says which and what to do.
void check_seal(const OpenFile& file, const std::filesystem::path& path);

} // namespace app
