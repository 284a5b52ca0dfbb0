#include "app/push/test_curve.hpp"

#include "app/text/config_error.hpp"
#include "app/text/csv.hpp"
#include "app/text/text_file.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace app {
namespace {

struct MeasuredUnit {
    std::string_view name;
    double si; ///< its value in SI units
};
constexpr std::array kLengths = {MeasuredUnit{"mm", 1e-3}, MeasuredUnit{"cm", 1e-2},
                                 MeasuredUnit{"m", 1.0}};
constexpr std::array kForces = {MeasuredUnit{"kN", 1e3}, MeasuredUnit{"N", 1.0},
                                MeasuredUnit{"MN", 1e6}};

struct MeasuredColumn {
    std::size_t index = 0;
    double si = 1.0;
};

bool is_head(std::string_view head, std::string_view quantity, std::string_view unit)
{
    const std::string q(quantity), u(unit);
    return head == q + "_" + u || head == q + " [" + u + "]" || head == q + " (" + u + ")";
}

/// The column of a quantity in one of these units, the first of which is looked for first.
MeasuredColumn measured_column(const Csv& csv, std::string_view quantity,
                               std::span<const MeasuredUnit> units)
{
    std::string names, heads;
    for (const MeasuredUnit& unit : units) {
        for (std::size_t i = 0; i < csv.head.size(); ++i)
            if (is_head(csv.head[i], quantity, unit.name)) return {i, unit.si};
        names += (names.empty()                    ? ""
                  : unit.name == units.back().name ? " or "
                                                   : ", ") +
                 std::string(unit.name);
    }
    for (const std::string& head : csv.head)
        heads += (heads.empty() ? "\"" : ", \"") + head + "\"";
    throw ConfigError(csv.path, 1, "",
                      "has no column of the " + std::string(quantity) + " in " + names +
                          " among " + heads +
                          "; name it as in \"displacement_mm,force_kN\" or \"displacement "
                          "[m],force [N]\"");
}

} // namespace

TestCurve read_test_curve(const std::string& path)
{
    constexpr std::size_t kMost = std::size_t{64} << 20;
    const Csv csv = parse_csv(path, read_bytes(path, kMost, "is larger than 64 MiB",
                                               "give a table with displacement_mm,force_kN"));
    const MeasuredColumn u = measured_column(csv, "displacement", kLengths),
                         f = measured_column(csv, "force", kForces);
    TestCurve curve;
    curve.name = std::filesystem::path(path).stem().string();
    for (const CsvRow& row : csv.rows) {
        curve.displacement.push_back(signed_number_at(csv, row, u.index) * u.si);
        curve.force.push_back(signed_number_at(csv, row, f.index) * f.si);
    }
    if (curve.force.size() < 2)
        throw ConfigError(path, 1, "", "has fewer than two points; a curve needs two");
    return curve;
}

} // namespace app
