#include "app/calibration/calibration_output.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "core/normal.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr int kDensitySteps = 120;
constexpr double kDensityEnd = 3.5; ///< [standard deviations of the prior]

/// Kernel density of draws at x (Silverman 1986, eq. 3.30 with the standard deviation).
Series density_of(const std::string& name, const std::vector<double>& draws)
{
    const auto n = static_cast<double>(draws.size());
    double mean = 0.0, square = 0.0;
    for (const double x : draws) mean += x / n;
    for (const double x : draws) square += (x - mean) * (x - mean) / n;
    const double width = 1.06 * std::sqrt(std::max(square, 1e-12)) * std::pow(n, -0.2);
    Series s{.name = name};
    for (int i = 0; i <= kDensitySteps; ++i) {
        const double x = kDensityEnd * (2.0 * i / kDensitySteps - 1.0);
        double sum = 0.0;
        for (const double d : draws) sum += core::normal_density((x - d) / width);
        s.x.push_back(x);
        s.y.push_back(sum / (n * width));
    }
    return s;
}

void add_further(Chart& chart, const CalibrationReport& r, std::size_t kind,
                 const Eigen::MatrixXd& ln, const std::string& name, const char* colour)
{
    Band band(colour);
    band.line.name = name;
    for (std::size_t a = 0; a < r.data->answers.size(); ++a) {
        if (r.data->answers[a].kind != kind) continue;
        std::vector<double> values;
        for (Eigen::Index k = 0; k < ln.rows(); ++k)
            values.push_back(std::exp(ln(k, static_cast<Eigen::Index>(a))));
        const DrawsSummary s = summary_of(values);
        band.add(r.data->answers[a].stress / 1e6, s.median, s.interval.lower, s.interval.upper);
    }
    add_band(chart, band);
}

} // namespace

std::string density_picture(const CalibrationReport& r)
{
    Chart c;
    c.title = "Inputs before and after the tests";
    c.x_label = "standard deviations of the prior from its median (normal scores)";
    c.y_label = "density";
    Series prior{.name = "prior of each", .line = LineStyle::dashed};
    for (int i = 0; i <= kDensitySteps; ++i) {
        prior.x.push_back(kDensityEnd * (2.0 * i / kDensitySteps - 1.0));
        prior.y.push_back(core::normal_density(prior.x.back()));
    }
    c.series.push_back(std::move(prior));
    const Taught& answer = answer_of((*r.study).calibration, *r.run);
    for (std::size_t i = 0; i < r.inputs->inputs.size(); ++i) {
        std::vector<double> draws;
        for (const uq::CalibrationPoint& at : answer.points)
            draws.push_back((r.inputs->factor * at.z)(static_cast<Eigen::Index>(i)));
        c.series.push_back(density_of(r.inputs->inputs[i].key, draws));
    }
    return line_chart(c);
}

std::string further_wall_picture(const CalibrationReport& r, std::size_t kind)
{
    const TestedQuantity& q = r.data->quantities[kind];
    const std::string what = with_unit(q.words, q.unit);
    Chart c;
    c.title = "Tests and one further wall: median and 90 %";
    c.x_label = "vertical stress [MPa]";
    c.y_label = what;
    add_further(c, r, kind, r.run->prior, "prior", palette(2));
    add_further(c, r, kind, answer_of((*r.study).calibration, *r.run).further, "with the tests",
                palette(0));
    Series tests{.name = "tests", .colour = "#222", .line = LineStyle::none, .points = true};
    for (const UsedTest& used : r.data->tests) {
        const CalibratedAnswer& a = r.data->answers[used.answer];
        if (a.kind != kind) continue;
        tests.x.push_back(a.stress / 1e6);
        tests.y.push_back(used.value);
    }
    c.series.push_back(std::move(tests));
    return line_chart(c);
}

} // namespace app
