#include "app/calibration/tested_factor.hpp"

#include "app/fragility/drift_csv.hpp"
#include "app/input/study/model_factor_text.hpp"
#include "app/output/table/cells.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "core/interval.hpp"
#include "fragility/fits/observed_quantile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t kFewestTests = 3;

/// Median of the walls: peaks [kN], or displacements at the drop [mm]; nothing where fewer than
/// half of them are known.
std::optional<double> median_of(const StudyLevel& level, Answer answer, double confidence)
{
    std::vector<fragility::Observation> values;
    for (const StudyWall& w : level.walls) {
        const double peak = peak_force(w.reading) / 1e3;
        if (answer == Answer::force && peak > 0.0) values.push_back(fragility::observed(peak));
        const auto drop = fragility::observation(w.reading.ultimate, 1e3);
        if (answer == Answer::drift && drop) values.push_back(*drop);
    }
    if (values.empty()) return {};
    constexpr std::array kHalf = {0.5};
    return fragility::observed_quantiles(values, kHalf, confidence).front().value;
}

std::vector<double> stresses_of(const StudyWalls& walls)
{
    std::vector<double> stresses;
    for (const StudyLevel& l : walls.levels) stresses.push_back(l.stress);
    return stresses;
}

/// The interval of a test's ratio by the other tests; nothing where they are too few.
std::optional<core::Interval> by_others(const std::vector<TestedWall>& walls,
                                        std::size_t left_out)
{
    std::vector<TestedWall> others = walls;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    const auto seen = std::ranges::count(others, false, &TestedWall::at_least);
    if (static_cast<std::size_t>(seen) < kFewestTests) return {};
    const auto interval = fragility::predictive_interval(
        fragility::hierarchical_posterior(log_ratios(others), kFactorPrior), 0.90);
    return core::Interval{std::exp(interval.lower), std::exp(interval.upper), 0.90};
}

void add_rows_of(const TestedFactor& c, const char* what, int decimals, Table& t)
{
    for (std::size_t i = 0; i < c.walls.size(); ++i) {
        const TestedWall& w = c.walls[i];
        const double ratio = w.predicted > 0.0 ? w.measured / w.predicted : kUnknown;
        const auto held = c.factor ? by_others(c.walls, i) : std::nullopt;
        Row row = {w.name,
                   what,
                   given(w.stress / 1e6),
                   Number{.value = w.measured,
                          .decimals = decimals,
                          .sense = w.at_least ? Sense::above : Sense::equal},
                   w.predicted > 0.0 ? plain_number(w.predicted, decimals) : Number{},
                   Number{.value = ratio,
                          .decimals = 2,
                          .sense = w.at_least ? Sense::above : Sense::equal}};
        row.emplace_back(held ? range(held->lower, held->upper, 2) : Number{});
        add_row(t, row);
    }
}

std::string line_of(const char* key, const TestedFactor& c)
{
    if (!c.factor) return "# " + std::string(key) + ": " + c.reason + "\n";
    const EstimatedFactor& e = *c.factor;
    return std::string(key) + " = " + model_factor_text(e.factor) + " # " +
           std::to_string(c.walls.size()) + " tests; 90 %: median " +
           number(e.median.lower, 3) + " to " + number(e.median.upper, 3) + ", scatter " +
           number(e.dispersion.lower, 3) + " to " + number(e.dispersion.upper, 3) + "\n";
}

} // namespace

std::vector<TestedWall> tests_over_walls(const Csv& csv, const std::vector<MeasuredTest>& tests,
                                         const StudyWalls& walls, Answer answer)
{
    check_stresses(csv, tests, stresses_of(walls));
    std::vector<TestedWall> over;
    for (const MeasuredTest& t : tests) {
        const auto& measured = answer == Answer::force ? t.peak : t.drop;
        if (!measured) continue;
        const auto level = std::ranges::find_if(
            walls.levels, [&](const StudyLevel& l) { return same_stress(t.stress, l.stress); });
        const auto median = median_of(*level, answer, walls.study.fragility.confidence);
        over.push_back({t.name, level->stress, *measured, median.value_or(0.0),
                        answer == Answer::drift && t.censored});
    }
    return over;
}

TestedFactor tested_factor(std::vector<TestedWall> walls)
{
    TestedFactor c{std::move(walls), {}, {}};
    const auto seen =
        static_cast<std::size_t>(std::ranges::count(c.walls, false, &TestedWall::at_least));
    if (std::ranges::count(c.walls, 0.0, &TestedWall::predicted) > 0)
        c.reason =
            "no factor: fewer than half of the study's walls fell under the stress of a test, "
            "so that there is no median to compare with; push them further "
            "(load.max_displacement, solver.kinematics = finite)";
    else if (seen < kFewestTests)
        c.reason = "no factor: " + counted(seen, "test has", "tests have") +
                   " a measured value, and " + std::to_string(kFewestTests) + " are needed";
    else
        c.factor = estimated_factor(c.walls);
    return c;
}

Table factor_table(const TestedFactor& drift, const TestedFactor& force)
{
    Table t;
    t.title = "Tests over the walls of the study";
    t.caption = "Predicted: median of the study's walls under the same stress (Kaplan and "
                "Meier). Drop: displacement in mm at which the force fell to the ultimate "
                "share of the peak; peak: force in kN. Interval: of the ratio of one further "
                "test, by all other tests (90 %, hierarchical normal model of ln ratio, "
                "docs/fragility.md).";
    t.keys = 2;
    t.head = {"wall",
              "measured value",
              "stress [MPa]",
              {"test", kCensored},
              "predicted",
              {"ratio", kCensored},
              {"interval by the others", kRange},
              {"note", kNote}};
    add_rows_of(force, "peak [kN]", 1, t);
    add_rows_of(drift, "drop [mm]", 1, t);
    return t;
}

std::string factor_lines(const TestedFactor& drift, const TestedFactor& force,
                         const std::string& source)
{
    return "# Test over prediction: " + source +
           ". sigma_log holds the doubt of the median.\n[fragility]\n" +
           line_of("model_factor", drift) + line_of("model_factor_force", force);
}

} // namespace app
