#pragma once
/// Numbers of the seven tests of Lourenço et al. (2005) that the walls with mean values are
/// compared with.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bench {

struct TestedWall {
    std::string name;        ///< "SW.100.1"
    double stress_MPa = 0.0; ///< vertical
    double peak_kN = 0.0;
    double drop_mm =
        0.0; ///< first drop to 80 % of the peak; if it is not reached, where the test ended
    bool dropped = true;
    double secant_30 = 0.0,
           secant_60 = 0.0; ///< where 30 and 60 % of the peak are first reached [kN/mm]
};

/// Read off the curves of bench/tested/measured_walls.hpp. Without their folder: the numbers
/// that were read off them before.
/// @throws std::runtime_error if the folder or one of its files cannot be read
[[nodiscard]] std::vector<TestedWall>
tested_walls(const std::optional<std::filesystem::path>& curves);

} // namespace bench
