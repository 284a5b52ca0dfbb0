#pragma once
/// Shards of one study into one file.

#include "app/store/store_error.hpp"
#include "app/store/store_row.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace app {

struct MergeOptions {
    bool partial = false; ///< accept walls that no shard has
    bool identical_overlap =
        false; ///< accept a wall in several shards if its results are the same
};

struct MergeReport {
    std::size_t walls = 0;
    std::size_t failed = 0;       ///< of these, with a status other than ok
    std::size_t overlapping = 0;  ///< taken once of several
    std::vector<WallKey> missing; ///< in no shard
};

/// Writes `out`, complete or not at all, in bounded memory. Shards (with their journals) are only
/// read. All must agree in identity, configuration, seed, levels, design sizes and columns.
/// Throws StoreError and writes nothing if they differ (shown), if a wall is twice or missing
/// (listed; see options), if a shard cannot be read, or if `out` exists; std::invalid_argument
/// without shards.
MergeReport merge(const std::filesystem::path& out,
                  const std::vector<std::filesystem::path>& shards,
                  const MergeOptions& options = {});

} // namespace app
