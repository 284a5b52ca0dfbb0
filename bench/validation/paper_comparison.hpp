#pragma once
/// The paper's tables beside ours.

#include "app/output/table/table.hpp"
#include "bench/validation/level_statistics.hpp"

#include <string>
#include <vector>

namespace bench {

/// Levels of two studies of ours: one of the size of the paper's, one with many more walls.
struct OurLevels {
    std::vector<LevelStatistics> same_size, large;
};

/// Difference of two shares with its 95 % interval (Newcombe 1998, Statistics in Medicine 17,
/// 873-890, method 10: from Wilson's intervals) [-].
struct ShareDifference {
    double value = 0.0, lower = 0.0, upper = 0.0;
};
/// k1 / n1 - k2 / n2. @throws std::invalid_argument for an empty sample
[[nodiscard]] ShareDifference share_difference(std::size_t k1, std::size_t n1, std::size_t k2,
                                               std::size_t n2);

[[nodiscard]] app::Table pooled_peaks(const OurLevels& ours); ///< all walls of a level
/// A sentence: which peaks and shares differ by more than the sampling of both.
[[nodiscard]] std::string what_differs(const OurLevels& ours);
[[nodiscard]] app::Table rocking_table(const OurLevels& ours); ///< Table 6
[[nodiscard]] app::Table mixed_table(const OurLevels& ours);   ///< Table 7
[[nodiscard]] app::Table rocking_shares(const OurLevels& ours);
[[nodiscard]] app::Table mixed_displacements(const OurLevels& ours);
/// Table 8 at 0.75 MPa: values per joint against values per wall.
[[nodiscard]] app::Table spatial_table(const LevelStatistics& per_wall,
                                       const LevelStatistics& stratified,
                                       const LevelStatistics& independent);
/// Peaks against the tests, the paper's and ours.
[[nodiscard]] app::Table test_table(const OurLevels& ours);
/// Fig. 15: drift at which the mean curve of a mode falls to 80 % of its peak, under each
/// stress.
[[nodiscard]] app::Table drifts_of_mean_curves(const app::StudyWalls& walls);

} // namespace bench
