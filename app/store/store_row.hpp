#pragma once
/// One wall of a study as it is stored.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace app {

/// Which wall: level of vertical stress and sample, both from 0.
struct WallKey {
    std::uint32_t level = 0;
    std::uint32_t sample = 0;
    friend auto operator<=>(const WallKey&, const WallKey&) = default;
};

constexpr std::int32_t kWallOk = 0; ///< status of a wall that gave results

[[nodiscard]] std::string wall_name(WallKey key); ///< "wall (level 2, sample 17)"

struct WallStatus {
    WallKey key;
    std::int32_t status = kWallOk; ///< else a code of failure
};

/// Capacity curve; all columns equally long, possibly empty.
struct WallCurve {
    std::vector<double> displacement; ///< [m]
    std::vector<double> force;        ///< [N]
    std::vector<std::vector<double>>
        further; ///< one per StoreHead::curve_columns, in its units
};

constexpr std::size_t kMaxReason = 500; ///< [bytes] kept of WallRow::reason

/// Everything but `cost` is the same bit for bit whenever the wall is run again. Sizes are those
/// of the columns of StoreHead; NaN: not defined.
struct WallRow {
    WallKey key;
    std::int32_t status = kWallOk;
    std::string reason; ///< why it failed, no '\0'; cut at kMaxReason bytes; empty if ok
    std::vector<double> inputs;
    std::vector<double> responses;
    std::vector<std::int64_t> counts;
    std::vector<double> cost; ///< not reproducible: seconds
    WallCurve curve;
};

/// Equal to the bit (a NaN equals the same NaN; 0 and -0 differ) in all but `cost`.
[[nodiscard]] bool same_results(const WallRow& a, const WallRow& b);

} // namespace app
