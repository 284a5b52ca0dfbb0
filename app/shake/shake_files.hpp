#pragma once
/// The files of one history of a wall on ground that moves.

#include "app/output/result_folder.hpp"
#include "app/shake/shaking_motions.hpp"
#include "dem/shaking/shake.hpp"

#include <string>
#include <vector>

namespace app {

struct ShakenWall {
    ShakingMotion motion;
    dem::ShakeResult result;
    dem::LoadMass load = dem::LoadMass::none;
    double vertical_stress = 0.0; ///< [Pa]
};

/// Whether the numbers of the history broke, or the wall did not stand at rest.
[[nodiscard]] bool shake_failed(const dem::ShakeResult& result);

/// Largest |acceleration| of the ground [g].
[[nodiscard]] double peak_ground_g(const ShakenWall& wall);

/// Text of summary.json. @param study as shake_files
[[nodiscard]] std::string shaken_summary(const ShakenWall& wall, const std::string& study);

/// @param study text of study.ini
/// @param film empty: none
[[nodiscard]] std::vector<OutputFile> shake_files(const ShakenWall& wall,
                                                  const std::string& study,
                                                  const std::string& wall_picture,
                                                  const std::string& film = {});

} // namespace app
