#include "app/fragility/fragility_cycles.hpp"

#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "fragility/curve/drift.hpp"

#include <algorithm>
#include <optional>

namespace app {
namespace {

/// Values of the walls in one cycle.
struct CycleValues {
    std::vector<double> drift, damping, stiffness, residual, energy;
};

void add_cycle(const StudyWalls& study, const StudyWall& w, std::size_t k, CycleValues& all)
{
    const fragility::Cycle& c = w.cycles[k];
    const std::optional<double> damping = fragility::equivalent_damping(c);
    if (!damping) return;
    all.drift.push_back(fragility::percent_drift(fragility::amplitude(c), study.height));
    all.damping.push_back(100.0 * *damping);
    all.energy.push_back(c.energy);
    const auto first = fragility::secant_stiffness(w.cycles.front()),
               now = fragility::secant_stiffness(c);
    if (first && now && *first > 0.0) all.stiffness.push_back(*now / *first);
    if (c.residual_plus && c.residual_minus)
        all.residual.push_back(fragility::percent_drift(
            0.5 * (*c.residual_plus - *c.residual_minus), study.height));
}

void add_damping(const StudyWalls& walls, int mode, std::vector<NamedPicture>& pictures)
{
    Chart c;
    const std::string who = mode_name(mode);
    c.title = "Equivalent viscous damping, " + who + " walls";
    c.x_label = "drift [%]";
    c.y_label = "damping [%]";
    for (std::size_t l = 0; l < walls.levels.size(); ++l) {
        Band damping(palette(l));
        for (const CyclePoint& p : cycle_points(walls, walls.levels[l], mode))
            damping.add(p.drift, p.damping.value, p.damping.interval.lower,
                        p.damping.interval.upper);
        if (damping.line.x.empty()) continue;
        damping.line.name = stress_text(walls.levels[l].stress);
        damping.line.points = true;
        add_band(c, damping);
    }
    if (c.series.empty()) return;
    pictures.push_back(
        {"damping_" + who,
         "equivalent viscous damping over drift, " + who + " walls, per stress; dotted: " +
             percent_text(walls.study.fragility.confidence) + " interval of the mean",
         line_chart(c)});
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
        for (const StudyWall* w : walls_of(level, mode))
            if (k < w->cycles.size()) add_cycle(walls, *w, k, all);
        if (all.drift.empty()) continue;
        points.push_back({k + 1, all.drift.size(), plain_mean(all.drift),
                          mean_of(all.damping, confidence), mean_of(all.stiffness, confidence),
                          mean_of(all.residual, confidence), plain_mean(all.energy)});
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
    const auto cell = [](const MeanOf& m, int decimals) {
        return with_interval(m.value, m.interval, decimals);
    };
    for (const StudyLevel& level : walls.levels)
        for (int mode = 0; mode <= kAllModes; ++mode)
            for (const CyclePoint& p : cycle_points(walls, level, mode))
                t.rows.push_back({stress_cell(level.stress), mode_name(mode), count(p.cycle),
                                  plain_number(p.drift, 3), count(p.walls), cell(p.damping, 2),
                                  cell(p.stiffness, 3), cell(p.residual, 3),
                                  plain_number(p.energy, 1)});
    return t;
}

std::vector<NamedPicture> cycle_pictures(const StudyWalls& walls)
{
    std::vector<NamedPicture> pictures;
    for (int mode = 0; mode <= kAllModes; ++mode) add_damping(walls, mode, pictures);
    return pictures;
}

} // namespace app
