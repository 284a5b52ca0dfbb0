#include "app/fragility/fragility_cycles.hpp"

#include "app/fragility/fragility_means.hpp"
#include "app/fragility/table_texts.hpp"
#include "app/output/chart_svg.hpp"
#include "app/study/fragility_text.hpp"
#include "app/text/number_text.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <optional>

namespace app {
namespace {

/// What walls have in one cycle.
struct CycleValues {
    std::vector<double> drift, damping, stiffness, residual, energy;
};

void add_cycle(const StudyWalls& study, const StudyWall& w, std::size_t k, CycleValues& all)
{
    const fragility::Cycle& c = w.cycles[k];
    const std::optional<double> damping = fragility::equivalent_damping(c);
    if (!c.closed || !damping) return;
    all.drift.push_back(100.0 * fragility::amplitude(c) / study.height);
    all.damping.push_back(100.0 * *damping);
    all.energy.push_back(c.energy);
    const auto first = fragility::secant_stiffness(w.cycles.front()),
               now = fragility::secant_stiffness(c);
    if (first && now && *first > 0.0) all.stiffness.push_back(*now / *first);
    if (c.residual_plus && c.residual_minus)
        all.residual.push_back(50.0 * (*c.residual_plus - *c.residual_minus) / study.height);
}

double plain_mean(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double x : values) sum += x;
    return sum / static_cast<double>(values.size());
}

CycleMean cycle_mean(const std::vector<double>& values, double confidence)
{
    if (values.empty()) return {kUnknown, {kUnknown, kUnknown, confidence}};
    if (values.size() == 1) return {values.front(), {kUnknown, kUnknown, confidence}};
    const uq::Estimate e = uq::estimate_mean(values, confidence);
    return {e.value, {e.interval.lower, e.interval.upper, confidence}};
}

const char* cycle_group(int mode) { return mode == kAllModes ? "all" : mode_name(mode); }

std::vector<int> modes_and_all(const StudyWalls& walls)
{
    std::vector<int> modes = modes_of(walls);
    modes.push_back(kAllModes);
    return modes;
}

NamedPicture damping_picture(const StudyWalls& walls, int mode)
{
    Chart c;
    const std::string who = cycle_group(mode);
    c.title = "Equivalent viscous damping, " + who + " walls";
    c.x_label = "drift [%]";
    c.y_label = "damping [%]";
    for (std::size_t l = 0; l < walls.levels.size(); ++l) {
        Series mean, low, high;
        for (const CyclePoint& p : cycle_points(walls, walls.levels[l], mode)) {
            for (Series* const s : {&mean, &low, &high}) s->x.push_back(p.drift);
            mean.y.push_back(p.damping.value);
            low.y.push_back(p.damping.interval.lower);
            high.y.push_back(p.damping.interval.upper);
        }
        if (mean.x.empty()) continue;
        mean.name = number(walls.levels[l].stress / 1e6, 6) + " MPa";
        mean.points = true;
        for (Series* const s : {&mean, &low, &high}) s->colour = stress_colour(l);
        low.line = high.line = LineStyle::dotted;
        low.width = high.width = 1.0;
        c.series.insert(c.series.end(), {mean, low, high});
    }
    return {"damping_" + who,
            "equivalent viscous damping over drift, " + who + " walls, per stress; dotted: " +
                percent_text(walls.study.fragility.confidence) + " interval of the mean",
            line_chart(c)};
}

} // namespace

std::vector<CyclePoint> cycle_points(const StudyWalls& walls, const StudyLevel& level, int mode)
{
    std::size_t most = 0;
    for (const StudyWall& w : level.walls) most = std::max(most, w.cycles.size());
    const double confidence = walls.study.fragility.confidence;
    std::vector<CyclePoint> points;
    for (std::size_t k = 0; k < most; ++k) {
        CycleValues all;
        for (const StudyWall& w : level.walls)
            if ((mode == kAllModes || mode_of(w) == mode) && k < w.cycles.size())
                add_cycle(walls, w, k, all);
        if (all.drift.empty()) continue;
        points.push_back({k + 1, all.drift.size(), plain_mean(all.drift),
                          cycle_mean(all.damping, confidence),
                          cycle_mean(all.stiffness, confidence),
                          cycle_mean(all.residual, confidence), plain_mean(all.energy)});
    }
    return points;
}

Table cycle_table(const StudyWalls& walls)
{
    Table t = titled_table("cycles", words_of(walls));
    t.keys = 3;
    t.head = {"stress [MPa]",
              "walls",
              "cycle",
              "drift [%]",
              "n",
              {"damping [%]", kInterval},
              {"stiffness share", kInterval},
              {"half width [%]", kInterval},
              "energy [J]"};
    const auto cell = [](const CycleMean& m, int decimals) {
        return with_interval(m.value, m.interval, decimals);
    };
    for (const StudyLevel& level : walls.levels)
        for (const int mode : modes_and_all(walls))
            for (const CyclePoint& p : cycle_points(walls, level, mode))
                t.rows.push_back({given(level.stress / 1e6), cycle_group(mode),
                                  count(static_cast<double>(p.cycle)), plain_number(p.drift, 3),
                                  count(static_cast<double>(p.walls)), cell(p.damping, 2),
                                  cell(p.stiffness, 3), cell(p.residual, 3),
                                  plain_number(p.energy, 1)});
    return t;
}

std::vector<NamedPicture> cycle_pictures(const StudyWalls& walls)
{
    std::vector<NamedPicture> pictures;
    for (const int mode : modes_and_all(walls)) {
        const bool any = std::ranges::any_of(walls.levels, [&](const StudyLevel& l) {
            return !cycle_points(walls, l, mode).empty();
        });
        if (any) pictures.push_back(damping_picture(walls, mode));
    }
    return pictures;
}

} // namespace app
