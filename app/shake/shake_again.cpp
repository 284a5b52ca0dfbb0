#include "app/shake/shake_again.hpp"

#include "app/input/wall/random_layouts.hpp"
#include "app/shake/shaken_film.hpp"

#include <utility>

namespace app {

ShakenAgain::ShakenAgain(const StoredHistories& stored, const std::filesystem::path& file)
    : ready_(lay_again(stored.study)), plan_(history_plan(ready_))
{
    ready_.study.solver.kinematics = dem::Kinematics::finite; // whatever the default of a push
    refuse_changed_records(ready_.study.source, plan_, file);
    samples_ = sample_plan(ready_.study, ready_.study.load, ready_.study.source, ready_.layout,
                           stored_walls(stored.head, plan_));
}

ShakenWall ShakenAgain::history(std::size_t level, const StoredHistory& of,
                                const ShakeProgress& seen) const
{
    const auto at = static_cast<int>(level);
    const WantedWall wall{at, draw(samples_, at, static_cast<int>(of.wall))};
    ShakenWall again;
    shake_wall(study_of(of), wall, {shaking_motion(plan_.records, of.record, of.intensity)},
               kShakenFrame, seen, [&](ShakenWall&& w) { again = std::move(w); });
    return again;
}

PreparedStudy ShakenAgain::study_of(const StoredHistory& history) const
{
    const Study& study = ready_.study;
    if (!has_layouts(study.geometry)) return ready_;
    return in_layout(study, layout_seed(study, static_cast<std::uint32_t>(history.wall)));
}

} // namespace app
