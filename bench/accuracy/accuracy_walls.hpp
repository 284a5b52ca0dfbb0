#pragma once
/// Walls of the accuracy campaign, as the section [wall] of a study.

#include "bench/draw.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bench {

struct DrawnWall {
    std::string kind;                  ///< "courses", "opening", "drawing", "arch", "rubble"
    std::string keys;                  ///< of the section [wall]
    double length = 0.0, height = 0.0; ///< [m]
    double unit = 0.0;                 ///< length of a unit [m]; 0: the wall has no units
    double course_height = 0.0;        ///< of a course, or of a mean stone [m]
    double thickness = 0.0;            ///< [m]
    int stones = 0;                    ///< roughly
};

/// Form that a wall is to have, whatever its size.
struct WallForm {
    std::string kind;    ///< of DrawnWall; half of them are "courses"
    int courses = 0;     ///< of "courses", 1 to 40; most have few
    double aspect = 0.0; ///< of "courses", height over length, 0.3 to 6
};
[[nodiscard]] WallForm draw_form(Draw& d);

/// Most walls have fewer than 40 stones.
[[nodiscard]] DrawnWall draw_wall(const WallForm& form, Draw& d);

/// "0.125000"
[[nodiscard]] std::string metres(double x);

struct Corner {
    double x = 0.0, z = 0.0; ///< [m]
};

/// Stones of an arch, semicircular, segmental or pointed, with or without piers.
[[nodiscard]] DrawnWall draw_arch(Draw& d);

/// Keys of a wall that is drawn: moves the outlines to x >= 0.
/// @param decimals of the corners; many where one lies on a sloping side of a neighbour
[[nodiscard]] DrawnWall drawn_wall_of(std::string_view kind,
                                      std::vector<std::vector<Corner>> stones, double thickness,
                                      int decimals = 6);

} // namespace bench
