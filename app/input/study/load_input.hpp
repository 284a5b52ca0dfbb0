#pragma once
/// The loads of a study, and the way that its walls are pushed.

#include "app/input/study/parameters.hpp"
#include "dem/shaking/load_mass.hpp"
#include "dem/solver/cyclic_protocol.hpp"
#include "dem/solver/push.hpp"

#include <string>
#include <vector>

namespace app {

/// Where a wall is pushed; `left` mirrors all displacements of the push.
enum class Direction {
    right,
    left,
    both ///< each wall once to either side where the mirrored wall is another one, else right
};

struct LoadInput {
    std::vector<double> vertical_stress; ///< stress levels [Pa], >= 0, at least one
    double height =
        0.0; ///< of the horizontal load, or of the resultant of body forces, above the floor [m]
    /// Why the height that was given cannot be, in a study read to be drawn: `height` is its
    /// default then.
    std::string unfit_height;
    double max_displacement = dem::PushPlan{}.targets.front(); ///< of the load line [m], > 0
    std::vector<double>
        targets; ///< displacements visited in order [m]; empty: max_displacement
    std::vector<double> amplitudes; ///< of cycles, in order [m], > 0; empty: no cycles
    int repeats = 1;                ///< cycles of each amplitude, >= 1
    dem::Protocol protocol =
        dem::Protocol::none;    ///< none: one way, or as amplitudes or targets say
    bool scale_one_way = false; ///< of the protocol, see app/input/protocol_scale.hpp
    std::string
        scaled; ///< the ultimate displacements behind the scaled protocol, as text; empty: not scaled
    double gravity = dem::Loads{}.gravity; ///< [m/s2], >= 0
    /// Share of the peak that ends the push [-], in [0, 1); 0: zero force with finite
    /// displacements, never with small ones. See app/input/keys/push_end.hpp.
    double stop_below = 0.0;
    dem::TopLoad top = dem::Loads{}.top;
    double link_length = dem::Loads{}.link_length; ///< [m], of TopLoad::link
    dem::LoadPattern pattern = dem::Loads{}.pattern;
    dem::LoadMass mass = dem::LoadMass::none; ///< of a wall that is shaken
    Direction direction = Direction::both;
};

/// @param level index in load.vertical_stress
[[nodiscard]] StressLevel stress_level(const LoadInput& load, int level);

/// @param level index in load.vertical_stress
[[nodiscard]] dem::Loads loads(const LoadInput& load, int level);

/// Displacements visited in order [m].
[[nodiscard]] std::vector<double> push_targets(const LoadInput& load);

/// Where a push goes.
struct PushWay {
    int direction = 1;     ///< 1: to the right, -1: to the left, 0: it turns back
    double farthest = 0.0; ///< largest distance from the start [m]
    double length = 0.0;   ///< of the whole way [m]
    int turns = 0;
};
[[nodiscard]] PushWay push_way(const LoadInput& load);

} // namespace app
