#pragma once
/// Tables of docs/joint_laws.md.

#include "app/output/table/table.hpp"
#include "bench/joint_laws/law_studies.hpp"
#include "bench/joint_laws/tested_walls.hpp"

#include <span>
#include <string>
#include <vector>

namespace bench {

/// A study under the name that tables give it.
struct NamedStudy {
    std::string name;
    LawStudy study;
};
using NamedStudies = std::vector<NamedStudy>;

/// A number that a wall with mean values has, and that tests have.
enum class WallNumber { peak, drop, secant_30, secant_60 };

/// Random walls: forces, modes, drift limits and cost, by stress and study.
[[nodiscard]] app::Table random_walls(const NamedStudies& studies);

/// Each random wall against the same wall with the first study's laws: ratios of peaks and of
/// 80 % drops.
[[nodiscard]] app::Table wall_by_wall(const NamedStudies& studies);

/// One number of walls with mean values, a row per study and a column per stress; above them
/// the tests, if given.
[[nodiscard]] app::Table mean_walls(const NamedStudies& studies, WallNumber number,
                                    std::span<const TestedWall> tests = {});

/// Equivalent viscous damping [%] of each cycle of the first wall of each study, and its peak
/// force.
[[nodiscard]] app::Table damping_of_cycles(const NamedStudies& studies);

/// Stresses of the studies [Pa], ascending.
[[nodiscard]] std::vector<double> stresses_of(const NamedStudies& studies);

} // namespace bench
