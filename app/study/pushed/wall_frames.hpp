#pragma once
/// Pictures of a wall along its push, for a film.

#include "app/store/store_row.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "dem/solver/push.hpp"

#include <functional>
#include <span>
#include <vector>

namespace app {

struct LoadInput;

constexpr int kFilmFrames = 60; ///< evenly over the way, and the wall before the push
/// Numbers of frames of a push that turns back: so many for each way between two turns, and at
/// most kMostFilmFrames.
constexpr int kFramesOfAWay = 8, kMostFilmFrames = 240;

/// Frames of a film after the wall before the push, and the way between two of them [m].
[[nodiscard]] int film_frames(const LoadInput& load);
[[nodiscard]] double film_step(const LoadInput& load);

/// The same push for its readings alone, without pictures.
[[nodiscard]] dem::PushPlan bare(dem::PushPlan plan);

/// The same push with the frames of a film: the numbers are the same, to the bit.
[[nodiscard]] dem::PushPlan filmed(dem::PushPlan plan, const LoadInput& load);

/// Frames of a filmed push: the snapshots, and the end where none is there.
[[nodiscard]] std::vector<dem::Snapshot> frames_of(dem::PushResult&& result);

/// Takes the frames of a wall that gave a result.
using FrameTaker = std::function<void(WallKey key, dem::FailureMode mode,
                                      std::span<const dem::Snapshot> frames)>;

} // namespace app
