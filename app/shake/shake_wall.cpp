#include "app/shake/shake_wall.hpp"

#include "app/input/random_layouts.hpp"
#include "app/text/config_error.hpp"
#include "dem/block/model.hpp"

#include <stdexcept>

namespace app {

PreparedStudy shaken_study(PreparedStudy ready, int sample)
{
    refuse_small(ready.study);
    if (has_layouts(ready.study))
        ready = in_layout(ready.study,
                          layout_seed(ready.study, static_cast<std::uint32_t>(sample)));
    ready.study.solver.kinematics = dem::Kinematics::finite; // whatever the default of a push
    return ready;
}

void shake_wall(const PreparedStudy& ready, const WantedWall& wall,
                const std::vector<ShakingMotion>& motions, const ShakeProgress& seen,
                const std::function<void(ShakenWall&&)>& finished)
{
    const Study& study = ready.study;
    const Study moving = moving_study(study);
    const dem::Model model = model_of({moving, ready.layout});
    const dem::WallMaterials materials =
        wall_materials(moving, model.layout, wall.level, wall.draw);
    for (const ShakingMotion& m : motions) {
        dem::ShakePlan plan = shake_plan(study, m);
        plan.progress = [&](double done, double top) { seen(m, done, top); };
        try {
            finished({m, dem::shake(model, materials, plan, moving.solver), plan.load,
                      study.load.vertical_stress.at(wall.level)});
        } catch (const std::invalid_argument& bad) {
            throw ConfigError(study.source.path, 0, "", bad.what());
        }
    }
}

} // namespace app
