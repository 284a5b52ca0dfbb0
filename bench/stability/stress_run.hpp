#pragma once
/// Runs one stress scene and judges every wall of it by the rules of the campaign.

#include "bench/stability/stress_scene.hpp"

#include <string>
#include <vector>

namespace bench {

struct WallReport {
    dem::Outcome outcome = dem::Outcome::reached_target;
    bool spoilt = false;
    int step_reductions = 0;
    double residual = 0.0; ///< largest |energy residual| read [-]
    long long steps = 0;
    bool settled = false;
    double over_limit =
        0.0; ///< step that was used over the measured limit [-]; 0: not asked for
};

struct SceneReport {
    std::uint64_t number = 0;
    StressScene scene;
    std::vector<WallReport> walls;
    std::vector<std::string> broken_rules; ///< empty: as it must be
    double seconds = 0.0;                  ///< of one core
    bool alone = false;                    ///< whether a wall was pushed alone besides
    double on_the_way = 0.0; ///< over_limit_on_the_way() of a wall whose joints close [-]
};

/// Pushes the walls of a scene side by side, on this thread. Where one wall is spoilt, once
/// more without it: its neighbours must not notice.
/// @param kinematics finite: of all scenes; small: as they are drawn
[[nodiscard]] SceneReport run_stress_scene(std::uint64_t seed, std::uint64_t number,
                                           dem::Kinematics kinematics = dem::Kinematics::small,
                                           DrawnLaws laws = DrawnLaws::linear);

[[nodiscard]] const char* name_of(dem::Outcome outcome);

} // namespace bench
