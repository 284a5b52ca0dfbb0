#include "bench/validation/numerical_scatter.hpp"

#include "app/text/number_text.hpp"
#include "core/moments.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

/// The same wall under each discretisation; empty where it failed under one.
std::vector<const app::StudyWall*> same_wall(std::span<const app::StudyWalls> studies,
                                             std::size_t level, app::WallKey key)
{
    std::vector<const app::StudyWall*> all;
    for (const app::StudyWalls& s : studies) {
        const auto& walls = s.levels.at(level).walls;
        const auto found = std::ranges::find(walls, key, &app::StudyWall::key);
        if (found == walls.end()) return {};
        all.push_back(&*found);
        if (found->inputs != all.front()->inputs)
            throw std::invalid_argument("numerical scatter: these are not the same walls");
    }
    return all;
}

} // namespace

ScatterParts scatter_parts(std::span<const app::StudyWalls> studies, std::size_t level)
{
    ScatterParts parts;
    std::vector<double> means;
    double within = 0.0;
    for (const app::StudyWall& first : studies.front().levels.at(level).walls) {
        const auto walls = same_wall(studies, level, first.key);
        if (walls.empty()) continue;
        const auto fell = std::ranges::count_if(
            walls, [](const app::StudyWall* w) { return w->reading.dropped; });
        const bool one_mode = std::ranges::all_of(walls, [&](const app::StudyWall* w) {
            return app::mode_of(*w) == app::mode_of(first);
        });
        parts.changed_mode += !one_mode;
        if (fell < std::ssize(walls)) {
            parts.fell_in_some += fell > 0;
            continue;
        }
        std::vector<double> logs;
        for (const app::StudyWall* w : walls)
            logs.push_back(std::log(w->reading.ultimate.displacement));
        const core::Moments m = core::moments(logs);
        means.push_back(m.mean);
        within += m.sd * m.sd;
    }
    parts.walls = means.size();
    if (means.size() < 2) return parts;
    const auto n = static_cast<double>(means.size());
    parts.within = std::sqrt(within / n);
    const double of_means = core::moments(means).sd;
    parts.between = std::sqrt(
        std::max(0.0, of_means * of_means - within / n / static_cast<double>(studies.size())));
    return parts;
}

app::Table numerical_scatter(std::span<const app::StudyWalls> studies, const std::string& names)
{
    app::Table t;
    t.caption = "Numerical part of the scatter of drops, from the same walls under " + names +
                ". The table has standard deviations of ln displacement at the fall to 80 % of "
                "the peak, for the walls that fell under all of them: first of one wall over "
                "the discretisations, then of the walls without this part. The drop of one "
                "wall is known no better than the first; the scatter of a study includes both.";
    t.head = {"stress [MPa]",
              "walls",
              "one wall, numerical",
              "walls, material",
              "numerical share of the variance [%]",
              "fell under some only",
              "changed their mode"};
    for (std::size_t l = 0; l < studies.front().levels.size(); ++l) {
        const ScatterParts p = scatter_parts(studies, l);
        app::Row row = {app::fixed(studies.front().levels[l].stress * 1e-6, 2),
                        std::to_string(p.walls)};
        const double all = p.within * p.within + p.between * p.between;
        if (p.walls < 5)
            row.insert(row.end(), {"", "", ""});
        else
            row.insert(row.end(), {app::fixed(p.within, 2), app::fixed(p.between, 2),
                                   app::fixed(100.0 * p.within * p.within / all, 0)});
        row.insert(row.end(), {std::to_string(p.fell_in_some), std::to_string(p.changed_mode)});
        t.rows.push_back(row);
    }
    return t;
}

} // namespace bench
