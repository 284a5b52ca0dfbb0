#include "app/study/stored/numbered_walls.hpp"

#include "app/input/study/units.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/study/pushed/drawn_wall.hpp"
#include "app/text/words.hpp"

namespace app {

int level_of(const LoadInput& load, const std::string& text)
{
    const std::vector<double>& all = load.vertical_stress;
    if (text.empty() && all.size() == 1) return 0;
    if (text.empty())
        throw ConfigError("drystone", 0, "--level",
                          "missing; write one of " + format_quantities(all, "MPa"));
    try {
        const bool bare = text.find_first_not_of("0123456789.") == std::string::npos;
        return level_at(load, bare ? text + " MPa" : text);
    } catch (const BadValue& bad) {
        throw ConfigError("drystone", 0, "--level", bad.what());
    }
}

std::vector<WantedWall> numbered_walls(const PreparedStudy& ready, const WallChoice& choice)
{
    const Study& study = ready.study;
    if (!study.uq.drawn.empty()) {
        if (choice.sample || choice.mean || !choice.level.empty())
            throw error_at(study.source, "uq.drawn",
                           "names the wall that is pushed; remove it, or --sample and --level");
        return {drawn_wall(ready)};
    }
    if (!study.random.empty() && !choice.mean)
        throw error_at(
            study.source, study.random.front().key,
            "is a distribution, but a push takes numbers; write --sample 0 for the "
            "first wall of the study, --sample mean for that of the means, or --set " +
                study.random.front().key + "=...");
    if (has_layouts(study.geometry) && !choice.mean)
        throw error_at(study.source, "wall.layouts",
                       "a push takes one layout; write --sample 0 for the first wall of "
                       "the study, --sample mean for the layout of wall.seed, or --set "
                       "wall.layouts=1");
    if (!choice.level.empty()) return {{level_of(study.load, choice.level), {}}};
    std::vector<WantedWall> all;
    for (std::size_t i = 0; i < study.load.vertical_stress.size(); ++i)
        all.push_back({static_cast<int>(i), {}});
    return all;
}

} // namespace app
