#include "app/study/answers/mode_share.hpp"

#include <algorithm>

namespace app {

fragility::Share mode_share(const StudyLevel& level, int mode, double confidence,
                            core::BinomialInterval kind)
{
    const auto count = [&](const auto& holds) {
        return static_cast<double>(std::ranges::count_if(level.walls, holds));
    };
    const auto is_of = [&](const StudyWall& w) {
        return mode == kAllModes || mode_of(w) == mode;
    };
    fragility::Undecided standing;
    if (mode != kAllModes)
        standing = {
            count([&](const StudyWall& w) { return is_of(w) && w.reading.mode_so_far; }),
            count([&](const StudyWall& w) { return !is_of(w) && w.reading.mode_so_far; })};
    return fragility::share(count(is_of), static_cast<double>(level.walls.size()),
                            static_cast<double>(level.failed_walls.size()), kind, confidence,
                            standing);
}

} // namespace app
