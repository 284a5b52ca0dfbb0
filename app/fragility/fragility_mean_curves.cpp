#include "app/fragility/fragility_means.hpp"

#include "app/fragility/table_texts.hpp"
#include "app/output/chart_svg.hpp"
#include "app/study/fragility_text.hpp"
#include "app/study/resampled_curve.hpp"
#include "app/text/number_text.hpp"
#include "fragility/sample_quantile.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

const char* group_name(int mode) { return mode == kAllModes ? "all" : mode_name(mode); }

constexpr std::size_t kTableStep = 4; ///< of the grid of curves

std::vector<const StudyWall*> group_of(const StudyLevel& level, int mode)
{
    std::vector<const StudyWall*> group;
    for (const StudyWall& w : level.walls)
        if ((mode == kAllModes || mode_of(w) == mode) && !w.forces.empty()) group.push_back(&w);
    return group;
}

struct MeanOf {
    double mean;
    fragility::Interval interval;
};

MeanOf mean_of(const std::vector<double>& forces, double confidence)
{
    if (forces.size() == 1) return {forces.front(), {kUnknown, kUnknown, confidence}};
    const uq::Estimate e = uq::estimate_mean(forces, confidence);
    return {e.value, {e.interval.lower, e.interval.upper, confidence}};
}

/// Points of the curve of a full push; the last may lie a rounding short of the target.
constexpr std::size_t kFullPush = kCurveSteps;

/// Said where it applies: " Runs that ended before the full push: 31 of 50 at 0.5 MPa ..."
std::string early_text(const StudyWalls& walls)
{
    std::string text;
    for (const StudyLevel& level : walls.levels) {
        const auto group = group_of(level, kAllModes);
        const auto early = std::count_if(group.begin(), group.end(), [](const StudyWall* w) {
            return w->forces.size() < kFullPush;
        });
        if (early == 0) continue;
        text += (text.empty() ? " Runs that ended before the full push: " : ", ") +
                std::to_string(early) + " of " + std::to_string(group.size()) + " at " +
                number(level.stress / 1e6, 12) + " MPa";
    }
    if (text.empty()) return text;
    const double share = walls.study.load.stop_below;
    if (share > 0.0)
        text += " (load.stop_below ends a run once the force has fallen to " +
                percent_text(share) + " of the peak)";
    return text + ". Where n is below its first value, the walls that dropped first have left, "
                  "and the mean of those still pushed lies above the mean of all.";
}

NamedPicture picture(const StudyWalls& walls, int mode)
{
    Chart c;
    const std::string what = group_name(mode);
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
        mean.name = number(walls.levels[l].stress / 1e6, 6) + " MPa";
        for (Series* const s : {&mean, &low, &high}) s->colour = stress_colour(l);
        low.line = high.line = LineStyle::dotted;
        low.width = high.width = 1.0;
        mean.width = 2.2;
        c.series.insert(c.series.end(), {mean, low, high});
    }
    return {"mean_curves_" + what,
            "mean force over drift, " + (mode == kAllModes ? std::string("all") : what) +
                " walls, per stress, while 90 % of them are pushed; dotted: 16 and 84 % of the "
                "walls",
            line_chart(c)};
}

} // namespace

const char* stress_colour(std::size_t level)
{
    constexpr std::array<const char*, 7> kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                     "#E69F00", "#56B4E9", "#000000"};
    return kColours[level % kColours.size()];
}

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
        std::sort(forces.begin(), forces.end());
        const MeanOf m = mean_of(forces, walls.study.fragility.confidence);
        points.push_back({100.0 * walls.step * static_cast<double>(i) / walls.height, m.mean,
                          fragility::sample_quantile(forces, 0.16),
                          fragility::sample_quantile(forces, 0.84), forces.size(), m.interval});
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
                t.rows.push_back({given(level.stress / 1e6), group_name(mode),
                                  plain_number(points[i].drift, 3),
                                  count(static_cast<double>(points[i].walls)),
                                  with_interval(points[i].mean, points[i].interval.lower,
                                                points[i].interval.upper, 3),
                                  plain_number(points[i].low, 3),
                                  plain_number(points[i].high, 3)});
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
