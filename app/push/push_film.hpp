#pragma once
/// Frames of a push for film.svg, taken beside the series for ParaView.

#include "app/study/pushed/pushed_wall.hpp"
#include "dem/solver/push.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace app {

struct LoadInput;

class PushFilm {
  public:
    /// Sets how often `plan` takes snapshots where it takes none, and puts itself before its
    /// sink. Lives longer than the push.
    PushFilm(const LoadInput& load, std::size_t walls, dem::PushPlan& plan);

    /// film.svg of a wall whose push gave a result.
    [[nodiscard]] std::string film(const dem::Layout& layout, std::size_t wall,
                                   const PushedWall& pushed) const;

    /// The same as pictures.
    [[nodiscard]] std::vector<std::string> stills(const dem::Layout& layout, std::size_t wall,
                                                  const PushedWall& pushed) const;

  private:
    struct Taken {
        std::size_t seen = 0;
        std::vector<dem::Snapshot> frames;
    };
    [[nodiscard]] std::vector<dem::Snapshot> frames_of(std::size_t wall,
                                                       const PushedWall& pushed) const;
    std::vector<Taken> walls_;
    std::size_t every_ = 1; ///< of the snapshots that are taken
};

} // namespace app
