#pragma once
/// A stored study of walls that were shaken: its histories, as fragility and summary read them.

#include "app/input/study/study.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"
#include "app/study/stored/shaken_intensities.hpp"
#include "dem/scene/mechanism/mechanism.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace app {

struct StoredHistory {
    WallKey key;
    std::size_t wall = 0, record = 0, intensity = 0;
    bool failed = false; ///< it gave no numbers but those above and the measures
    std::string reason;  ///< why
    bool fell = false;
    double max_drift = 0.0;      ///< [-]; of a wall that fell, up to there
    double residual_drift = 0.0; ///< [-], of a wall that stands
    double collapse_time = 0.0;  ///< [s], of a wall that fell
    double uplift = 0.0;         ///< largest share of the lowest joint that was open [-]
    double pushed_limit = 0.0;   ///< ultimate drift of its push [-]; NaN: not known
    double seconds = 0.0;        ///< of one core
    dem::FailureMode mode = dem::FailureMode::rocking; ///< where it was farthest out
    std::vector<double> measures;                      ///< as StoredHistories::measures [SI]
};

struct HistoryLevel {
    double stress = 0.0; ///< [Pa]
    std::vector<StoredHistory> histories;
    std::size_t missing = 0; ///< of the study, not in the file
};

struct StoredHistories {
    std::string name; ///< of the file
    bool shard = false;
    Study study;
    StoreHead head;
    ShakenIntensities at;              ///< whose values StoredHistory::intensity counts
    std::vector<std::string> records;  ///< names
    std::vector<std::string> measures; ///< "pga", "sa(0.3 s)", ...
    std::vector<std::string> units;    ///< SI, of each measure
    std::vector<HistoryLevel> levels;
};

/// @param overrides fragility.key=value in place of the study's
/// @throws StoreError, ConfigError
[[nodiscard]] StoredHistories read_histories(const std::filesystem::path& file,
                                             std::span<const std::string> overrides = {});

/// Sentences about histories that failed, by reason, with the first of them, and those that are
/// still to run.
[[nodiscard]] std::string history_troubles(const StoredHistories& all);

} // namespace app
