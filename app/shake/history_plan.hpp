#pragma once
/// The histories of a study: stress x wall x record x intensity, and the head of their file.

#include "app/input/prepared_study.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/shake/shaking_motions.hpp"
#include "app/store/store_head.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace app {

struct StudyFile;

struct HistoryPlan {
    ShakingRecords records;
    ShakingDesign design = ShakingDesign::crossed;
    std::vector<ground::Measure> measures; ///< that are kept of each history
};

/// One history under a stress.
struct HistoryOf {
    std::size_t wall = 0, record = 0, intensity = 0;
};

/// @throws ConfigError
[[nodiscard]] HistoryPlan history_plan(const PreparedStudy& ready);

/// Histories of each wall under one stress. Samples count through intensities first, then
/// through records, then through walls, so that walls that are added later come last.
[[nodiscard]] std::size_t histories_per_wall(const HistoryPlan& plan);
[[nodiscard]] HistoryOf history_of(const HistoryPlan& plan, std::uint32_t sample);

/// The lines of the study's identity about its records: name, samples, check sum.
[[nodiscard]] std::vector<std::string> record_lines_of(const ShakingRecords& records);

/// Sizes through which the design of the walls of a file has grown.
[[nodiscard]] std::vector<std::uint32_t> stored_walls(const StoreHead& head,
                                                      const HistoryPlan& plan);

/// @param walls sizes through which the design of walls has grown
[[nodiscard]] StoreHead history_head(const Study& study, const HistoryPlan& plan,
                                     const SamplePlan& samples,
                                     std::vector<std::uint32_t> walls);

/// Tells in a sentence which records of a file that is there are no longer the same.
/// @throws ConfigError at shaking.records
void refuse_changed_records(const StudyFile& source, const HistoryPlan& plan,
                            const std::filesystem::path& file);

} // namespace app
