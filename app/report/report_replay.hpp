#pragma once
/// Stored walls pushed again, to be shown.

#include "app/input/prepared_study.hpp"
#include "app/report/film_shelf.hpp"
#include "app/report/report_choice.hpp"
#include "app/report/report_film.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace app {

struct Replay {
    WallList walls;
    std::vector<Film> films; ///< of these
    std::size_t pushed = 0;  ///< for these films; the others were on the shelf
    /// How many of the walls pushed again differ from the stored curve or mode.
    std::size_t different = 0;
};

/// Values come from the file, not from the design, so that it need not be the same.
/// @param walls read with Keep::everything
/// @param shelf films of walls that need not be pushed
/// @param seen walls pushed so far, and in all
[[nodiscard]] Replay replay(const PreparedStudy& study, const WallList& walls, int threads,
                            const FilmShelf& shelf,
                            const std::function<void(std::size_t, std::size_t)>& seen);

constexpr std::size_t kFilmEntryBytes = 96; ///< of a film in the page, beside its data

/// Leaves the first films, as many as have room in `bytes` of a page.
/// @param each [bytes] that the page needs for each of them besides
void keep_first(Replay& replay, std::size_t bytes, std::size_t each = 0);

} // namespace app
