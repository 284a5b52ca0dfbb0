/// Labels in pictures of curves: none covers another, a curve, a mark or the frame.

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/study/study.hpp"
#include "app/input/study/study_file.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/output/picture/chart_labels.hpp"
#include "app/push/capacity_svg.hpp"
#include "app/sheet/sheet_command.hpp"
#include "app/study/other_way.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using app::Chart;
using app::ChartFrame;
using app::ChartLabel;

/// Force over movement, both as shares of the largest.
using Shape = std::function<double(double)>;

double ductile(double x) { return 1.0 - std::exp(-12.0 * x); }
double falls_at_once(double x) { return x < 0.05 ? x / 0.05 : 0.3; }
double falls_slowly(double x) { return std::min(1.0, 40.0 * x) * (1.0 - 0.7 * x); }
double wavy(double x) { return ductile(x) * (0.85 + 0.15 * std::sin(60.0 * x)); }

/// A wall that was pushed so far, with limit states by the rules of its study.
/// @param first force before the push, as a share
app::PushedWall wall_of(const app::Study& study, const Shape& shape, double first)
{
    constexpr int kPoints = 300;
    const double way = app::push_way(study.load).direction < 0 ? -1.0 : 1.0,
                 most = 0.03 * study.load.height, force = 50e3;
    app::PushedWall w;
    w.vertical_stress = 5e5;
    w.loads.height = study.load.height;
    for (int i = 0; i <= kPoints; ++i) {
        const double x = static_cast<double>(i) / kPoints;
        w.displacement.push_back(way * most * x);
        w.force.push_back(way * force * (first + (1.0 - first) * shape(x)));
    }
    app::ReadingRules rules = app::reading_rules(study);
    w.reading = app::read({w.displacement, w.force}, {}, rules);
    return w;
}

bool overlap(const ChartLabel& a, const ChartLabel& b)
{
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool inside(app::Pixel p, const ChartLabel& l)
{
    return p.x > l.low.x && p.x < l.high.x && p.y > l.low.y && p.y < l.high.y;
}

/// Names the first thing that a label covers; empty: nothing.
std::string covered(const Chart& chart)
{
    const ChartFrame f = app::lay_out_chart(chart);
    const std::vector<ChartLabel> labels = app::chart_labels(chart, f);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const ChartLabel& l = labels[i];
        if (l.low.x < f.left || l.high.x > f.right || l.low.y < f.top || l.high.y > f.bottom)
            return l.text + " leaves the frame";
        for (std::size_t k = 0; k < i; ++k)
            if (overlap(l, labels[k])) return l.text + " covers " + labels[k].text;
        for (const app::Series& s : chart.series)
            for (std::size_t k = 0; k < s.x.size(); ++k)
                if (inside(f.place(s.x[k], s.y[k]), l)) return l.text + " covers a curve";
        for (const app::ChartMark& m : chart.marks)
            if (inside(f.place(m.x, m.y), l)) return l.text + " covers a mark";
    }
    for (std::size_t i = 0; i < f.legend.size(); ++i) {
        const app::LegendEntry& e = f.legend[i];
        const double right =
            e.at.x + app::legend_sample(e) + 8.0 + app::text_width(e.name, 12.0);
        if (right > chart.width) return e.name + " leaves the page";
        for (std::size_t k = 0; k < i; ++k)
            if (f.legend[k].at.y == e.at.y && f.legend[k].at.x >= e.at.x)
                return e.name + " covers an entry of the legend";
    }
    return {};
}

std::vector<fs::path> shipped_studies()
{
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(DRYSTONE_SOURCE_DIR "/configs"))
        if (file.path().extension() == ".ini") files.push_back(file.path());
    std::ranges::sort(files);
    return files;
}

} // namespace

TEST_CASE("chart labels: of any shipped study with eight limit states none covers anything",
          "[app][chart_labels][repeats]")
{
    const std::vector<std::string> codes = {"fragility.limit_states=paper, ntc, ec8"};
    std::size_t numbered = 0;
    for (const fs::path& file : shipped_studies()) {
        const app::Study study = app::read_study(file.string(), codes);
        const app::ReadingRules rules = app::reading_rules(study);
        for (const Shape& shape :
             {Shape(ductile), Shape(falls_at_once), Shape(falls_slowly), Shape(wavy)})
            for (const double first : {0.0, 0.1}) {
                app::PushedWall w = wall_of(study, shape, first);
                w.other_way = {wall_of(study, falls_slowly, first)};
                INFO(file.filename().string() << ", the first at " << first);
                for (const bool both : {true, false}) {
                    if (!both) w.other_way.clear();
                    CHECK(covered(app::capacity_chart(rules, w)) == "");
                    const Chart small = app::sheet_curve(rules, w);
                    CHECK(covered(small) == "");
                    numbered += app::lay_out_chart(small).vertical.front().number > 0 ? 1 : 0;
                }
            }
    }
    CHECK(numbered > 100); // else nothing was crowded
}

TEST_CASE("chart labels: a sheet with many limit states gives most of its plot to the force",
          "[app][chart_labels]")
{
    const app::Study study =
        app::read_study(DRYSTONE_SOURCE_DIR "/configs/wall.ini",
                        std::vector<std::string>{"fragility.limit_states=paper, ntc, ec8, "
                                                 "ec8_secondary, collapse"});
    for (const Shape& shape : {Shape(ductile), Shape(falls_slowly)}) {
        const app::PushedWall w = wall_of(study, shape, 0.0);
        const Chart chart = app::sheet_curve(app::reading_rules(study), w);
        const ChartFrame f = app::lay_out_chart(chart);
        REQUIRE(f.legend.back().number >= 8);
        CHECK(f.y.high < 1.5 * 1e-3 * peak_force(w.reading));
        CHECK(chart.height <= 400.0); // what the page can give
        CHECK(covered(chart) == "");
    }
}

TEST_CASE("chart labels: few stand at their lines, many are numbers from the left with a key",
          "[app][chart_labels]")
{
    Chart chart{.x_label = "mm", .y_label = "kN"};
    chart.series = {{.name = "curve", .x = {0.0, 10.0, 30.0}, .y = {0.0, 50.0, 50.0}}};
    chart.vertical = {{20.0, "later 20.0 mm"}, {5.0, "early 5.0 mm"}};
    ChartFrame f = app::lay_out_chart(chart);
    CHECK(f.vertical[0].number == 0);
    CHECK(f.legend.size() == 1);
    for (int i = 0; i < 6; ++i)
        chart.vertical.push_back({10.0 + 0.01 * i, "state " + std::to_string(i)});
    f = app::lay_out_chart(chart);
    REQUIRE(f.legend.size() == 1 + 8);
    CHECK(f.vertical[0].number == 8);
    CHECK(f.vertical[1].number == 1);
    for (int i = 0; i < 6; ++i) CHECK(f.vertical[2 + i].number == 2 + i);
    CHECK(f.legend[1].name == "early 5.0 mm");
    CHECK(f.legend[8].name == "later 20.0 mm");
    CHECK(covered(chart) == "");
    // The middle of those that touch stays above the middle of their lines.
    CHECK((f.vertical[2].at + f.vertical[7].at) / 2 ==
          Approx(f.place(10.025, 0.0).x).epsilon(1e-6));
}

TEST_CASE("chart labels: a mark whose place is taken has its label elsewhere, with a line",
          "[app][chart_labels]")
{
    Chart chart{.x_label = "mm", .y_label = "kN"};
    app::Series noise;
    for (int i = 0; i <= 600; ++i) {
        noise.x.push_back(0.05 * i);
        noise.y.push_back(i < 400 ? 20.0 + 20.0 * std::sin(0.9 * i) : 0.0);
    }
    chart.series = {noise};
    chart.marks = {{10.0, 20.0, "peak in the middle"}};
    const auto labels = app::chart_labels(chart, app::lay_out_chart(chart));
    REQUIRE(labels.size() == 1);
    CHECK(labels.front().point.has_value());
    CHECK(covered(chart) == "");
    chart.series[0].y.assign(noise.x.size(), 0.0);
    CHECK_FALSE(app::chart_labels(chart, app::lay_out_chart(chart)).front().point.has_value());
}
