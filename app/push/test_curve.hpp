#pragma once
/// A measured curve, from a table of displacements and forces.

#include <string>
#include <vector>

namespace app {

struct TestCurve {
    std::string name; ///< of its file, without ending
    std::vector<double> displacement,
        force; ///< [m] [N], as measured, equally long, two or more
};

/// Reads a CSV with the columns displacement_mm and force_kN, as capacity.csv has them, also
/// written "displacement [mm]" or "displacement (mm)", in mm, cm or m, and in kN, N or MN.
/// Further columns are left alone.
/// @throws ConfigError naming the line
[[nodiscard]] TestCurve read_test_curve(const std::string& path);

} // namespace app
