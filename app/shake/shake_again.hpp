#pragma once
/// Histories of a stored study once more, for their films.

#include "app/sampling/sample_plan.hpp"
#include "app/shake/history_plan.hpp"
#include "app/shake/shake_wall.hpp"
#include "app/study/stored/stored_histories.hpp"

#include <filesystem>

namespace app {

/// Wall, records and draws of a stored study of histories.
class ShakenAgain {
  public:
    /// @throws ConfigError where a record is not there any more, or another one
    ShakenAgain(const StoredHistories& stored, const std::filesystem::path& file);

    /// One of its histories, with snapshots kShakenFrame apart: the bits of the first time.
    /// @throws ConfigError where the wall cannot be shaken
    [[nodiscard]] ShakenWall history(std::size_t level, const StoredHistory& of,
                                     const ShakeProgress& seen) const;
    /// The study in the layout of that wall.
    [[nodiscard]] PreparedStudy study_of(const StoredHistory& history) const;

  private:
    PreparedStudy ready_;
    HistoryPlan plan_;
    SamplePlan samples_;
};

} // namespace app
