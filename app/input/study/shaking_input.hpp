#pragma once
/// How the walls of a study are shaken.

#include <string>

namespace app {

/// Which walls of a study are shaken by which records.
enum class ShakingDesign {
    crossed, ///< each wall by each record
    paired   ///< wall k by record k, and by the first ones again after the last
};

/// Motions of the ground, as text: the verbs shake and study read them
/// (app/shake/shaking_motions.hpp).
struct ShakingInput {
    std::string records;         ///< files and pulses, with commas between; empty: none
    std::string intensities;     ///< of `measure`, with commas between; empty: motions as given
    std::string measure = "pga"; ///< or pgv, sa(T)
    std::string vertical = "none"; ///< a file or a pulse
    double scale = 1.0;            ///< on all motions [-], > 0
    double contact_damping = 0.0;  ///< zeta of dry joints [-], >= 0
    bool push = false;             ///< each wall is pushed as well, for its drift limit
    ShakingDesign design = ShakingDesign::crossed;
};

} // namespace app
