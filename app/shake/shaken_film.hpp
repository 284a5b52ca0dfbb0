#pragma once
/// film.svg of a wall on ground that moves.

#include "app/output/picture/wall_body.hpp"
#include "app/shake/shake_files.hpp"

#include <string>

namespace app {

/// Time between the frames of a film [s].
constexpr double kShakenFrame = 0.05; // choice: twenty in a second

/// The history in real time, or so much of it around its largest displacement that the file
/// stays below some 2 MB. Empty where it has no two frames.
/// @param shaken its snapshots are kShakenFrame apart
[[nodiscard]] std::string shaken_film(const ShakenWall& shaken, const StoneTints& tints);

} // namespace app
