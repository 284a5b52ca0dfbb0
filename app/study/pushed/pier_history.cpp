#include "app/study/pushed/pier_history.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace app {
namespace {

void add(dem::CutForce& sum, const dem::CutForce& f, double factor)
{
    sum.normal += factor * f.normal;
    sum.shear += factor * f.shear;
    sum.moment += factor * f.moment;
}

/// Mean of the forces of the instants from `first` to `last`.
void set_mean(const PierHistory& history, std::size_t first, std::size_t last, PierInstant& now)
{
    const double share = 1.0 / static_cast<double>(last - first + 1);
    now.base_shear = 0.0;
    for (dem::PierState& p : now.piers) p.force = {};
    for (dem::SpandrelState& s : now.spandrels) s.force = {};
    for (std::size_t k = first; k <= last; ++k) {
        now.base_shear += share * history[k].base_shear;
        for (std::size_t i = 0; i < now.piers.size(); ++i)
            add(now.piers[i].force, history[k].piers[i].force, share);
        for (std::size_t i = 0; i < now.spandrels.size(); ++i)
            add(now.spandrels[i].force, history[k].spandrels[i].force, share);
    }
}

} // namespace

PierMovement pier_movement(const dem::PierProbe& probe, std::size_t pier,
                           const dem::Snapshot& shot)
{
    constexpr double kMoves = 1e-4; // [-], of its height: a pier that stands still has no mode
    const dem::Region& at = probe.piers().piers.at(pier).at;
    const double height = at.z1 - at.z0;
    const dem::Snapshot alone = probe.alone(pier, shot);
    if (alone.blocks.empty() || !(std::abs(alone.displacement) > kMoves * height)) return {};
    return {true, dem::mechanism(alone, height)};
}

PierInstant pier_instant(const dem::PierProbe& probe, const dem::Snapshot& shot)
{
    PierInstant now{shot.displacement, shot.force, probe.base_shear(shot), {}, {}, {}};
    const dem::Piers& all = probe.piers();
    for (std::size_t i = 0; i < all.piers.size(); ++i) now.piers.push_back(probe.pier(i, shot));
    for (std::size_t i = 0; i < all.spandrels.size(); ++i)
        now.spandrels.push_back(probe.spandrel(i, shot));
    return now;
}

PierHistory calmed(const PierHistory& history, double way)
{
    PierHistory calm = history;
    const auto is_near = [&](std::size_t a, std::size_t b) {
        return std::abs(history[a].displacement - history[b].displacement) <= way;
    };
    for (std::size_t k = 0; k < history.size(); ++k) {
        std::size_t n = 0; // to either side
        while (n < k && k + n + 1 < history.size() && is_near(k - n - 1, k) &&
               is_near(k, k + n + 1))
            ++n;
        if (n > 0) set_mean(history, k - n, k + n, calm[k]);
    }
    return calm;
}

std::size_t at_peak(const PierHistory& history)
{
    const auto most = std::ranges::max_element(
        history, {}, [](const PierInstant& i) { return std::abs(i.force); });
    return static_cast<std::size_t>(most - history.begin());
}

std::optional<PierMovement> movement_at_drop(const PierHistory& calm, std::size_t pier,
                                             double way, double share)
{
    const auto shear = [&](const PierInstant& now) {
        return way * now.piers[pier].force.shear;
    };
    const auto strongest = std::ranges::max_element(calm, {}, shear);
    if (!(share > 0.0) || !(shear(*strongest) > 0.0)) return {};
    const double down = share * shear(*strongest);
    auto drop = std::find_if(strongest, calm.end(),
                             [&](const PierInstant& now) { return shear(now) <= down; });
    while (drop != calm.end() && drop->movements.empty()) ++drop;
    if (drop == calm.end() || !drop->movements[pier].moved) return {};
    return drop->movements[pier];
}

} // namespace app
