#include "app/study/pushed/pushed_limits.hpp"

#include "app/input/prepared_study.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/sampling/wall_draw.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "dem/block/model.hpp"

#include <cmath>

namespace app {

std::map<WallKey, double> pushed_limits(const PreparedStudy& ready, const SamplePlan& samples,
                                        const std::vector<WallKey>& walls, int threads)
{
    std::map<WallKey, double> limits;
    PushList list;
    list.size = walls.size();
    list.wall = [&](std::size_t i) -> std::optional<WantedWall> {
        WantedWall wanted;
        wanted.level = static_cast<int>(walls[i].level);
        wanted.draw = draw(samples, wanted.level, static_cast<int>(walls[i].sample));
        return wanted;
    };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        const double limit = value(wall_number("ultimate_drift"), source_of(wall));
        if (std::isfinite(limit) && limit > 0.0) limits.emplace(walls[i], limit);
    };
    push_walls(ready.study, model_of(ready), push_plan(ready.study), list, threads);
    return limits;
}

} // namespace app
