#include "app/fragility/fragility_means.hpp"

#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "core/sample_quantile.hpp"
#include "fragility/curve/drift.hpp"

#include <algorithm>

namespace app {
namespace {

constexpr std::size_t kTableStep = 4; ///< of the grid of curves

/// Walls of a mode that have a curve.
WallList group_of(const StudyLevel& level, int mode)
{
    WallList group = walls_of(level, mode);
    std::erase_if(group, [](const StudyWall* w) { return w->forces.empty(); });
    return group;
}

/// Points of the curve of a full push; the last may lie a rounding short of the target.
constexpr std::size_t kFullPush = kCurveSteps;

/// Said where it applies: " Runs that ended before the full push: 31 of 50 at 0.5 MPa ..."
std::string early_text(const StudyWalls& walls)
{
    std::string text;
    for (const StudyLevel& level : walls.levels) {
        const auto group = group_of(level, kAllModes);
        const auto early = std::ranges::count_if(
            group, [](const StudyWall* w) { return w->forces.size() < kFullPush; });
        if (early == 0) continue;
        text += (text.empty() ? " Runs that ended before the full push: " : ", ") +
                std::to_string(early) + " of " + std::to_string(group.size()) + " at " +
                stress_text(level.stress);
    }
    if (text.empty()) return text;
    const double share = walls.study.load.stop_below;
    if (share > 0.0)
        text += " (load.stop_below ends a run once the force has fallen to " +
                percent_text(share) + " of the peak)";
    return text + ". Where n is below its first value, the walls that dropped first have left, "
                  "and the mean of those still pushed lies above the mean of all.";
}

void add_curves(const StudyWalls& walls, int mode, std::vector<NamedPicture>& pictures)
{
    Chart c;
    const std::string what = mode_name(mode);
    c.title = "Mean force over drift, " + what + " walls";
    c.x_label = "drift [%]";
    c.y_label = "force [kN]";
    for (std::size_t l = 0; l < walls.levels.size(); ++l) {
        Band curve(palette(l));
        for (const MeanPoint& p : mean_points(walls, walls.levels[l], mode))
            curve.add(p.drift, p.mean, p.low, p.high);
        if (curve.line.x.empty()) continue;
        curve.line.name = stress_text(walls.levels[l].stress);
        curve.line.width = 2.2;
        add_band(c, curve);
    }
    if (c.series.empty()) return;
    pictures.push_back({"mean_curves_" + what,
                        "mean force over drift, " + what +
                            " walls, per stress, while 90 % of them are pushed; dotted: 16 and "
                            "84 % of the walls",
                        line_chart(c)});
}

} // namespace

std::vector<MeanPoint> mean_points(const StudyWalls& walls, const StudyLevel& level, int mode)
{
    const auto group = group_of(level, mode);
    std::vector<MeanPoint> points;
    for (std::size_t i = 0; i <= kCurveSteps && !group.empty(); ++i) {
        std::vector<double> forces;
        for (const StudyWall* w : group)
            if (i < w->forces.size()) forces.push_back(w->forces[i] * 1e-3);
        if (static_cast<double>(forces.size()) <
            kMeanNeedsShare * static_cast<double>(group.size()))
            break;
        std::ranges::sort(forces);
        const MeanOf m = mean_of(forces, walls.study.fragility.confidence);
        points.push_back(
            {fragility::drift(100.0 * walls.step * static_cast<double>(i), walls.height),
             m.value, core::sample_quantile(forces, 0.16), core::sample_quantile(forces, 0.84),
             forces.size(), m.interval});
    }
    return points;
}

Table mean_curve_table(const StudyWalls& walls)
{
    Words words = words_of(walls);
    words["needed"] = percent_text(kMeanNeedsShare);
    words["early"] = early_text(walls);
    Table t = titled_table("mean_curves", words);
    t.keys = 2;
    t.head = {"stress [MPa]",
              "walls",
              "drift [%]",
              "n",
              {"mean force [kN]", kInterval},
              "16 % of the walls below [kN]",
              "84 % of the walls below [kN]"};
    for (const StudyLevel& level : walls.levels)
        for (int mode = 0; mode <= kAllModes; ++mode) {
            const auto points = mean_points(walls, level, mode);
            for (std::size_t i = 0; i < points.size(); i += kTableStep)
                t.rows.push_back({stress_cell(level.stress), mode_name(mode),
                                  plain_number(points[i].drift, 3), count(points[i].walls),
                                  with_interval(points[i].mean, points[i].interval, 3),
                                  plain_number(points[i].low, 3),
                                  plain_number(points[i].high, 3)});
        }
    return t;
}

std::vector<NamedPicture> mean_curve_pictures(const StudyWalls& walls)
{
    std::vector<NamedPicture> pictures;
    for (int mode = 0; mode <= kAllModes; ++mode) add_curves(walls, mode, pictures);
    return pictures;
}

} // namespace app
