#include "app/shake/shake_again.hpp"

#include "app/shake/shaken_film.hpp"

#include <utility>

namespace app {

ShakenAgain::ShakenAgain(const StoredHistories& stored, const std::filesystem::path& file)
    : ready_(shaken_study(lay_again(stored.study), 0)), plan_(history_plan(ready_))
{
    refuse_changed_records(ready_.study, plan_, file);
    samples_ = sample_plan(ready_.study, ready_.layout, stored_walls(stored.head, plan_));
}

ShakenWall ShakenAgain::history(std::size_t level, const StoredHistory& of,
                                const ShakeProgress& seen) const
{
    const auto at = static_cast<int>(level);
    const WantedWall wall{at, draw(samples_, at, static_cast<int>(of.wall))};
    ShakenWall again;
    shake_wall(ready_, wall, {shaking_motion(plan_.records, of.record, of.intensity)},
               kShakenFrame, seen, [&](ShakenWall&& w) { again = std::move(w); });
    return again;
}

} // namespace app
