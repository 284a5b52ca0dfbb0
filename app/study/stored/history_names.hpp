#pragma once
/// Names in the file of a study whose walls are shaken: written by app/shake, read by
/// app/study/stored_histories. A history is a row: its level is the vertical stress, its sample
/// counts through walls, records and intensities.

#include "app/store/store_head.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

inline constexpr std::string_view kWallColumn = "wall", kRecordColumn = "record",
                                  kIntensityColumn = "intensity";
/// Begins the names of the measures of intensity of each history, such as "im.sa(0.3_s)".
inline constexpr std::string_view kMeasureColumns = "im.";
/// Begins the lines of an identity that say which records shook the walls.
inline constexpr std::string_view kRecordLine = "shaking.record ";

/// Outcomes of a history in the order of dem::ShakeOutcome, and one more.
inline constexpr std::int64_t kStood = 0, kFell = 1, kNoWallToShake = 5;

/// Whether a file holds histories of walls that were shaken, and no pushes.
[[nodiscard]] bool holds_histories(const StoreHead& head);

/// The lines of an identity about its records, one text for each.
[[nodiscard]] std::vector<std::string> record_lines(const std::string& identity);

/// The identity without them.
[[nodiscard]] std::string without_record_lines(const std::string& identity);

/// Name of the record that a line is about.
[[nodiscard]] std::string record_name(std::string_view line);

/// @throws BadStoredStudy for a file of histories, which push verbs cannot read
void refuse_histories(const std::string& file, const StoreHead& head);

} // namespace app
