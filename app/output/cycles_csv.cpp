#include "app/output/cycles_csv.hpp"

#include "app/output/cycle_columns.hpp"
#include "app/text/number_text.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace app {
namespace {

constexpr int kDigits = 9; // as in capacity.csv

} // namespace

std::string cycles_csv(const std::vector<fragility::Cycle>& cycles,
                       std::span<const dem::CurvePoint> curve)
{
    std::vector<CycleColumn> columns = cycle_columns(cycles, curve);
    const bool loses = !curve.empty() && curve.back().energy.closing > 0.0;
    std::erase_if(columns, [=](const CycleColumn& c) { return c.name == "closing" && !loses; });
    std::string table;
    const auto separator = [&](const CycleColumn& c) {
        return &c == &columns.front() ? "" : ",";
    };
    for (const CycleColumn& c : columns) {
        table += separator(c) + std::string(c.name);
        if (!c.unit.empty()) table += "_" + std::string(c.unit);
    }
    table += '\n';
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        for (const CycleColumn& c : columns) {
            table += separator(c);
            if (c.values[i]) table += number(*c.values[i] * c.scale, kDigits);
        }
        table += '\n';
    }
    return table;
}

} // namespace app
