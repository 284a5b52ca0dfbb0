#pragma once
/// A study file as Python holds it.

#include "app/sampling/sample_plan.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "dem/block/model.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace app {
struct Study;
}

namespace bindings {

struct LoadedStudy {
    app::StudySource source;
    std::optional<app::SamplePlan> plan; ///< made when it is first needed
    std::optional<dem::Model> model;     ///< made when it is first needed
    std::map<std::uint32_t, std::shared_ptr<LoadedStudy>>
        layouts; ///< by seed, as they are needed
};

/// The study in the layout of one of its samples: itself, where there is one layout.
/// @throws app::ConfigError
[[nodiscard]] std::shared_ptr<LoadedStudy> study_of(const std::shared_ptr<LoadedStudy>& study,
                                                    int sample);

/// @param path study file, or file of results; empty: all values are given
/// @param overrides section.key=value
/// @param wall wall.key=value, in the place of all that the study file says of the wall; empty:
/// its own
/// @throws app::ConfigError, app::StoreError
[[nodiscard]] std::shared_ptr<LoadedStudy> load_study(const std::string& path,
                                                      const std::vector<std::string>& overrides,
                                                      const std::vector<std::string>& wall);

/// @throws app::ConfigError
[[nodiscard]] const app::SamplePlan& plan_of(LoadedStudy& study);
[[nodiscard]] const dem::Model& model_of(LoadedStudy& study);

/// A wall and the study whose rules read it.
struct WallOfStudy {
    std::shared_ptr<const LoadedStudy> study;
    app::PushedWall wall;
    int level = 0;
    std::optional<int> sample;
    app::WallDraw draw; ///< without values: the numbers of the study, or its means
};

/// The snapshots of each push that are kept beside its curve and its end.
enum class Snapshots { none, at_peak, all };

/// Pushes walls side by side; the interpreter is free meanwhile.
/// @param threads 0: all of this machine
/// @param snapshots all: at the peak and as output.snapshot_every says
[[nodiscard]] std::vector<app::PushedWall>
push_beside_python(LoadedStudy& study, const std::vector<app::WantedWall>& wanted, int threads,
                   Snapshots snapshots);

} // namespace bindings
