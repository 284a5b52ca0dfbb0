/// Error of a mean against the number of samples, for each design. uq_convergence FOLDER
#include "bench/uq/uq_convergence.hpp"

#include "app/output/atomic_output.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "bench/report.hpp"
#include "core/moments.hpp"
#include "uq/designs/design.hpp"
#include "uq/designs/stream.hpp"
#include "uq/estimates/estimate.hpp"

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>

namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kReplicates = 100;

struct DesignRow {
    std::string name;
    uq::DesignKind kind;
    int largest;        ///< samples
    const char* colour; ///< colour-blind safe (Okabe and Ito)
};

const std::vector<DesignRow> kDesigns{
    {"Monte Carlo", uq::DesignKind::monte_carlo, 4096, "#000000"},
    {"Latin hypercube", uq::DesignKind::latin_random, 4096, "#0072b2"},
    {"optimised Latin hypercube", uq::DesignKind::latin_optimised, 256, "#009e73"},
    {"Sobol', scrambled", uq::DesignKind::sobol, 4096, "#d55e00"}};

/// Root mean square error of the mean over the replicates, and its standard error.
struct ErrorPoint {
    int n;
    double rms, rms_error;
    double naive; ///< mean of s / sqrt(n) of one design: what it says of itself
};

/// [response][design] -> points
using Errors = std::map<std::string, std::map<std::string, std::vector<ErrorPoint>>>;

ErrorPoint point(int n, const std::vector<double>& off, double naive)
{
    std::vector<double> squares;
    for (const double e : off) squares.push_back(e * e);
    const uq::Estimate mse = uq::estimate_mean(squares);
    const double rms = std::sqrt(mse.value);
    return {n, rms, mse.std_error / (2.0 * rms), naive};
}

Errors measure()
{
    const auto responses = bench::known_responses();
    Errors errors;
    for (const DesignRow& design : kDesigns)
        for (int n = 16; n <= design.largest; n *= 2) {
            std::vector<std::vector<double>> off(responses.size());
            std::vector<double> naive(responses.size(), 0.0);
            for (int r = 0; r < kReplicates; ++r) {
                const auto seed = uq::replicate_seed(kSeed, static_cast<std::uint64_t>(r));
                const Eigen::MatrixXd x =
                    bench::table5(uq::unit_cube({design.kind, {n}, 5, seed}));
                for (std::size_t k = 0; k < responses.size(); ++k) {
                    const Eigen::VectorXd y = responses[k].evaluate(x);
                    const core::Moments m =
                        core::moments({y.data(), static_cast<std::size_t>(n)});
                    off[k].push_back(m.mean - responses[k].mean);
                    naive[k] += m.sd / std::sqrt(n) / kReplicates;
                }
            }
            for (std::size_t k = 0; k < responses.size(); ++k)
                errors[responses[k].name][design.name].push_back(point(n, off[k], naive[k]));
            std::fprintf(stderr, "%s %d\n", design.name.c_str(), n);
        }
    return errors;
}

struct Slope {
    double value, std_error;
};

/// Slope of ln rms over ln n, each point weighted by its own doubt.
Slope slope(const std::vector<ErrorPoint>& points)
{
    double w = 0.0, wx = 0.0, wy = 0.0;
    const auto weight = [](const ErrorPoint& p) { return std::pow(p.rms / p.rms_error, 2); };
    for (const ErrorPoint& p : points) {
        w += weight(p);
        wx += weight(p) * std::log(p.n);
        wy += weight(p) * std::log(p.rms);
    }
    double xx = 0.0, xy = 0.0;
    for (const ErrorPoint& p : points) {
        const double dx = std::log(p.n) - wx / w;
        xx += weight(p) * dx * dx;
        xy += weight(p) * dx * (std::log(p.rms) - wy / w);
    }
    return {xy / xx, 1.0 / std::sqrt(xx)};
}

std::string text(double x, const char* format)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, x);
    return buffer;
}

app::Table slopes(const Errors& errors)
{
    app::Table t;
    t.caption = "Slopes of ln error over ln n, and the error of 64 samples";
    t.head = {"response",
              "design",
              "slope",
              "std. error",
              "rms error at n = 64",
              "of Monte Carlo's [%]",
              "s / sqrt(n) over rms at n = 64"};
    for (const auto& response : bench::known_responses())
        for (const DesignRow& d : kDesigns) {
            const auto& points = errors.at(response.name).at(d.name);
            const Slope s = slope(points);
            const ErrorPoint& p = points[2];
            const double mc = errors.at(response.name).at(kDesigns[0].name)[2].rms;
            t.rows.push_back({response.name, d.name, text(s.value, "%.2f"),
                              text(s.std_error, "%.2f"), text(p.rms, "%.2e"),
                              text(100.0 * p.rms / mc, "%.0f"), text(p.naive / p.rms, "%.1f")});
        }
    return t;
}

app::Table all_points(const Errors& errors)
{
    app::Table t;
    t.caption = "Root mean square error of the mean over " + std::to_string(kReplicates) +
                " replicates";
    t.head = {"response",  "design",           "n",
              "rms error", "std. error of it", "mean s / sqrt(n) of one design"};
    for (const auto& response : bench::known_responses())
        for (const DesignRow& d : kDesigns)
            for (const ErrorPoint& p : errors.at(response.name).at(d.name))
                t.rows.push_back({response.name, d.name, std::to_string(p.n),
                                  text(p.rms, "%.3e"), text(p.rms_error, "%.1e"),
                                  text(p.naive, "%.3e")});
    return t;
}

app::Series series(const Errors& errors, const std::string& response, const DesignRow& d,
                   app::LineStyle line)
{
    app::Series s{.colour = d.colour, .line = line, .points = true};
    for (const ErrorPoint& p : errors.at(response).at(d.name)) {
        s.x.push_back(p.n);
        s.y.push_back(p.rms / (p.naive * std::sqrt(p.n))); // over s
    }
    return s;
}

std::string picture(const Errors& errors)
{
    app::Chart chart;
    chart.title = "Error of the mean: smooth response (solid), indicator (dashed)";
    chart.x_label = "samples";
    chart.y_label = "rms error of the mean / standard deviation of the response";
    chart.log_x = chart.log_y = true;
    chart.width = 860.0;
    chart.height = 560.0;
    for (const DesignRow& d : kDesigns) {
        chart.series.push_back(series(errors, "smooth", d, app::LineStyle::solid));
        chart.series.back().name =
            d.name + ", slope " + text(slope(errors.at("smooth").at(d.name)).value, "%.2f") +
            " / " + text(slope(errors.at("indicator").at(d.name)).value, "%.2f");
        chart.series.push_back(series(errors, "indicator", d, app::LineStyle::dashed));
    }
    return app::line_chart(chart);
}

constexpr const char* kOpening =
    R"(The five variables of Table 5 of the paper, 100 designs of each kind and size with seeds of their own, against
means known in closed form (bench/uq/uq_convergence_responses.cpp): **smooth** in all five variables; **kinked**, the weaker of two
mechanisms; **indicator**, the share of walls on one side of a limit, as failure modes are counted. Optimised hypercubes end at 256.

![error of the mean against the number of samples](uq_convergence.svg)

`s / sqrt(n)` is what one design says of its own error if its samples are taken for independent: true of Monte Carlo,
far too large for the others. Their error is known from replicates: studies with other seeds.

A Latin hypercube takes away the error of the additive part of a response; what is left, interactions and
jumps, falls like Monte Carlo's, so its slope is no constant. Slopes in the legend: smooth / indicator.)";

} // namespace

int main(int argc, char** argv)
try {
    if (argc != 2) {
        std::fputs("usage: uq_convergence FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const Errors errors = measure();
    const bench::Report report{
        "Convergence of means",
        kOpening,
        {{"slopes", "Slopes", "", slopes(errors)}, {"", "All errors", "", all_points(errors)}}};
    bench::write_report(folder / "uq_convergence.md", report);
    app::write_file(folder / "uq_convergence.svg", picture(errors));
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
}
