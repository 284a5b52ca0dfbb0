#pragma once
/// Stored walls pushed again, to be shown.

#include "app/report_film.hpp"
#include "app/report_study.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// Walls that are shown where nothing else is asked for: all of a study whose walls have, together,
/// no more blocks than this. 300 walls of the paper are about 3 MB.
constexpr std::size_t kMostFilmedBlocks = 32'000;

/// Places in ReportStudy::walls, ascending, of at most `most` walls that gave results: taken in turns
/// from each stress and mode in the order of the samples, so that rare modes are among them.
[[nodiscard]] std::vector<std::size_t> walls_to_show(const ReportStudy& study,
                                                     std::size_t most);

struct Replay {
    std::vector<std::size_t> walls; ///< places in ReportStudy::walls, ascending
    std::vector<Film> films;        ///< of these
    std::size_t different = 0; ///< peak, ultimate displacement or mode are not those stored
};

constexpr int kFilmFrames = 60; ///< evenly over the way, and the wall before the push

/// Values come from the file, not from the design, so that it need not be the same.
/// @param study with its configuration
/// @param seen share done in [0, 1]
[[nodiscard]] Replay replay(const ReportStudy& study, const std::vector<std::size_t>& walls,
                            int threads, const std::function<void(double)>& seen);

} // namespace app
