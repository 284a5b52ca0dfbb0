#include "app/fragility/fragility_inputs.hpp"

#include "app/fragility/table_texts.hpp"
#include "app/input/number_text.hpp"
#include "app/output/chart_svg.hpp"
#include "app/study/fragility_text.hpp"
#include "uq/sensitivity/correlation_measures.hpp"
#include "uq/sensitivity/regression.hpp"

#include <cmath>
#include <optional>

namespace app {
namespace {

/// Walls that say something about a response: inputs and answer.
struct Sample {
    Eigen::MatrixXd x;
    Eigen::VectorXd y;
};

Sample sample_of(const StudyWalls& walls, const StudyLevel& level, bool force)
{
    std::vector<const StudyWall*> used;
    for (const StudyWall& w : level.walls) {
        const bool observed = w.ultimate.reading == fragility::Reading::observed;
        if (force ? std::isfinite(w.peak_force) : observed) used.push_back(&w);
    }
    const auto n = static_cast<Eigen::Index>(used.size());
    const auto d = static_cast<Eigen::Index>(walls.inputs.size());
    Sample s{Eigen::MatrixXd(n, d), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const StudyWall& w = *used[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < d; ++j) s.x(i, j) = w.inputs[static_cast<std::size_t>(j)];
        s.y(i) = force ? w.peak_force * 1e-3 : w.ultimate.displacement * 1e3;
    }
    return s;
}

Number estimate_cell(const std::optional<uq::Estimate>& e)
{
    if (!e) return {};
    return with_interval(e->value, e->interval.lower, e->interval.upper, 2);
}

std::optional<uq::Regression> regression(const Sample& s, double confidence)
{
    if (s.x.rows() < s.x.cols() + 4) return {};
    uq::RegressionOptions options;
    options.scale = uq::RegressionScale::ranks;
    options.confidence = confidence;
    return uq::regress(s.x, s.y, options);
}

/// Correlations, regression and a note on one input.
void add_measures(const Sample& s, std::size_t input, double confidence,
                  const std::optional<uq::Regression>& model, Row& row)
{
    const auto column = static_cast<Eigen::Index>(input);
    const auto r = uq::pearson(s.x.col(column), s.y, confidence);
    const bool told = model && model->inputs[input].identifiable;
    const char* const note = !r       ? "The input does not vary."
                             : !model ? "Too few walls for a regression."
                             : !told  ? "The regression cannot tell this input from the others."
                                      : "";
    row.emplace_back(estimate_cell(r));
    row.emplace_back(estimate_cell(uq::spearman(s.x.col(column), s.y, confidence)));
    row.emplace_back(told ? estimate_cell(model->inputs[input].standardised) : Number{});
    row.emplace_back(model ? plain_number(model->r2, 2) : Number{});
    row.emplace_back(note);
}

void add_rows(const StudyWalls& walls, const StudyLevel& level, bool force, Table& t)
{
    constexpr Eigen::Index kFewest = 4; // of a correlation
    const Sample s = sample_of(walls, level, force);
    const double confidence = walls.study.fragility.confidence;
    const auto model = regression(s, confidence);
    for (std::size_t i = 0; i < walls.inputs.size(); ++i) {
        Row row = {given(level.stress * 1e-6), force ? "peak force" : "ultimate displacement",
                   walls.inputs[i].key, count(static_cast<double>(s.y.size()))};
        if (s.y.size() < kFewest) {
            row.insert(row.end(), {{}, {}, {}, {}, "Fewer than 4 walls."});
        } else {
            add_measures(s, i, confidence, model, row);
        }
        t.rows.push_back(std::move(row));
    }
}

} // namespace

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
              {"rank regression", kInterval},
              "R2",
              {"note", kNote}};
    for (const StudyLevel& level : walls.levels)
        for (const bool force : {true, false}) add_rows(walls, level, force, t);
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
        const std::string stress = number(level.stress * 1e-6, 12) + " MPa";
        Chart c;
        c.title = "Peak force and joint friction angle, " + stress;
        c.x_label = "joint friction angle [deg]";
        c.y_label = "peak force [kN]";
        Series modes[2] = {{"rocking", {}, {}, "#0072B2", LineStyle::none, 1.0, true},
                           {"mixed", {}, {}, "#D55E00", LineStyle::none, 1.0, true}};
        for (const StudyWall& w : level.walls) {
            modes[w.mode].x.push_back(w.inputs[input]);
            modes[w.mode].y.push_back(w.peak_force * 1e-3);
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
