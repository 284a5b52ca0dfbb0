#pragma once
/// Runs the walls of a study that its file does not have yet.

#include "app/input/command.hpp"
#include "app/input/prepared_study.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/store/store.hpp"
#include "app/study/pushed/wall_frames.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace app {

struct GeometryInput;

/// Portions that are dealt out to the shards of a study, in turns.
enum class Deal {
    walls,  ///< of each level every N-th, from another shard on for each level
    samples ///< with the walls under all stresses, which lie in one layout
};
[[nodiscard]] Deal deal_of(const GeometryInput& geometry);

/// Walls of a part of a study, sample by sample under all levels, so that a study that is
/// stopped has about as many of each. Samples that are added later change nothing for those
/// before. A shard has walls under every level unless there are fewer samples than shards.
/// @param round a shard has of the audit, and of the other direction, the walls whose own walls
/// it has
[[nodiscard]] std::vector<WallKey> walls_of(const StoreHead& head, Shard shard,
                                            Deal deal = Deal::walls, Round round = Round::own);

/// Walls that a file has although they do not belong to a shard of this number: another version
/// of the program divided them. A whole study has none.
[[nodiscard]] std::vector<WallKey> foreign_walls(const StoreHead& head,
                                                 const std::vector<WallStatus>& there,
                                                 Deal deal = Deal::walls);

/// Walls that the store does not have, and failed ones too if asked for.
[[nodiscard]] std::vector<WallKey> pending_walls(const Store& store, Shard shard,
                                                 bool rerun_failed, Deal deal = Deal::walls,
                                                 Round round = Round::own);

/// The study as its audit pushes it, kAuditSlower times slower.
[[nodiscard]] PreparedStudy audit_study(PreparedStudy ready);

struct RunProgress {
    std::size_t done = 0, failed = 0, all = 0; ///< walls of this run
    std::size_t before = 0;   ///< walls of this part of the study that the file had already
    Round round = Round::own; ///< what these walls are pushed for
};

/// @param walls of the study itself, of its audit with audit_study, or of the other direction
/// with turned_round
/// @param start `before` walls that need not be pushed, and the round: for RunProgress
/// Finished walls are stored every three seconds, whatever happens then.
/// @param seen after each wall
/// @param frames of each wall that gives a result, in no order
/// @throws StoreError if the disk refuses; Interrupted. Finished walls are kept.
RunProgress run_walls(const PreparedStudy& ready, const SamplePlan& plan,
                      const std::vector<WallKey>& walls, int threads, Store& store,
                      const std::function<void(const RunProgress&)>& seen,
                      const FrameTaker& frames = {}, RunProgress start = {});

} // namespace app
