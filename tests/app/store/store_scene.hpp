#pragma once
/// A small study to store: every number of a wall follows from its key, so that what is read
/// back can be compared without keeping it.

#include "app/store/store.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace scenes {

/// 3 levels of `samples` walls, 4 inputs, 3 responses, 2 counts, 1 cost.
[[nodiscard]] app::StoreHead store_head(std::uint32_t samples);
/// Curves of `points` points, some more or fewer; every 7th wall failed, without a curve. Holds
/// -0 and numbers below the normal ones, and beside inputs and curves NaN and infinities.
[[nodiscard]] app::WallRow store_row(app::WallKey key, std::size_t points = 20);
/// Rows of samples [first, last) of all 3 levels, in an order that is not that of the keys.
[[nodiscard]] std::vector<app::WallRow> store_rows(std::uint32_t first, std::uint32_t last,
                                                   std::size_t points = 20);
/// All walls are those of store_row, bit for bit, cost included; number of walls.
[[nodiscard]] std::size_t check_rows(const std::filesystem::path& file,
                                     std::size_t points = 20);

} // namespace scenes
