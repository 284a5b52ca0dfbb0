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

/// "wall (level 2, sample 17)"
[[nodiscard]] inline std::string wall_name(WallKey key)
{
    return "wall (level " + std::to_string(key.level) + ", sample " +
           std::to_string(key.sample) + ")";
}

/// A wall in a file, without its numbers.
struct StoredWall {
    WallKey key;
    std::int32_t status = kWallOk;
    std::uint64_t points = 0; ///< of its curve
};

struct WallStatus {
    WallKey key;
    std::int32_t status = kWallOk; ///< else a code of failure
};

/// Capacity curve; both equally long, possibly empty.
struct WallCurve {
    std::vector<double> displacement; ///< [m]
    std::vector<double> force;        ///< [N]
};

constexpr std::size_t kMaxReason = 500; ///< [bytes] kept of WallRow::reason

/// Piers or spandrels of a wall; nothing in studies whose piers are not told apart. By pier
/// within a fact, and within a point of the curve. Spandrels have no curves.
struct PierRow {
    std::vector<double> facts;           ///< of StoreHead::piers or spandrels; NaN: not defined
    std::vector<double> movement, shear; ///< at the points of the curve [m] [N]; NaN: not read
};

/// Everything but `cost` is the same bit for bit whenever the wall is run again. Sizes are
/// those of the columns of StoreHead; NaN: not defined.
struct WallRow {
    WallKey key;
    std::int32_t status = kWallOk;
    std::string reason; ///< why it failed, no '\0'; cut at kMaxReason bytes; empty if ok
    std::vector<double> inputs;
    std::vector<double> responses;
    std::vector<std::int64_t> counts;
    std::vector<double> cost; ///< not reproducible: seconds
    WallCurve curve;
    PierRow piers{}, spandrels{};
};

} // namespace app
