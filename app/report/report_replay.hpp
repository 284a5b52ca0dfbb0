#pragma once
/// Stored walls pushed again, to be shown.

#include "app/report/report_film.hpp"
#include "app/report/report_study.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace app {

struct Replay {
    std::vector<std::size_t> walls; ///< places in ReportStudy::walls
    std::vector<Film> films;        ///< of these
    std::size_t different = 0; ///< peak, ultimate displacement or mode are not those stored
};

constexpr int kFilmFrames = 60; ///< evenly over the way, and the wall before the push

/// Values come from the file, not from the design, so that it need not be the same.
/// @param study with its configuration
/// @param seen share done in [0, 1]
[[nodiscard]] Replay replay(const ReportStudy& study, const std::vector<std::size_t>& walls,
                            int threads, const std::function<void(double)>& seen);

constexpr std::size_t kFilmEntryBytes = 80; ///< of a film in the page, beside its data

/// Leaves the first films, as many as have room in `bytes` of a page.
void keep_first(Replay& replay, std::size_t bytes);

} // namespace app
