#pragma once
/// Watches the piers of walls while they are pushed.

#include "app/study/pushed/pier_reading.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "dem/solver/push.hpp"

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace app {

/// Piers of the walls of one push. Does nothing for walls whose piers are not told apart.
class PierWatch {
  public:
    /// Has `plan` take a snapshot at every curve point, and hands those on that it would have
    /// taken. Lives longer than the push. Load and layout must outlive it.
    PierWatch(const Masonry& masonry, const LoadInput& load, PierRules rules,
              const dem::Layout& layout, dem::PushPlan& plan);
    PierWatch(const PierWatch&) = delete;
    PierWatch& operator=(const PierWatch&) = delete;

    /// read_piers() of a wall that is pushed, and the snapshots that no sink took. Once for a
    /// wall; its history is given up.
    void add_to(std::size_t wall, PushedWall& pushed);

  private:
    struct Watched {
        PierHistory history;
        double next = 0.0;               ///< way to the next snapshot that is handed on [m]
        double look = 0.0;               ///< way to the next look at movements [m]
        std::vector<dem::Snapshot> kept; ///< where nobody takes them
    };
    Watched& watched(std::size_t wall);
    PierInstant instant(Watched& w, const dem::Snapshot& shot) const;

    const LoadInput& load_;
    PierRules rules_;
    double drop_; ///< as PushPlan::drop
    std::optional<dem::PierProbe> probe_;
    std::mutex mutex_;                     ///< of the map; each wall is of one thread
    std::map<std::size_t, Watched> walls_; ///< that are on their way
};

} // namespace app
