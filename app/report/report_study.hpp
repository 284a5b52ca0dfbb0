#pragma once
/// A stored study as the report reads it: its walls as plain numbers, its inputs in shown units.

#include "app/input/study.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"
#include "app/study/stored_input.hpp"
#include "fragility/curve_reading.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// Numbers of one wall. NaN and not_defined: none.
struct ReportWall {
    WallRow row;
    bool failed = false, rocking = false;
    bool slid = false; ///< whole, along a course; counted as rocking (app/study/mode_rule.hpp)
    double peak = 0.0, peak_at = 0.0;                             ///< [N] [m]
    double ultimate = 0.0, last = 0.0;                            ///< [m]
    fragility::Reading reading = fragility::Reading::not_defined; ///< of `ultimate`
    int cracked = 0;                                              ///< units
};

struct ReportStudy {
    std::string name; ///< of the file, without folder and ending
    StoreHead head;
    std::vector<ReportWall> walls; ///< in the order of their keys
    std::vector<StoredInput> inputs;
    std::size_t missing = 0;    ///< walls of the study that the file has not
    std::optional<Study> study; ///< read back from the stored configuration
    std::string no_study;       ///< why it cannot be
    double height = 1.0;        ///< of the load line [m], for drifts; 1 without `study`
    bool pushed_one_way = true; ///< no target turns back

    /// Walls of a level that gave results.
    [[nodiscard]] std::vector<const ReportWall*> sound(std::size_t level) const;
    /// Name of a level: "0.75 MPa"
    [[nodiscard]] std::string stress_text(std::size_t level) const;
    [[nodiscard]] double stress(std::size_t level) const; ///< [MPa]
};

/// @throws StoreError as StoreReader
[[nodiscard]] ReportStudy read_report_study(const std::filesystem::path& file);

} // namespace app
