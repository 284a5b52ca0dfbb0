#include "bench/tested/curve_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <stdexcept>

namespace bench {
namespace {

std::vector<std::string_view> cells(std::string_view line)
{
    if (line.ends_with('\r')) line.remove_suffix(1);
    std::vector<std::string_view> out;
    for (;;) {
        const std::size_t comma = line.find(',');
        out.push_back(line.substr(0, comma));
        if (comma == std::string_view::npos) return out;
        line.remove_prefix(comma + 1);
    }
}

[[noreturn]] void refuse(const std::filesystem::path& file, int line, const std::string& reason)
{
    throw std::runtime_error(file.string() + (line > 0 ? ":" + std::to_string(line) : "") +
                             ": " + reason);
}

std::size_t position(const std::vector<std::string_view>& names, std::string_view name)
{
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

double finite_number(std::string_view cell, const std::filesystem::path& file, int line)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
        refuse(file, line, "'" + std::string(cell) + "' is not a finite number");
    return value;
}

} // namespace

CurveTable read_curve_table(const std::filesystem::path& file,
                            std::string_view displacement_column, std::string_view force_column)
{
    std::ifstream in(file);
    if (!in) refuse(file, 0, "cannot be read");
    CurveTable table;
    std::string text;
    std::size_t d = 0, f = 0;
    int named_at = 0;
    for (int line = 1; std::getline(in, text); ++line) {
        const std::vector<std::string_view> row = cells(text);
        if (named_at == 0) {
            d = position(row, displacement_column);
            f = position(row, force_column);
            if (d < row.size() && f < row.size()) named_at = line;
            continue;
        }
        if (line == named_at + 1 && text.starts_with('[')) continue;
        if (std::max(d, f) >= row.size()) refuse(file, line, "too few columns");
        table.displacement_mm.push_back(finite_number(row[d], file, line));
        table.force_kN.push_back(finite_number(row[f], file, line));
    }
    if (table.force_kN.empty())
        refuse(file, named_at,
               "no points below the columns " + std::string(displacement_column) + " and " +
                   std::string(force_column));
    return table;
}

CurveTable read_capacity_curve(const std::filesystem::path& file)
{
    CurveTable table = read_curve_table(file, "displacement_mm", "force_kN");
    try {
        fragility::check(table.curve());
    } catch (const std::invalid_argument& e) {
        throw std::runtime_error(file.string() + ": " + e.what());
    }
    return table;
}

CurveTable never_backwards(const CurveTable& table)
{
    CurveTable out;
    for (std::size_t i = 0; i < table.force_kN.size(); ++i) {
        if (i > 0 && table.displacement_mm[i] < out.displacement_mm.back()) continue;
        out.displacement_mm.push_back(table.displacement_mm[i]);
        out.force_kN.push_back(table.force_kN[i]);
    }
    return out;
}

} // namespace bench
