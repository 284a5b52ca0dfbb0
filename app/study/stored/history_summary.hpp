#pragma once
/// A study of walls that were shaken, in one small table.

#include "app/output/table/table.hpp"
#include "app/study/stored/stored_histories.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace app {

/// Is in the head of such a table, whatever its intensities are.
inline constexpr std::string_view kHistorySummaryMark =
    ",histories,failed,median drift [%],median residual [%],fell,";

struct HistorySummary {
    Table table; ///< a row for each stress and intensity
    std::string remarks;
    std::size_t failed = 0;
};

[[nodiscard]] HistorySummary history_summary(const StoredHistories& all);

} // namespace app
