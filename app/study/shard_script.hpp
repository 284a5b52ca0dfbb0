#pragma once
/// A job array for Slurm that runs the shards of a study and merges them.

#include "app/input/command.hpp"

#include <string>

namespace app {

struct ShardScript {
    std::string program; ///< absolute path of the program
    std::string study;   ///< absolute path of the study file
    std::string out;     ///< absolute path of the merged file
    std::string folder;  ///< for logs, absolute
    std::vector<std::string> overrides;
    int shards = 1;
    int threads = 1;      ///< of one shard
    double minutes = 0.0; ///< expected for one shard
};

/// A bash script; run, it submits two jobs: the array, and a merge that waits for all of its tasks. A
/// task that is killed or whose node fails is requeued and goes on with its file.
[[nodiscard]] std::string slurm_script(const ShardScript& s);

/// Shards so that one takes about half an hour, at least one wall in each, at most 1000.
/// @param seconds of one core for a wall
[[nodiscard]] int shard_count(std::size_t walls, double seconds, int threads);

} // namespace app
