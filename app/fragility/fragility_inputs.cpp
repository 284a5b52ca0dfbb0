#include "app/fragility/fragility_inputs.hpp"

#include "app/fragility/table_texts.hpp"
#include "app/output/chart_svg.hpp"
#include "app/study/fragility_text.hpp"
#include "app/text/number_text.hpp"
#include "uq/sensitivity/correlation_measures.hpp"
#include "uq/sensitivity/regression.hpp"

#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr std::size_t kFewestWalls = 4; // of a correlation

/// Walls that say something about a response: inputs and answer.
struct Sample {
    Eigen::MatrixXd x;
    Eigen::VectorXd y;
};

Sample sample_of(const StudyWalls& walls, const StudyLevel& level, Response response)
{
    const bool force = response == Response::peak_force;
    WallList used;
    for (const StudyWall& w : level.walls)
        if (force ? w.reading.peak.has_value() : is_observed(w.reading.ultimate))
            used.push_back(&w);
    const auto n = static_cast<Eigen::Index>(used.size());
    const auto d = static_cast<Eigen::Index>(walls.inputs.size());
    Sample s{Eigen::MatrixXd(n, d), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const StudyWall& w = *used[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < d; ++j) s.x(i, j) = w.inputs[static_cast<std::size_t>(j)];
        s.y(i) = force ? w.reading.peak->force * 1e-3 : w.reading.ultimate.displacement * 1e3;
    }
    return s;
}

std::optional<uq::Regression> regression(const Sample& s, double confidence)
{
    if (s.x.rows() < s.x.cols() + 4) return {};
    uq::RegressionOptions options;
    options.scale = uq::RegressionScale::ranks;
    options.confidence = confidence;
    return uq::regress(s.x, s.y, options);
}

Number estimate_cell(const std::optional<uq::Estimate>& e)
{
    if (!e) return {};
    return with_interval(e->value, e->interval.lower, e->interval.upper, 2);
}

const char* note_on(const Influence& i, const Influences& all)
{
    if (all.walls < kFewestWalls) return "Fewer than 4 walls.";
    if (!i.pearson) return "The input does not vary.";
    if (!std::isfinite(all.r2)) return "Too few walls for a regression.";
    return i.standardised ? "" : "The regression cannot tell this input from the others.";
}

void add_rows(const StudyWalls& walls, const StudyLevel& level, Response response, Table& t)
{
    const Influences found = influences(walls, level, response);
    for (const Influence& i : found.inputs)
        t.rows.push_back({given(level.stress / 1e6), words(response), i.key,
                          count(static_cast<double>(found.walls)), estimate_cell(i.pearson),
                          estimate_cell(i.spearman), estimate_cell(i.partial),
                          estimate_cell(i.standardised), plain_number(found.r2, 2),
                          note_on(i, found)});
}

} // namespace

const char* words(Response response)
{
    return response == Response::peak_force ? "peak force" : "ultimate displacement";
}

Influences influences(const StudyWalls& walls, const StudyLevel& level, Response response)
{
    const double confidence = walls.study.fragility.confidence;
    const Sample s = sample_of(walls, level, response);
    const auto model = regression(s, confidence);
    Influences found{static_cast<std::size_t>(s.y.size()),
                     model ? model->r2 : std::numeric_limits<double>::quiet_NaN(),
                     {}};
    for (std::size_t i = 0; i < walls.inputs.size(); ++i) {
        found.inputs.push_back({walls.inputs[i].key, {}, {}, {}, {}});
        if (found.walls < kFewestWalls) continue;
        const auto column = s.x.col(static_cast<Eigen::Index>(i));
        found.inputs.back().pearson = uq::pearson(column, s.y, confidence);
        found.inputs.back().spearman = uq::spearman(column, s.y, confidence);
        if (!model || !model->inputs[i].identifiable) continue;
        found.inputs.back().standardised = model->inputs[i].standardised;
        found.inputs.back().partial = model->inputs[i].partial;
    }
    return found;
}

Table input_table(const StudyWalls& walls)
{
    Table t = titled_table("inputs", words_of(walls));
    t.keys = 3;
    t.head = {"stress [MPa]",
              "response",
              "input",
              "n",
              {"r", kInterval},
              {"rank r", kInterval},
              {"partial rank r", kInterval},
              {"rank regression", kInterval},
              "R2",
              {"note", kNote}};
    for (const StudyLevel& level : walls.levels)
        for (const Response r : {Response::peak_force, Response::ultimate})
            add_rows(walls, level, r, t);
    return t;
}

std::vector<NamedPicture> input_pictures(const StudyWalls& walls)
{
    std::vector<NamedPicture> pictures;
    std::size_t input = 0;
    while (input < walls.inputs.size() && walls.inputs[input].key != "joint.friction_angle")
        ++input;
    if (input == walls.inputs.size()) return pictures;
    for (const StudyLevel& level : walls.levels) {
        if (level.walls.empty()) continue;
        const std::string stress = number(level.stress / 1e6, 12) + " MPa";
        Chart c;
        c.title = "Peak force and joint friction angle, " + stress;
        c.x_label = "joint friction angle [deg]";
        c.y_label = "peak force [kN]";
        Series modes[3] = {{"rocking", {}, {}, "#0072B2", LineStyle::none, 1.0, true},
                           {"sliding", {}, {}, "#009E73", LineStyle::none, 1.0, true},
                           {"mixed", {}, {}, "#D55E00", LineStyle::none, 1.0, true}};
        for (const StudyWall& w : level.walls) {
            modes[mode_of(w)].x.push_back(w.inputs[input]);
            modes[mode_of(w)].y.push_back(peak_force(w.reading) * 1e-3);
        }
        for (const Series& s : modes)
            if (!s.x.empty()) c.series.push_back(s);
        pictures.push_back({"peak_force_friction_" + file_name(stress),
                            "peak force of each wall over its joint friction angle, " + stress,
                            line_chart(c)});
    }
    return pictures;
}

} // namespace app
