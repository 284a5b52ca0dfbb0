#pragma once
/// A stored study: its walls, each read once by the rules of [fragility]. Summary, stopping
/// rule, tables and page are made of this and nothing else.

#include "app/input/study/study.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/store/merge.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"
#include "app/study/pushed/pier_reading.hpp"
#include "app/study/stored/stored_input.hpp"
#include "app/study/stored/stress_text.hpp"
#include "fragility/curve/cyclic_curve.hpp"

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

constexpr int kRocking = 0, kSliding = 1,
              kMixed = 2;                      ///< modes, in the order of dem::FailureMode
constexpr int kAllModes = 3;                   ///< walls of any mode
[[nodiscard]] const char* mode_name(int mode); ///< "rocking", "sliding", "mixed", "all"
constexpr std::size_t kCurveSteps = 120;       ///< of the grid of displacements for mean curves

constexpr double kUnknownError = std::numeric_limits<double>::quiet_NaN();

/// A pier of a wall, as read_piers() read it.
struct StudyPier {
    std::string_view mode;            ///< mode_text()
    double drift = 0.0;               ///< at the end of the push, over its own height [-]
    double slenderness = 0.0;         ///< H0 / D [-]
    double normal = 0.0, shear = 0.0; ///< when the wall carries most [N]
};

struct StudyWall {
    WallKey key;
    bool failed = false; ///< it gave no result: only key, reason and inputs mean anything
    std::string reason;  ///< why it failed
    WallReading reading; ///< of a wall that was pushed both ways the worse of both
    /// A wall that was pushed both ways: to the direction of the study, and to the other.
    std::vector<WallReading> ways;
    /// To the direction of the study, and to the other where walls are pushed both ways; empty:
    /// not told apart.
    std::vector<StudyPier> piers, turned_piers;
    std::vector<SpandrelReading> spandrels, turned_spandrels; ///< the same
    dem::Mechanism mechanism;
    double solver_error =
        kUnknownError; ///< of the peak force [-], >= 0; NaN: failed, or a file without it
    double points_error = kUnknownError; ///< of the force by the contact points, likewise
    std::vector<double>
        inputs; ///< shown values; of several per joint, their mean (Keep::means)
    std::vector<double>
        forces;                ///< [N] at 0, 1, ... kCurveSteps steps, as far as the curve goes
    std::vector<double> drawn; ///< inputs as they are stored, in SI (Keep::everything)
    /// Cycles of a push that turns back (Keep::means); displacements in [m], forces in [N].
    std::vector<fragility::Cycle> cycles;
    WallCurve curve; ///< as it was stored (Keep::everything)
};

/// As the wall was pushed to the direction of the study: what `curve` shows.
[[nodiscard]] inline const WallReading& first_way(const StudyWall& wall)
{
    return wall.ways.empty() ? wall.reading : wall.ways.front();
}

/// Source of its numbers (kWallNumbers), no longer than the wall lives.
[[nodiscard]] inline WallSource source_of(const StudyWall& wall, double height)
{
    return {wall.reading, height, wall.mechanism, wall.solver_error, wall.points_error};
}

/// kRocking, kSliding or kMixed
[[nodiscard]] inline int mode_of(const StudyWall& wall)
{
    return static_cast<int>(wall.reading.mode);
}

struct StudyLevel {
    double stress = 0.0;          ///< [Pa]
    std::vector<StudyWall> walls; ///< that gave a result
    std::vector<StudyWall> failed_walls;
    std::size_t missing = 0; ///< walls of the study that are not in the file
    /// Walls of the level pushed again more slowly (uq.audit), by sample, failed ones too.
    std::vector<StudyWall> audit{};
    std::size_t audit_missing = 0;
};

struct StudyWalls {
    std::string name;   ///< of the file: "paper.h5", "part.h5, shard 1 of 4"
    bool shard = false; ///< the file holds a part of the study on purpose
    Study study;
    ReadingRules rules;
    std::vector<StateName> states; ///< of StudyWall::limits
    std::vector<StoredInput> inputs;
    std::vector<StudyLevel> levels;
    StoreHead head;
    std::vector<dem::Pier> piers; ///< of every wall; empty: not told apart, or not stored
    PierRules pier_rules;         ///< where they are
    std::vector<dem::Spandrel> spandrels; ///< of every wall; empty as those
    double height = 1.0;                  ///< of the load line [m]
    double step = 0.0;                    ///< of StudyWall::forces [m]
    bool pushed_one_way = true;           ///< else walls are read on their backbones
    bool shared =
        false; ///< one design for all levels: walls of two levels depend on each other
};

/// Place of a random input; nothing where this key does not vary.
[[nodiscard]] std::optional<std::size_t> input_of(const StudyWalls& study,
                                                  std::string_view key);

/// The modes that the study tells apart (fragility.modes).
[[nodiscard]] std::vector<int> modes_of(const StudyWalls& study);

/// Data kept of each wall beside its reading.
enum class Keep {
    readings,  ///< nothing
    means,     ///< inputs, and forces for mean curves
    everything ///< drawn values and curves too
};

/// @param overrides fragility.key=value in place of the study's
/// @throws StoreError, ConfigError
[[nodiscard]] StudyWalls read_study_walls(const std::filesystem::path& file,
                                          std::span<const std::string> overrides = {},
                                          Keep keep = Keep::means);

/// Tells of every wall of the study of `file` whether it can be read: throws BadStoredStudy
/// naming the file that it is in and the wall.
/// @throws StoreError, ConfigError
[[nodiscard]] WallCheck readable_walls(const std::filesystem::path& file);

/// Walls of a study that lives longer.
using WallList = std::vector<const StudyWall*>;

/// Walls that gave a result, of one mode or of kAllModes.
[[nodiscard]] WallList walls_of(const StudyLevel& level, int mode);

/// All walls, failed ones too, by level and sample.
[[nodiscard]] WallList all_walls(const StudyWalls& study);

/// Failed walls by reason.
[[nodiscard]] std::map<std::string, std::vector<WallKey>> failures(const StudyWalls& study);

/// "0.75 MPa sample 17, 0.75 MPa sample 20": the first `most` of these walls.
[[nodiscard]] std::string named(const StudyWalls& study, const std::vector<WallKey>& walls,
                                std::size_t most);

/// Lines for people: walls that failed, by reason, with the first of them; walls still to run.
[[nodiscard]] std::string trouble_text(const StudyWalls& walls);

} // namespace app
