#pragma once
/// The numbers of a wall that a study can be judged by. A row of this table is a word of the
/// keys reliability.response and uq.stop, and needs no other list.

#include "app/reading/wall_reading.hpp"

#include <array>
#include <limits>
#include <string_view>

namespace app {

struct WallResponse {
    std::string_view name;  ///< "peak_force"
    std::string_view words; ///< "peak force"
    std::string_view unit;  ///< in which it is shown and given: "kN"
    double scale;           ///< shown value / value in SI
    bool ends_with_push; ///< a push that ends before can only say that it is larger: is_bound
    /// In SI, a bound where only that is known. NaN: not defined on this wall.
    double (*read)(const WallReading& wall, double height);
    bool (*is_bound)(const WallReading& wall); ///< whether the push ended before
};

constexpr double known_ultimate(const WallReading& w)
{
    return is_defined(w.ultimate) ? w.ultimate.displacement
                                  : std::numeric_limits<double>::quiet_NaN();
}

inline bool still_rising(const WallReading& w) { return w.peak && w.peak->at_end; }
inline bool never_fell(const WallReading& w) { return is_censored(w.ultimate); }

// clang-format off
inline constexpr std::array kWallResponses = {
    WallResponse{"peak_force", "peak force", "kN", 1e-3, false,
        [](const WallReading& w, double) { return peak_force(w); }, still_rising},
    WallResponse{"peak_displacement", "displacement at the peak", "mm", 1e3, true,
        [](const WallReading& w, double) { return peak_displacement(w); }, still_rising},
    WallResponse{"ultimate_displacement", "ultimate displacement", "mm", 1e3, true,
        [](const WallReading& w, double) { return known_ultimate(w); }, never_fell},
    WallResponse{"ultimate_drift", "ultimate drift", "%", 1e2, true,
        [](const WallReading& w, double height) { return known_ultimate(w) / height; }, never_fell},
};
// clang-format on

} // namespace app
