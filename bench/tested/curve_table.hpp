#pragma once
/// Force-displacement curves as comma-separated files: ours, and the measured ones.

#include "fragility/curve/curve_reading.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

struct CurveTable {
    std::vector<double> displacement_mm;
    std::vector<double> force_kN;

    [[nodiscard]] fragility::Curve curve() const { return {displacement_mm, force_kN}; }
};

/// Two columns of a comma-separated file, found by their names. Lines above the names, and one
/// line of units in brackets below them, are passed over.
/// @throws std::runtime_error `file:line: reason` for an unreadable file, missing columns, or a
/// value that is not a finite number
[[nodiscard]] CurveTable read_curve_table(const std::filesystem::path& file,
                                          std::string_view displacement_column,
                                          std::string_view force_column);

/// capacity.csv as `drystone push` writes it.
/// @throws std::runtime_error also if the displacement is negative or decreases
[[nodiscard]] CurveTable read_capacity_curve(const std::filesystem::path& file);

/// Without the points that lie behind an earlier one: digitised curves go back by a line width
/// here and there.
[[nodiscard]] CurveTable never_backwards(const CurveTable& table);

} // namespace bench
