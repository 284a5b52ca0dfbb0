#include "bench/validation/pictures.hpp"

#include "app/output/picture/chart_svg.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/number_text.hpp"
#include "bench/validation/paper_tables.hpp"
#include "core/binomial.hpp"
#include "uq/estimates/running_mean.hpp"
#include "uq/marginals/marginal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bench {
namespace {

constexpr std::array kModeColours = {"#0072B2", "#D55E00"}; // rocking, mixed
constexpr std::array kModeNames = {"rocking", "mixed mode"};
constexpr std::array kLevelColours = {"#0072B2", "#E69F00", "#009E73", "#CC79A7", "#D55E00"};

std::string stress_text(double pascal) { return app::fixed(pascal * 1e-6, 2) + " MPa"; }

std::vector<double> values_of(const app::StudyWalls& walls, std::size_t input)
{
    std::vector<double> values;
    for (const app::StudyLevel& level : walls.levels)
        for (const app::StudyWall& w : level.walls) values.push_back(w.inputs[input]);
    return values;
}

const app::RandomInput* random_of(const app::StudyWalls& walls, const std::string& key)
{
    for (const app::RandomInput& r : walls.study.random)
        if (r.key == key) return &r;
    return nullptr;
}

/// Outline of a histogram as density.
app::Series outline(std::vector<double> values, int bins)
{
    std::sort(values.begin(), values.end());
    const double low = values.front(), width = (values.back() - low) / bins;
    app::Series s{.name = "walls", .colour = kModeColours[0]};
    for (int b = 0; b < bins; ++b) {
        const double from = low + b * width,
                     to = b + 1 == bins ? values.back() * (1 + 1e-12) : from + width;
        const auto n = std::lower_bound(values.begin(), values.end(), to) -
                       std::lower_bound(values.begin(), values.end(), from);
        const double density =
            static_cast<double>(n) / (static_cast<double>(values.size()) * width);
        s.x.insert(s.x.end(), {from, from, from + width, from + width});
        s.y.insert(s.y.end(), {0.0, density, density, 0.0});
    }
    return s;
}

/// Mean of the walls of a mode, as far as nine of ten are still pushed.
app::Series mean_curve(const app::StudyWalls& walls, const app::StudyLevel& level, int mode)
{
    app::Series s{.name = std::string("mean, ") + kModeNames[static_cast<std::size_t>(mode)],
                  .colour = "#111",
                  .line =
                      mode == app::kRocking ? app::LineStyle::solid : app::LineStyle::dashed,
                  .width = 2.6};
    std::size_t all = 0;
    for (const app::StudyWall& w : level.walls) all += app::mode_of(w) == mode;
    for (std::size_t k = 0; k <= app::kCurveSteps && all > 0; ++k) {
        double sum = 0.0;
        std::size_t n = 0;
        for (const app::StudyWall& w : level.walls)
            if (app::mode_of(w) == mode && k < w.forces.size()) sum += w.forces[k], ++n;
        if (10 * n < 9 * all || n == 0) break;
        s.x.push_back(static_cast<double>(k) * walls.step * 1e3);
        s.y.push_back(sum / static_cast<double>(n) * 1e-3);
    }
    return s;
}

} // namespace

std::vector<app::NamedPicture> input_histograms(const app::StudyWalls& walls)
{
    std::vector<app::NamedPicture> pictures;
    for (std::size_t i = 0; i < walls.inputs.size(); ++i) {
        const app::StoredInput& input = walls.inputs[i];
        const app::RandomInput* const random = random_of(walls, input.key);
        const std::vector<double> values = values_of(walls, i);
        if (random == nullptr || values.size() < 2) continue;
        app::Chart c;
        c.title = input.key;
        c.x_label = input.key + " [" + input.unit + "]";
        c.y_label = "density";
        c.width = 420;
        c.height = 300;
        c.series.push_back(outline(values, 12));
        app::Series law{.name = "prescribed", .colour = "#111", .line = app::LineStyle::dashed};
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        for (int k = 0; k <= 100; ++k) {
            const double x = *low + (*high - *low) * k / 100.0;
            law.x.push_back(x);
            law.y.push_back(uq::pdf(random->marginal, x / input.scale) / input.scale);
        }
        c.series.push_back(law);
        pictures.push_back(
            {"fig09_" + app::file_name(input.key), input.key, app::line_chart(c)});
    }
    return pictures;
}

app::NamedPicture running_errors(const app::StudyWalls& walls)
{
    app::Chart c;
    const app::StudyLevel& level = walls.levels.front();
    c.title = "Error of the mean after j walls, " + stress_text(level.stress);
    c.x_label = "walls j";
    c.y_label = "error of the mean [%]";
    c.horizontal = {{0.2, "0.2 %"}, {-0.2, ""}};
    for (std::size_t i = 0; i < walls.inputs.size(); ++i) {
        const app::RandomInput* const random = random_of(walls, walls.inputs[i].key);
        if (random == nullptr) continue;
        std::vector<double> values;
        for (const app::StudyWall& w : level.walls)
            values.push_back(w.inputs[i] / walls.inputs[i].scale);
        app::Series s{.name = walls.inputs[i].key, .colour = kLevelColours[i % 5]};
        for (const uq::RunningMean& m :
             uq::running_mean(values, {uq::mean(random->marginal), uq::sd(random->marginal)})) {
            s.x.push_back(static_cast<double>(m.samples));
            s.y.push_back(100.0 * m.error);
        }
        c.series.push_back(s);
    }
    return {"fig10", c.title, app::line_chart(c)};
}

std::vector<app::NamedPicture> all_curves(const app::StudyWalls& walls, const std::string& name)
{
    std::vector<app::NamedPicture> pictures;
    for (const app::StudyLevel& level : walls.levels) {
        app::Chart c;
        c.title = stress_text(level.stress);
        c.x_label = "displacement of the load line [mm]";
        c.y_label = "horizontal force [kN]";
        c.width = 560;
        c.height = 380;
        bool named[2] = {};
        for (const app::StudyWall& w : level.walls) {
            const auto m = static_cast<std::size_t>(app::mode_of(w));
            app::Series s{
                .name = named[m] ? "" : kModeNames[m], .colour = kModeColours[m], .width = 0.6};
            named[m] = true;
            for (std::size_t k = 0; k < w.forces.size(); ++k) {
                s.x.push_back(std::round(static_cast<double>(k) * walls.step * 1e6) * 1e-3);
                s.y.push_back(std::round(w.forces[k]) * 1e-3);
            }
            c.series.push_back(s);
        }
        for (const int mode : {app::kRocking, app::kMixed})
            if (named[mode]) c.series.push_back(mean_curve(walls, level, mode));
        pictures.push_back({name + "_" + app::fixed(level.stress * 1e-6, 2),
                            "all curves under " + stress_text(level.stress),
                            app::line_chart(c)});
    }
    return pictures;
}

std::vector<app::NamedPicture> peaks_over_inputs(const app::StudyWalls& walls)
{
    std::vector<app::NamedPicture> pictures;
    for (const std::string key :
         {"joint.friction_angle", "unit.friction_angle", "unit.tensile_strength"}) {
        std::size_t i = 0;
        while (i < walls.inputs.size() && walls.inputs[i].key != key) ++i;
        if (i == walls.inputs.size()) continue;
        app::Chart c;
        c.title = "Peak force and " + key + ", " + stress_text(walls.levels.front().stress) +
                  " to " + stress_text(walls.levels.back().stress) + " from below";
        c.x_label = key + " [" + walls.inputs[i].unit + "]";
        c.y_label = "peak force [kN]";
        for (const int mode : {app::kRocking, app::kMixed}) {
            app::Series s{.name = kModeNames[static_cast<std::size_t>(mode)],
                          .colour = kModeColours[static_cast<std::size_t>(mode)],
                          .line = app::LineStyle::none,
                          .points = true};
            for (const app::StudyLevel& level : walls.levels)
                for (const app::StudyWall& w : level.walls)
                    if (app::mode_of(w) == mode) {
                        s.x.push_back(w.inputs[i]);
                        s.y.push_back(app::peak_force(w.reading) * 1e-3);
                    }
            if (!s.x.empty()) c.series.push_back(s);
        }
        pictures.push_back({"fig12_" + app::file_name(key), c.title, app::line_chart(c)});
    }
    return pictures;
}

app::NamedPicture rocking_over_stress(const std::vector<LevelStatistics>& ours)
{
    app::Chart c;
    c.title = "Share of rocking walls";
    c.x_label = "vertical stress [MPa]";
    c.y_label = "rocking [%]";
    c.width = 560;
    c.height = 380;
    const auto add = [&](const char* name, const char* colour, double shift, const auto& levels,
                         auto count, auto size, auto stress) {
        app::Series dots{
            .name = name, .colour = colour, .line = app::LineStyle::none, .points = true};
        for (const auto& l : levels) {
            const double k = count(l), n = size(l), x = stress(l) + shift;
            const auto i = core::binomial_interval(core::BinomialInterval::wilson, k, n);
            dots.x.push_back(x);
            dots.y.push_back(100.0 * k / n);
            c.series.push_back({.x = {x, x},
                                .y = {100.0 * i.lower, 100.0 * i.upper},
                                .colour = colour,
                                .width = 1.5});
        }
        c.series.push_back(dots);
    };
    add(
        "paper, 50 walls", "#111", -0.008, kPaperLevels,
        [](const PaperLevel& p) { return static_cast<double>(p.rocking_walls); },
        [](const PaperLevel& p) { return static_cast<double>(p.walls); },
        [](const PaperLevel& p) { return p.stress_MPa; });
    add(
        "ours, 500 walls", kModeColours[0], 0.008, ours,
        [](const LevelStatistics& s) { return static_cast<double>(s.rocking_walls); },
        [](const LevelStatistics& s) { return static_cast<double>(s.walls); },
        [](const LevelStatistics& s) { return s.stress_MPa; });
    return {"rocking_share", c.title, app::line_chart(c)};
}

} // namespace bench
