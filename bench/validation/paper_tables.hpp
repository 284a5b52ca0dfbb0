#pragma once
/// Results of the paper, Tables 6 to 8 and the shares of section 4.2 and 5.

#include <array>
#include <optional>

namespace bench {

struct PaperMode {
    double friction_deg = 0.0; ///< mean joint friction angle; 0: not given
    double strength_MPa = 0.0; ///< mean tensile strength of the units; 0: not given
    double peak_kN = 0.0;
    double displacement_mm = 0.0; ///< rocking: where the runs stopped; mixed: drop to 80 %
};

struct PaperLevel {
    double stress_MPa = 0.0;
    int walls = 0;
    int rocking_walls = 0;
    PaperMode rocking;
    std::optional<PaperMode> mixed;
};

inline constexpr std::array kPaperLevels = {
    PaperLevel{0.15, 50, 50, {31.80, 3.69, 16.24, 27.54}, {}},
    PaperLevel{0.50, 50, 14, {38.13, 3.86, 47.71, 28.08}, PaperMode{29.41, 3.62, 45.90, 18.34}},
    PaperLevel{0.75, 50, 17, {38.09, 3.66, 69.51, 28.21}, PaperMode{28.72, 3.71, 63.89, 19.47}},
    PaperLevel{1.00, 50, 14, {38.36, 4.53, 91.58, 28.24}, PaperMode{29.57, 3.44, 80.97, 17.93}},
    PaperLevel{
        1.25, 50, 4, {39.05, 4.45, 112.13, 27.96}, PaperMode{31.17, 3.63, 100.72, 16.26}}};

/// Table 8, 0.75*: a value for each joint.
inline constexpr PaperLevel kPaperSpatial = {
    0.75, 100, 12, {0, 0, 63.17, 28.80}, PaperMode{0, 0, 57.29, 17.00}};

/// Tests at the same stress (Lourenço et al. 2005, curves in bench/tested/measured_walls.hpp)
/// [kN]; 0: none.
struct TestMeans {
    double stress_MPa;
    double peak_kN;
    int walls;
};
inline constexpr std::array kTestMeans = {TestMeans{0.15, 22.1, 2}, TestMeans{0.50, 44.9, 2},
                                          TestMeans{1.00, 70.4, 2}, TestMeans{1.25, 102.5, 1}};

/// Mean peak of all walls [kN].
constexpr double pooled_peak(const PaperLevel& p)
{
    const double r = static_cast<double>(p.rocking_walls) / p.walls;
    return r * p.rocking.peak_kN + (p.mixed ? (1.0 - r) * p.mixed->peak_kN : 0.0);
}

} // namespace bench
