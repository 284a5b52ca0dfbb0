#include "app/shake/shake_wall.hpp"

#include "app/input/wall/random_layouts.hpp"
#include "app/text/config_error.hpp"
#include "dem/block/model.hpp"
#include "dem/shaking/shake_ensemble.hpp"

#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace app {

PreparedStudy shaken_study(PreparedStudy ready, int sample)
{
    check_shaken_study(ready.study, ready.study.solver, ready.study.shaking,
                       ready.study.source);
    if (has_layouts(ready.study.geometry))
        ready = in_layout(ready.study,
                          layout_seed(ready.study, static_cast<std::uint32_t>(sample)));
    ready.study.solver.kinematics = dem::Kinematics::finite; // whatever the default of a push
    return ready;
}

void shake_wall(const PreparedStudy& ready, const WantedWall& wall,
                const std::vector<ShakingMotion>& motions, double frame_every,
                const ShakeProgress& seen, const std::function<void(ShakenWall&&)>& finished)
{
    const Study& study = ready.study;
    const Study moving = moving_study(study);
    const dem::Model model = model_of({moving, ready.layout});
    const dem::WallMaterials materials = wall_materials(
        moving, moving.random, stress_level(moving.load, wall.level), model.layout, wall.draw);
    std::vector<ShakenWall> walls(motions.size());
    std::vector<double> shares(motions.size(), 0.0); // that are done
    dem::ShakenEnsemble all;
    all.size = motions.size();
    all.damps = study.shaking.contact_damping > 0.0;
    all.history = [&](std::size_t i) {
        dem::ShakePlan plan = shake_plan(study.load, study.shaking, motions[i]);
        plan.snapshot_every = frame_every;
        plan.progress = [&, i](double done, double top) {
            shares[i] = done;
            const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
            seen(motions[i], sum / static_cast<double>(shares.size()), top);
        };
        return dem::HistoryInput{materials, std::move(plan)};
    };
    all.done = [&](std::size_t i, dem::ShakeResult&& result) {
        shares[i] = 1.0;
        walls[i] = {motions[i], std::move(result), study.load.mass,
                    study.load.vertical_stress.at(wall.level)};
    };
    try {
        // One thread: `seen` is called in that of the caller.
        dem::shake_ensemble(model, all, moving.solver,
                            {.threads = 1, .scalar = motions.size() == 1});
    } catch (const std::invalid_argument& bad) {
        throw ConfigError(study.source.path, 0, "", bad.what());
    }
    for (ShakenWall& w : walls) finished(std::move(w));
}

} // namespace app
