#include "app/push/test_curve.hpp"

#include "app/text/config_error.hpp"
#include "app/text/csv.hpp"
#include "app/text/text_file.hpp"

#include <array>
#include <filesystem>
#include <string_view>

namespace app {
namespace {

/// The column that has one of these heads.
std::size_t column_of(const Csv& csv, std::string_view quantity,
                      const std::array<std::string_view, 3>& heads)
{
    for (const std::string_view head : heads)
        for (std::size_t i = 0; i < csv.head.size(); ++i)
            if (csv.head[i] == head) return i;
    throw ConfigError(csv.path, 1, "",
                      "has no column of the " + std::string(quantity) +
                          "; name it as in \"displacement_mm,force_kN\"");
}

} // namespace

TestCurve read_test_curve(const std::string& path)
{
    constexpr std::size_t kMost = std::size_t{64} << 20;
    const Csv csv = parse_csv(path, read_bytes(path, kMost, "is larger than 64 MiB",
                                               "give a table with displacement_mm,force_kN"));
    const std::size_t u = column_of(
        csv, "displacement", {"displacement_mm", "displacement [mm]", "displacement (mm)"});
    const std::size_t f = column_of(csv, "force", {"force_kN", "force [kN]", "force (kN)"});
    TestCurve curve;
    curve.name = std::filesystem::path(path).stem().string();
    for (const CsvRow& row : csv.rows) {
        curve.displacement.push_back(signed_number_at(csv, row, u) * 1e-3);
        curve.force.push_back(signed_number_at(csv, row, f) * 1e3);
    }
    if (curve.force.size() < 2)
        throw ConfigError(path, 1, "", "has fewer than two points; a curve needs two");
    return curve;
}

} // namespace app
