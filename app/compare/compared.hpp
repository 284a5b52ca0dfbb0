#pragma once
/// Walls side by side, whatever they come from: a stored study, a push, a measured curve.

#include "app/output/table/table.hpp"

#include <string>
#include <vector>

namespace app {

/// One row of the comparison, and one line of its chart.
struct Compared {
    std::string name;
    Row cells;                               ///< as the columns of compared_table, without name
    double peak = kUnknown;                  ///< [N], of a study the mean
    bool measured = false;                   ///< in a laboratory
    double stress = kUnknown;                ///< [Pa]; NaN: not known
    std::vector<double> displacement, force; ///< [m] [N]; of a study the mean of its walls
    std::string note; ///< one sentence on how a measured curve was read; empty: as it stands
};

/// Displacements of a measurement below this share of the farthest one may be noise [-], a free
/// choice.
constexpr double kNoise = 0.05;

/// Whether the path turns back by more than noise of a measured displacement does.
[[nodiscard]] bool goes_to_and_fro(const Compared& c);

/// Reads FILE.h5 (a row for each stress), the folder of a push, or a table of a measured curve
/// (.csv, .txt, .tsv). A measured force against the displacement is turned round, with a note.
/// The folder of `fragility` has no curves and gives nothing (compared_limits.hpp).
/// @throws ConfigError, StoreError
[[nodiscard]] std::vector<Compared> read_compared(const std::string& path);

/// One row for each; the last column relates peaks to the first row of the same stress, or to
/// the first of all.
[[nodiscard]] Table compared_table(const std::vector<Compared>& all);

/// SVG: all curves in one picture.
[[nodiscard]] std::string compared_chart(const std::vector<Compared>& all);

} // namespace app
