#pragma once
/// Shards of one study into one file.

#include "app/store/hdf5/store_error.hpp"
#include "app/store/store_row.hpp"

#include <filesystem>
#include <functional>
#include <vector>

namespace app {

/// Asked about every wall before it is written, with the file that it comes from.
using WallCheck = std::function<void(const std::filesystem::path& file, const WallRow& wall)>;

/// Writes `out`, complete or not at all, in bounded memory. Shards (with their parts) are only
/// read. All must agree in identity, configuration, seed, levels, design sizes and columns.
/// Throws StoreError and writes nothing if they differ (shown), if a wall is in two of them, if
/// a shard (named) or a wall (listed) is missing unless `partial`, if a shard cannot be read,
/// or if `out` exists; std::invalid_argument without shards; and what `check` throws, which is
/// asked about every wall.
void merge(const std::filesystem::path& out, const std::vector<std::filesystem::path>& shards,
           bool partial = false, const WallCheck& check = {});

} // namespace app
