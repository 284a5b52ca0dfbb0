#pragma once
/// Walls of a stored study as fragility needs them: limit states read off their curves, mode, inputs.

#include "app/fragility/fragility_data.hpp"
#include "app/fragility/fragility_states.hpp"
#include "app/input/study.hpp"
#include "app/store/store_row.hpp"
#include "app/study/stored_input.hpp"
#include "fragility/curve_reading.hpp"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace app {

constexpr int kRocking = 0, kMixed = 1;        ///< modes, in the order of dem::FailureMode
constexpr double kFallOfUltimate = 0.8;        ///< of the peak: where StudyWall::ultimate lies
[[nodiscard]] const char* mode_name(int mode); ///< "rocking", "mixed"
constexpr std::size_t kCurveSteps = 120;       ///< of the grid of displacements for mean curves

/// A wall that gave results.
struct StudyWall {
    WallKey key;
    int mode = kRocking;  ///< by the rule of dem/scene/mechanism.hpp
    bool dropped = false; ///< the load fell to 80 % of the peak
    double rotation_share = 0.0, sliding_share = 0.0; ///< [-]
    int cracked_units = 0;
    double peak_force = 0.0;               ///< [N]
    fragility::LimitDisplacement ultimate; ///< [m], as stored: first fall to 80 % of the peak
    std::vector<double> inputs;            ///< shown values; of several per joint, their mean
    std::vector<fragility::LimitDisplacement> limits; ///< [m], one per state
    std::vector<double>
        forces; ///< [N] at 0, 1, ... kCurveSteps steps, as far as the curve goes
};

struct StudyLevel {
    double stress = 0.0; ///< [Pa]
    std::vector<StudyWall> walls;
    std::size_t failed = 0, missing = 0;
    std::map<std::string, std::size_t> reasons; ///< why walls failed, how many
};

struct StudyWalls {
    std::string name;   ///< of the file: "paper.h5", "part.h5, shard 1 of 4"
    bool shard = false; ///< the file holds a part of the study on purpose
    Study study;
    WantedStates wanted;
    std::vector<StateName> states;
    std::vector<StoredInput> inputs;
    std::vector<StudyLevel> levels;
    double height = 1.0;        ///< of the load line [m]
    double step = 0.0;          ///< of StudyWall::forces [m]
    bool pushed_one_way = true; ///< else no limit state is defined
    bool shared =
        false; ///< one design for all levels: walls of two levels depend on each other
};

/// @param overrides fragility.key=value in place of the study's
/// @throws StoreError, ConfigError
[[nodiscard]] StudyWalls read_study_walls(const std::filesystem::path& file,
                                          std::span<const std::string> overrides);

/// Drifts in percent of the height of the load line.
[[nodiscard]] DriftData drift_data(const StudyWalls& walls);

} // namespace app
