#pragma once
/// Films of the walls of a run, at hand for the page that follows it.

#include "app/report/report_film.hpp"
#include "app/store/store_row.hpp"
#include "dem/scene/mechanism/mechanism.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <utility>

namespace app {

/// Keeps the films of the lowest sample numbers of each stress and mode, as many as a page
/// could have room for: those that walls_to_show can choose.
class FilmShelf {
  public:
    /// Each wall once.
    void put(WallKey key, dem::FailureMode mode, std::span<const dem::Snapshot> frames);

    /// nullptr: not here
    [[nodiscard]] const Film* find(WallKey key) const;

  private:
    using Samples = std::map<std::uint32_t, Film>;
    std::map<std::pair<std::uint32_t, dem::FailureMode>, Samples> films_; ///< by level and mode
};

} // namespace app
