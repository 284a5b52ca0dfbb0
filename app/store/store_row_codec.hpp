#pragma once
/// A wall as bytes: a record of the journal.

#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace app {

/// The first bytes of an encoded wall, enough for an index.
struct RowSummary {
    WallKey key;
    std::int32_t status = kWallOk;
    std::uint32_t reason_bytes = 0;
    std::uint64_t points = 0; ///< of the curve
};

/// `row` must fit `head`, see check_row. Curves are rounded as the head says.
void encode_row(const StoreHead& head, const WallRow& row, std::string& bytes);
/// Throws StoreError (`file`: damaged) if the bytes are no wall of this head.
[[nodiscard]] RowSummary decode_summary(const StoreHead& head, std::string_view bytes,
                                        const std::string& file);
[[nodiscard]] WallRow decode_row(const StoreHead& head, std::string_view bytes,
                                 const std::string& file);

/// Throws std::invalid_argument naming the wall and what does not fit the head.
void check_row(const StoreHead& head, const WallRow& row);

} // namespace app
