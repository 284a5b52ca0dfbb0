#pragma once
/// Shards of one study into one file.

#include "app/store/store_error.hpp"

#include <filesystem>
#include <vector>

namespace app {

/// Writes `out`, complete or not at all, in bounded memory. Shards (with their parts) are only
/// read. All must agree in identity, configuration, seed, levels, design sizes and columns.
/// Throws StoreError and writes nothing if they differ (shown), if a wall is in two of them, if one
/// is in none (listed) unless `partial`, if a shard cannot be read, or if `out` exists;
/// std::invalid_argument without shards.
void merge(const std::filesystem::path& out, const std::vector<std::filesystem::path>& shards,
           bool partial = false);

} // namespace app
