#pragma once
/// Stored walls with a given reading, for tests of what is made of readings.

#include "app/study/stored/study_walls.hpp"

#include <cstdint>

namespace scenes {

/// One wall that came down at `ultimate` [m], or stood up to there.
inline app::StudyWall read_wall(app::WallKey key, double peak, double ultimate, bool stood,
                                dem::FailureMode mode = dem::FailureMode::mixed)
{
    app::StudyWall w;
    w.key = key;
    w.reading.peak = fragility::Peak{peak, 0.01, false};
    w.reading.ultimate = {
        ultimate, stood ? fragility::Reading::censored : fragility::Reading::observed, {}};
    w.reading.limits = {w.reading.ultimate};
    w.reading.dropped = !stood;
    w.reading.mode = mode;
    return w;
}

/// A level without walls [Pa].
inline app::StudyLevel level(double stress) { return {stress, {}, {}, 0}; }

} // namespace scenes
