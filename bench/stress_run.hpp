#pragma once
/// Runs one stress scene and judges every wall of it by the rules of the campaign.

#include "bench/stress_scene.hpp"

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
};

/// Pushes the walls of a scene side by side, on this thread. Where one wall is spoilt, once more
/// without it: its neighbours must not notice.
[[nodiscard]] SceneReport run_stress_scene(std::uint64_t seed, std::uint64_t number,
                                           dem::Kinematics kinematics = dem::Kinematics::small);

[[nodiscard]] const char* name_of(dem::Outcome outcome);

} // namespace bench
