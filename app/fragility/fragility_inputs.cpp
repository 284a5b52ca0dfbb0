#include "app/fragility/fragility_inputs.hpp"

#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/study/answers/fragility_text.hpp"
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

Sample sample_of(const StudyWalls& walls, const StudyLevel& level, const WallNumber& response)
{
    WallList used;
    for (const StudyWall& w : level.walls)
        if (std::isfinite(response.reading(w.reading, walls.height)) &&
            !(response.ends_with_push && response.is_bound(w.reading)))
            used.push_back(&w);
    const auto n = static_cast<Eigen::Index>(used.size());
    const auto d = static_cast<Eigen::Index>(walls.inputs.size());
    Sample s{Eigen::MatrixXd(n, d), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const StudyWall& w = *used[i];
        for (Eigen::Index j = 0; j < d; ++j) s.x(i, j) = w.inputs[j];
        s.y(i) = response.reading(w.reading, walls.height) * response.unit.scale;
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
    return e ? with_interval(e->value, e->interval, 2) : Number{};
}

const char* note_on(const Influence& i, const Influences& all)
{
    if (all.walls < kFewestWalls) return "Fewer than 4 walls.";
    if (!i.pearson) return "The input does not vary.";
    if (!std::isfinite(all.r2)) return "Too few walls for a regression.";
    return i.standardised ? "" : "The regression cannot tell this input from the others.";
}

void add_rows(const StudyWalls& walls, const StudyLevel& level, const WallNumber& response,
              Table& t)
{
    const Influences found = influences(walls, level, response);
    for (const Influence& i : found.inputs)
        add_row(t,
                {stress_cell(level.stress), words(response), i.key, count(found.walls),
                 estimate_cell(i.pearson), estimate_cell(i.spearman), estimate_cell(i.partial),
                 estimate_cell(i.standardised), plain_number(found.r2, 2)},
                note_on(i, found));
}

} // namespace

Influences influences(const StudyWalls& walls, const StudyLevel& level,
                      const WallNumber& response)
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
        for (const WallNumber* const response :
             {&wall_number("peak_force"), &wall_number("ultimate_displacement")})
            add_rows(walls, level, *response, t);
    return t;
}

std::vector<NamedPicture> input_pictures(const StudyWalls& walls)
{
    std::vector<NamedPicture> pictures;
    const std::optional<std::size_t> input = input_of(walls, "joint.friction_angle");
    if (!input) return pictures;
    for (const StudyLevel& level : walls.levels) {
        if (level.walls.empty()) continue;
        const std::string stress = stress_text(level.stress);
        Chart c;
        c.title = "Peak force and joint friction angle, " + stress;
        c.x_label = "joint friction angle [deg]";
        c.y_label = "peak force [kN]";
        for (const int mode : {kRocking, kSliding, kMixed}) {
            constexpr std::size_t kColours[] = {0, 2, 1};
            const std::string colour = palette(kColours[mode]);
            Series dots{mode_name(mode), {}, {}, colour, LineStyle::none, 1.0, true};
            for (const StudyWall* w : walls_of(level, mode)) {
                dots.x.push_back(w->inputs[*input]);
                dots.y.push_back(peak_force(w->reading) * 1e-3);
            }
            if (!dots.x.empty()) c.series.push_back(dots);
        }
        pictures.push_back({"peak_force_friction_" + file_name(stress),
                            "peak force of each wall over its joint friction angle, " + stress,
                            line_chart(c)});
    }
    return pictures;
}

} // namespace app
