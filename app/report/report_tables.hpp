#pragma once
/// Tables of the page, each in the forms in which it is copied.

#include "app/output/table.hpp"
#include "app/report/report_study.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace app {

/// {"id", "title", "caption", "head", "rows", "text", "csv", "markdown", "latex"}
[[nodiscard]] nlohmann::ordered_json table_json(const std::string& id, const std::string& title,
                                                const Table& table);

/// Forces, displacements and shares of each stress, of all walls and of each mode.
[[nodiscard]] Table results_table(const ReportStudy& study);

/// One row per wall, failed ones with their reason.
/// @param listed places in ReportStudy::walls
[[nodiscard]] Table walls_table(const ReportStudy& study,
                                const std::vector<std::size_t>& listed);

} // namespace app
