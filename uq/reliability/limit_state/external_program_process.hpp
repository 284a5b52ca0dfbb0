#pragma once
/// One process with a process group of its own, so that what it starts can be ended with it.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace uq {

struct Launch {
    std::vector<std::string> command;            ///< program (looked up in PATH) and arguments
    std::filesystem::path directory;             ///< working directory
    std::filesystem::path input, output, errors; ///< stdin, stdout, stderr
    std::vector<std::pair<std::string, std::string>> environment; ///< added to the caller's
};

class Process {
  public:
    /// Starts it. @throws std::runtime_error if it cannot be run, with the system's reason
    explicit Process(const Launch& launch);
    Process(Process&& other) noexcept;
    Process& operator=(Process&& other) noexcept;
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process(); ///< kills the whole group if it has not ended

    /// Whether it has ended; does not wait. What is left of its group is killed then.
    [[nodiscard]] bool ended();
    void signal_group(int signal) const;
    /// "exit code 3", "signal 11 (Segmentation fault)"; empty for exit code 0. After ended().
    [[nodiscard]] std::string failure() const;

  private:
    pid_t pid_ = -1;
    int status_ = 0;
};

} // namespace uq
