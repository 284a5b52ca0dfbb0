#pragma once
/// Another program as the model: one run per sample, several at a time. The format of its input
/// and result is in docs/external_program.md.

#include "uq/reliability/limit_state/black_box.hpp"

#include <filesystem>
#include <functional>
#include <utility>

namespace uq {

enum class Keep { none, failed, all }; ///< directories of samples, after their run

struct ExternalProgram {
    /// Program and arguments, run without a shell. In each, {input}, {output}, {sample},
    /// {directory} (of the run, its working directory) and {here} (where the analysis was
    /// started) are filled in. Without {output} the result is what it prints.
    std::vector<std::string> command;
    std::vector<std::string> parameters; ///< names of the columns of the samples
    std::vector<std::string> responses;  ///< names of the columns of the answer
    int concurrent = 1;                  ///< runs at a time, >= 1; no result depends on it
    double time_limit = 0.0;             ///< of one run [s]; 0: none
    double grace = 2.0;                  ///< between SIGTERM and SIGKILL [s], >= 0
    int retries = 0;                     ///< further tries of a run that failed, >= 0
    int stderr_lines = 5;                ///< last lines of stderr kept in the reason, >= 0
    std::vector<std::pair<std::string, std::string>>
        environment;                 ///< added to that of the caller
    std::filesystem::path directory; ///< where the runs have theirs; empty: the system's, for
                                     ///< temporary files
    Keep keep = Keep::none;
    /// Called again and again while runs are awaited. What it throws ends the batch: its runs
    /// are killed and their directories removed, unless all are kept.
    std::function<void()> while_waiting;
};

/// A run that does not end with exit code 0 and a complete result of finite numbers is a failed
/// sample, with the reason of its last try. A result {"failure": "reason"} is a failure by its
/// own account, and not tried again. Whatever a run has started and left behind is killed with
/// it.
/// @throws std::invalid_argument naming what is missing or out of range; the model throws the
/// same if the number of columns is not that of the parameters, and
/// std::filesystem::filesystem_error if there can be no directory
[[nodiscard]] BlackBox external_model(ExternalProgram program);

} // namespace uq
