#include "app/fragility_means.hpp"

#include "app/chart_svg.hpp"
#include "app/number_text.hpp"
#include "fragility/bootstrap.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

constexpr std::array<const char*, 3> kGroups = {"rocking", "mixed", "all"};
constexpr int kAllModes = 2;
constexpr std::size_t kTableStep = 4; ///< of the grid of curves
constexpr std::array<const char*, 7> kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                 "#E69F00", "#56B4E9", "#000000"};

/// Forces of the walls of a group at one step [kN].
struct MeanPoint {
    double drift; ///< [%]
    double mean, low, high;
    std::size_t walls;
};

/// As far as all curves of the group go: a mean over those left would jump where one ends. Walls whose
/// run was cut short after their drop would end it early: they count as far as they go, the point is
/// kept while half of the walls are left.
std::vector<MeanPoint> mean_points(const StudyWalls& walls, const StudyLevel& level, int mode)
{
    std::vector<const StudyWall*> group;
    for (const StudyWall& w : level.walls)
        if ((mode == kAllModes || w.mode == mode) && !w.forces.empty()) group.push_back(&w);
    std::vector<MeanPoint> points;
    for (std::size_t i = 0; i <= kCurveSteps && !group.empty(); ++i) {
        std::vector<double> forces;
        for (const StudyWall* w : group)
            if (i < w->forces.size()) forces.push_back(w->forces[i] * 1e-3);
        if (2 * forces.size() < group.size() || forces.empty()) break;
        std::sort(forces.begin(), forces.end());
        double sum = 0.0;
        for (const double f : forces) sum += f;
        points.push_back({100.0 * walls.step * static_cast<double>(i) / walls.height,
                          sum / static_cast<double>(forces.size()),
                          fragility::sample_quantile(forces, 0.16),
                          fragility::sample_quantile(forces, 0.84), forces.size()});
    }
    return points;
}

NamedPicture picture(const StudyWalls& walls, int mode)
{
    Chart c;
    const std::string what = kGroups[static_cast<std::size_t>(mode)];
    c.title = "Mean force over drift, " + (mode == kAllModes ? "all walls" : what + " walls");
    c.x_label = "drift [%]";
    c.y_label = "force [kN]";
    for (std::size_t l = 0; l < walls.levels.size(); ++l) {
        const auto points = mean_points(walls, walls.levels[l], mode);
        if (points.empty()) continue;
        Series mean, low, high;
        for (const MeanPoint& p : points) {
            for (Series* const s : {&mean, &low, &high}) s->x.push_back(p.drift);
            mean.y.push_back(p.mean);
            low.y.push_back(p.low);
            high.y.push_back(p.high);
        }
        mean.name = number(walls.levels[l].stress * 1e-6, 6) + " MPa";
        for (Series* const s : {&mean, &low, &high}) s->colour = kColours[l % kColours.size()];
        low.line = high.line = LineStyle::dotted;
        low.width = high.width = 1.0;
        mean.width = 2.2;
        c.series.insert(c.series.end(), {mean, low, high});
    }
    return {"mean_curves_" + what,
            "mean force over drift, " + (mode == kAllModes ? std::string("all") : what) +
                " walls, per stress; dotted: 16 and 84 % of the walls",
            line_chart(c)};
}

} // namespace

Table mean_curve_table(const StudyWalls& walls)
{
    Table t;
    t.caption =
        "Mean force over drift per mode and vertical stress (the paper, Fig. 15), with "
        "16 and 84 % quantiles of the walls. Drift: displacement of the load line / its "
        "height, " +
        number(walls.height, 6) +
        " m. Walls whose curve has ended are left out from there on (n); a curve ends "
        "where less than half of its walls are left.";
    t.head = {"stress [MPa]",    "walls",     "drift [%]", "n",
              "mean force [kN]", "16 % [kN]", "84 % [kN]"};
    for (const StudyLevel& level : walls.levels)
        for (int mode = 0; mode <= kAllModes; ++mode) {
            const auto points = mean_points(walls, level, mode);
            for (std::size_t i = 0; i < points.size(); i += kTableStep)
                t.rows.push_back({number(level.stress * 1e-6, 12),
                                  kGroups[static_cast<std::size_t>(mode)],
                                  fixed(points[i].drift, 3), std::to_string(points[i].walls),
                                  fixed(points[i].mean, 3), fixed(points[i].low, 3),
                                  fixed(points[i].high, 3)});
        }
    return t;
}

std::vector<NamedPicture> mean_curve_pictures(const StudyWalls& walls)
{
    std::vector<NamedPicture> pictures;
    for (int mode = 0; mode <= kAllModes; ++mode) {
        const bool any =
            std::any_of(walls.levels.begin(), walls.levels.end(), [&](const StudyLevel& l) {
                return !mean_points(walls, l, mode).empty();
            });
        if (any) pictures.push_back(picture(walls, mode));
    }
    return pictures;
}

} // namespace app
