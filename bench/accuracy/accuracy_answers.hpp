#pragma once
/// Answers of the accuracy campaign in a file. References cost most, and serve as long as scene
/// and solver stay; answers of an earlier program show what changed.

#include "bench/accuracy/accuracy_run.hpp"

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace bench {

/// A CSV file to which each answer is added as it comes, so that a run that is stopped loses
/// none.
class AnswerFile {
  public:
    /// @param file empty: nothing is kept
    /// @param any whether answers of other settings and other revisions of the solver serve,
    /// too; of several, the last in the file
    /// @throws app::ConfigError if the file is no such table
    AnswerFile(std::filesystem::path file, bool any);

    /// Answer of a scene with this text (with the changes of --set to the wall itself) pushed
    /// with these settings. One that was too dear is only as good as the time it had.
    [[nodiscard]] std::optional<Answer>
    find(const std::string& text, const std::string& settings, double most_seconds) const;
    /// Revision of the solver that gave the last answer in the file; empty: none was read.
    [[nodiscard]] const std::string& revision() const { return revision_; }
    /// @throws std::runtime_error if the file cannot be written
    void add(std::uint64_t number, const std::string& text, const std::string& settings,
             const Answer& answer);

  private:
    std::filesystem::path file_;
    bool any_ = false;
    std::string revision_;
    mutable std::mutex mutex_;
    std::map<std::string, Answer> answers_;
};

} // namespace bench
