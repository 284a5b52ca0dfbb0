#pragma once
/// Two studies of the same walls, pushed one way and to and fro, side by side.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

namespace bench {

/// Both studies, with the same draws.
struct TwoStudies {
    app::StudyWalls one_way, cyclic;
};

/// Median drift of each limit state, with intervals, and the ratio of the drifts of the same
/// wall.
[[nodiscard]] app::Table limit_table(const TwoStudies& both);

/// Shares of the modes with Wilson's intervals, and mean peak forces.
[[nodiscard]] app::Table share_table(const TwoStudies& both);

} // namespace bench
