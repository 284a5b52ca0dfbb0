#pragma once
/// Runs a study: all its walls go into one file. The command line and Python call it.

#include "app/input/command.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "app/study/study_runner.hpp"
#include "app/study/study_summary.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace app {

struct Study;

struct StudyRun {
    std::filesystem::path
        file; ///< resumed where it stops; its folder is made if it is not there
    Shard shard;
    int threads = 1; ///< >= 1
    bool rerun_failed = false;
    /// Told before the first wall of a round and after each wall, one at a time, from any
    /// thread. A study with a stopping rule may have several rounds; an audit is a round of its
    /// own. It may throw Interrupted, which ends the run as a signal does.
    std::function<void(const RunProgress&)> seen;
    FrameTaker frames; ///< of the walls that this run pushes
};

struct StudyRunEnd {
    bool whole = false; ///< else it was interrupted; the same run resumes where it stopped
    std::string remark; ///< of the stopping rule
    std::size_t before = 0, now = 0; ///< walls that the file had, and that this run added
};

/// Adds samples until the rule of the study is content, if it has one.
/// @throws ConfigError, StoreError, and what `seen` throws but Interrupted; walls that are
/// finished are kept
[[nodiscard]] StudyRunEnd run_study(const PreparedStudy& ready, const StudyRun& run);

/// Checks before a run that study_summary replaces nothing of others.
/// @throws ConfigError if a file of its name is there and was not written by an earlier run
void check_summary(const std::filesystem::path& file);

/// One row per stress level, also into FILE_summary.csv, .md and .tex beside FILE.h5.
/// @param write false: of a shard nothing is written
[[nodiscard]] StudySummary study_summary(const std::filesystem::path& file, bool write);

} // namespace app
