#include "bench/joint_laws/tested_walls.hpp"

#include "bench/tested/comparison.hpp"
#include "bench/tested/measured_walls.hpp"
#include "fragility/curve/curve_reading.hpp"

namespace bench {

std::vector<TestedWall> tested_walls(const std::optional<std::filesystem::path>& curves)
{
    if (!curves)
        return {{"SW.30.1", 0.15, 21.5, 29.85, false, 12.06, 6.21},
                {"SW.30.2", 0.15, 22.7, 9.37, true, 11.16, 7.47},
                {"SW.100.1", 0.50, 41.5, 12.59, true, 21.22, 14.76},
                {"SW.100.2", 0.50, 48.2, 18.88, true, 11.954, 11.18},
                {"SW.200.1", 1.00, 72.2, 16.08, true, 31.12, 21.36},
                {"SW.200.2", 1.00, 68.6, 22.65, false, 20.07, 13.90},
                {"SW.250.1", 1.25, 102.5, 9.28, true, 50.41, 32.54}};
    std::vector<TestedWall> walls;
    for (const StressLevel& level : kLevels)
        for (const MeasuredWall& w : read_series(*curves, level.series)) {
            const CurveFacts f = facts(w.name, w.table);
            const auto secant = [&](double share) {
                return fragility::secant_stiffness(w.table.curve(), share).value_or(0.0);
            };
            walls.push_back({w.name, level.stress_MPa, f.peak_kN, f.ultimate_mm.displacement,
                             fragility::is_observed(f.ultimate_mm), secant(0.30),
                             secant(0.60)});
        }
    return walls;
}

} // namespace bench
