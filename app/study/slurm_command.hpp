#pragma once
/// `drystone study STUDY.ini --slurm FILE`: a job array instead of a run.

#include "app/input/command.hpp"
#include "app/input/prepared_study.hpp"

#include <cstddef>
#include <string>

namespace app {

/// The runs of a study and their cost.
struct StudyWork {
    std::size_t runs = 0; ///< of one wall each: most shards that make sense
    std::string name;     ///< of such runs: "walls"
    double each = 0.0;    ///< [s] of one core for one
    double all = 0.0;     ///< [s] of one core for all of them
    /// Walls that a shard also pushes, once each, if it has a run of them: runs of one wall are
    /// dealt to as many shards as there are.
    std::size_t pushed = 0;
    double each_push = 0.0; ///< [s] of one core for one
};

/// Pushes of walls in all shards together.
[[nodiscard]] double pushes_of(const StudyWork& work, int shards);

/// [s] of one core for the study, divided among so many shards.
[[nodiscard]] double seconds_of(const StudyWork& work, int shards);

/// Runs one register of walls to know what a wall takes.
[[nodiscard]] StudyWork pushing_work(const PreparedStudy& ready);

/// @return exit code
/// @throws ConfigError
[[nodiscard]] int write_slurm_script(const StudyWork& work, const Command& command);

} // namespace app
