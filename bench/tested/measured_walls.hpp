#pragma once
/// The seven walls of Lourenço, Oliveira, Roca, Orduña (2005), J. Struct. Eng. 131(11), as
/// digitised in the EPFL Stone Masonry Database (Vanin, Zaganelli, Penna, Beyer 2017;
/// doi 10.5281/zenodo.812145, folder of force-displacement files). The curves are not part of
/// this program: get them there and name their folder.

#include "bench/tested/curve_table.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

/// A vertical stress level: the wall is 1.00 m x 0.20 m, so that 30 kN are 0.15 MPa.
struct StressLevel {
    std::string_view folder; ///< as `drystone push` names it
    double stress_MPa = 0.0;
    std::string_view series; ///< of the tests, the vertical load in kN; empty: not tested
};

inline constexpr std::array kLevels = {
    StressLevel{"0.15_MPa", 0.15, "30"}, StressLevel{"0.50_MPa", 0.50, "100"},
    StressLevel{"0.75_MPa", 0.75, ""}, StressLevel{"1.00_MPa", 1.00, "200"},
    StressLevel{"1.25_MPa", 1.25, "250"}};

struct MeasuredWall {
    std::string name; ///< "SW.100.2"
    CurveTable table; ///< never backwards
};

/// The walls of one series, in order: FD_SW<series><number>_*.csv of `folder`.
/// @throws std::runtime_error if the folder or one of its files cannot be read
[[nodiscard]] std::vector<MeasuredWall> read_series(const std::filesystem::path& folder,
                                                    std::string_view series);

} // namespace bench
