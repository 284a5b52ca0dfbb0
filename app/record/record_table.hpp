#pragma once
/// Records and pulses beside each other: what was read, and their measures of intensity.

#include "app/output/table/table.hpp"
#include "ground/intensity.hpp"
#include "ground/record.hpp"

#include <vector>

namespace app {

/// Sa at 0.2, 0.5, 1 and 2 s; peaks, duration, Arias intensity and CAV have columns of their
/// own.
[[nodiscard]] std::vector<ground::Measure> usual_measures();

[[nodiscard]] Table record_table(const std::vector<ground::Record>& records,
                                 const std::vector<ground::Measure>& measures);

/// Periods [s] at which spectra are shown.
[[nodiscard]] std::vector<double> spectrum_periods();

/// Pseudo-accelerations at 5 % of damping [g], a column for each motion.
[[nodiscard]] Table spectrum_table(const std::vector<ground::Record>& records,
                                   const std::vector<std::vector<double>>& spectra);

} // namespace app
