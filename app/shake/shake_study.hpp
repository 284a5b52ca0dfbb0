#pragma once
/// `drystone study` of a study whose walls are shaken.

#include "app/input/command.hpp"
#include "app/input/prepared_study.hpp"
#include "app/shake/history_row.hpp"
#include "app/study/study_runner.hpp"

#include <functional>

namespace app {

struct StudyFile;

/// Whether the study says how the ground moves: its verb study shakes walls.
[[nodiscard]] bool is_shaken(const StudyFile& file);

/// All histories of a study into one file; it is resumed where it stops.
/// @return 0, or 1 if histories failed
/// @throws ConfigError, StoreError, Interrupted
[[nodiscard]] int shake_study_command(const Command& command);

/// Shakes walls of a study in several threads. A history has the same bits whatever their
/// number.
/// @param done takes each history when it is there, one at a time, in no order
/// @throws Interrupted; what `done` throws
void run_histories(const PreparedStudy& ready, const HistoryPlan& plan,
                   const SamplePlan& samples, const std::vector<WallKey>& histories,
                   int threads,
                   const std::function<void(WallKey, const WallDraw&, ShakenHistory&&)>& done);

} // namespace app
