#include "app/shake/shaken_film.hpp"

#include "app/output/picture/film_svg.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace app {
namespace {

constexpr std::size_t kMostShapes = 28'000; ///< frames times moving shapes: some 2 MB
constexpr std::size_t kFewestFrames = 40, kMostFrames = 400;

/// First of `some` frames around the one at `middle`.
std::size_t window(const std::vector<double>& times, double middle, std::size_t some)
{
    const auto at =
        static_cast<std::size_t>(std::ranges::lower_bound(times, middle) - times.begin());
    return std::min(at - std::min(at, some / 2), times.size() - some);
}

} // namespace

std::string shaken_film(const ShakenWall& shaken, const StoneTints& tints)
{
    const dem::ShakeResult& r = shaken.result;
    if (r.snapshots.size() < 2) return {};
    const std::size_t shapes =
        r.snapshots.front().blocks.size() + r.snapshots.front().faces.size() / 3;
    const std::size_t some = std::min(
        r.snapshots.size(), std::clamp(kMostShapes / shapes, kFewestFrames, kMostFrames));
    const std::size_t first = window(r.snapshot_times, r.most_at, some);
    std::vector<double> time, displacement;
    for (const dem::HistoryPoint& p : r.history) {
        time.push_back(p.time);
        displacement.push_back(p.displacement);
    }
    return shaken_film_svg({std::span(r.snapshots).subspan(first, some),
                            std::span(r.snapshot_times).subspan(first, some), time,
                            displacement},
                           {shaken.motion.name, r.top_height, tints});
}

} // namespace app
