#include "app/push/test_curve.hpp"

#include "app/text/config_error.hpp"
#include "app/text/csv.hpp"
#include "app/text/measured_table.hpp"
#include "app/text/text_file.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {
namespace {

struct MeasuredColumn {
    std::size_t index = 0;
    double si = 1.0;
};

std::string heads_in(const Csv& csv, std::span<const MeasuredColumn> columns)
{
    std::string heads;
    for (const MeasuredColumn& c : columns)
        heads += (heads.empty() ? "\"" : ", \"") + csv.head[c.index] + "\"";
    return heads;
}

[[noreturn]] void refuse(const Csv& csv, int line, std::string_view quantity,
                         const std::string& units, std::span<const MeasuredColumn> found)
{
    std::vector<MeasuredColumn> all(csv.head.size());
    bool drift = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].index = i;
        drift = drift || unit_of(csv.head[i]) == "%";
    }
    const std::string in_units = std::string(quantity) + " in " + units + " among ";
    throw ConfigError(
        csv.path, line, "",
        (found.empty() ? "has no column of the " + in_units + heads_in(csv, all)
                       : "several columns may be the " + in_units + heads_in(csv, found)) +
            "; name it as in \"displacement_mm,force_kN\" or \"displacement [m],force [N]\"" +
            (drift ? ", a drift in % times the height of the force" : "") +
            (all.size() == 1 ? ", between commas, semicolons or tabs" : ""));
}

/// The column that is called as the quantity, in the first unit that there is, or else the only
/// one in its units.
MeasuredColumn measured_column(const Csv& csv, int line, std::string_view quantity,
                               std::span<const MeasuredUnit> units, const std::string& names)
{
    std::vector<MeasuredColumn> found;
    for (const MeasuredUnit& unit : units)
        for (std::size_t i = 0; i < csv.head.size(); ++i) {
            if (unit_of(csv.head[i]) != unit.name) continue;
            found.push_back({i, unit.si});
            if (quantity_of(csv.head[i]) == quantity) return found.back();
        }
    if (found.size() != 1) refuse(csv, line, quantity, names, found);
    return found.front();
}

} // namespace

TestCurve read_test_curve(const std::string& path)
{
    constexpr std::size_t kMost = std::size_t{64} << 20;
    const MeasuredTable table =
        measured_table(path, read_bytes(path, kMost, "is larger than 64 MiB",
                                        "give a table with displacement_mm,force_kN"));
    const Csv& csv = table.csv;
    const MeasuredColumn u = measured_column(csv, table.line, "displacement", kMeasuredLengths,
                                             "mm, cm or m"),
                         f = measured_column(csv, table.line, "force", kMeasuredForces,
                                             "kN, N or MN");
    TestCurve curve;
    curve.name = std::filesystem::path(path).stem().string();
    for (const CsvRow& row : csv.rows) {
        curve.displacement.push_back(signed_number_at(csv, row, u.index) * u.si);
        curve.force.push_back(signed_number_at(csv, row, f.index) * f.si);
    }
    if (curve.force.size() < 2)
        throw ConfigError(path, table.line, "", "has fewer than two points; a curve needs two");
    return curve;
}

} // namespace app
