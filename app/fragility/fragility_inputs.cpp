#include "app/fragility/fragility_inputs.hpp"

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

std::string cell(const std::optional<uq::Estimate>& e)
{
    return e ? with_interval(e->value, e->interval.lower, e->interval.upper, 2)
             : "does not vary";
}

std::optional<uq::Regression> regression(const Sample& s, double confidence)
{
    if (s.x.rows() < s.x.cols() + 4) return {};
    uq::RegressionOptions options;
    options.scale = uq::RegressionScale::ranks;
    options.confidence = confidence;
    return uq::regress(s.x, s.y, options);
}

void add_rows(const StudyWalls& walls, const StudyLevel& level, bool force, Table& t)
{
    constexpr Eigen::Index kFewest = 4; // of a correlation
    const Sample s = sample_of(walls, level, force);
    const double confidence = walls.study.fragility.confidence;
    const auto model = regression(s, confidence);
    for (std::size_t i = 0; i < walls.inputs.size(); ++i) {
        std::vector<std::string> row = {number(level.stress * 1e-6, 12),
                                        force ? "peak force" : "ultimate displacement",
                                        walls.inputs[i].key, std::to_string(s.y.size())};
        const auto column = static_cast<Eigen::Index>(i);
        if (s.y.size() < kFewest) {
            row.insert(row.end(), {"fewer than 4 walls", "", "", ""});
        } else {
            row.push_back(cell(uq::pearson(s.x.col(column), s.y, confidence)));
            row.push_back(cell(uq::spearman(s.x.col(column), s.y, confidence)));
            const bool told = model && model->inputs[i].identifiable;
            row.push_back(told ? cell(model->inputs[i].standardised)
                               : std::string(model ? "not identifiable" : "too few walls"));
            row.push_back(model ? fixed(model->r2, 2) : "");
        }
        t.rows.push_back(row);
    }
}

} // namespace

Table input_table(const StudyWalls& walls)
{
    Table t;
    t.caption =
        "Influence of the inputs on peak force and ultimate displacement (the paper, "
        "Fig. 12). " +
        counts_text(drift_data(walls)) +
        ". r: Pearson; rank r: Spearman; rank "
        "regression: standardised coefficient with all inputs together, R2 its share of "
        "the variance of the ranks. Brackets: " +
        percent_text(walls.study.fragility.confidence) +
        " intervals. n: walls used; failed walls are left out, and for the displacement "
        "also walls on which the force did not fall to 80 % of the peak, so that it "
        "tells of walls that fell. Inputs with values per joint: mean over the joints.";
    t.head = {"stress [MPa]", "response", "input", "n", "r", "rank r", "rank regression", "R2"};
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
