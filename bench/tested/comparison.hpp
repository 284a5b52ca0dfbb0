#pragma once
/// Our capacity curve beside the measured ones and the paper's numbers, one stress level at a
/// time.

#include "bench/tested/curve_table.hpp"
#include "bench/tested/measured_walls.hpp"
#include "fragility/curve/curve_reading.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bench {

/// Means of the paper's 50 random walls of a stress level (Tables 6 and 7). Its deterministic
/// curves (Fig. 6) are drawn without numbers.
struct PaperMeans {
    double rocking_share = 0.0;          ///< of the walls, section 4.2
    double rocking_peak_kN = 0.0;        ///< Table 6
    std::optional<double> mixed_peak_kN; ///< Table 7
    /// Table 7; the displacements of Table 6 are where the runs stopped, near 28 mm.
    std::optional<double> mixed_ultimate_mm;
};

/// Nothing for a stress level the paper does not have.
[[nodiscard]] std::optional<PaperMeans> paper_means(double stress_MPa);

/// Mean peak of all walls of a level: both modes, weighted by their shares [kN].
[[nodiscard]] double pooled_peak_kN(const PaperMeans& paper);

/// Facts that a table states about one curve.
struct CurveFacts {
    std::string name;
    double peak_kN = 0.0;
    fragility::LimitDisplacement ultimate_mm; ///< first drop to 80 % of the peak
};

[[nodiscard]] CurveFacts facts(const std::string& name, const CurveTable& table);

struct LevelComparison {
    double stress_MPa = 0.0;
    CurveFacts ours;
    std::vector<CurveFacts> tests; ///< may be empty
};

/// Mean peak of the tests of a level [kN]; nothing without tests.
[[nodiscard]] std::optional<double> mean_peak_kN(const LevelComparison& level);

/// Two tables, peak force and ultimate displacement, a row per stress level. "> 29.85": not
/// reached by 29.85 mm.
[[nodiscard]] std::string comparison_markdown(std::span<const LevelComparison> levels);

/// A row per stress level and source; empty cells where a source has no number.
[[nodiscard]] std::string comparison_csv(std::span<const LevelComparison> levels);

} // namespace bench
