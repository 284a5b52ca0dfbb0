#include "app/output/picture/chart_svg.hpp"

#include "app/output/picture/chart_frame.hpp"
#include "tests/scenes/xml_tree.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using app::Chart;
using app::line_chart;
using app::Series;
using Catch::Matchers::VectorContains;
using scenes::elements;
using scenes::parse_xml;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

Chart capacity()
{
    Chart chart{.title = "Capacity", .x_label = "displacement [mm]", .y_label = "force [kN]"};
    Series curve{.name = "model"};
    for (int i = 0; i <= 60; ++i) {
        curve.x.push_back(0.5 * i);
        curve.y.push_back(50.0 * (1.0 - std::exp(-0.5 * i)));
    }
    chart.series = {curve};
    return chart;
}

/// The data lines; grid and axes are other elements.
std::size_t lines_in(const Chart& chart)
{
    return elements(parse_xml(line_chart(chart)), "polyline").size();
}

} // namespace

TEST_CASE("chart: all points lie inside the frame", "[app][chart_svg]")
{
    Chart chart = capacity();
    chart.log_x = GENERATE(false, true);
    chart.log_y = GENERATE(false, true);
    chart.series.push_back({.name = "other", .x = {0.01, 1e3}, .y = {1e-3, 70.0}});
    chart.vertical = {{400.0, "far to the right"}};
    const app::ChartFrame frame = app::lay_out_chart(chart);
    for (const auto& line : elements(parse_xml(line_chart(chart)), "polyline"))
        for (const auto& [x, y] : scenes::points_of(line)) {
            CHECK(x >= frame.left - 1.0); // 2 % of a tick step
            CHECK(x <= frame.right + 1.0);
            CHECK(y >= frame.top + app::kLabelRow); // below the label of the reference line
            CHECK(y <= frame.bottom + 2.0);
        }
    CHECK(frame.left < frame.right);
    CHECK(frame.right <= chart.width);
    CHECK(frame.bottom <= chart.height);
}

TEST_CASE("chart: a value is where the ticks say it is", "[app][chart_svg]")
{
    const app::ChartFrame frame = app::lay_out_chart(capacity());
    CHECK(frame.x.low == 0.0);
    CHECK(frame.x.high == 30.0);
    CHECK(frame.place(15.0, 0.0).x == Approx((frame.left + frame.right) / 2));
    CHECK(frame.place(0.0, frame.y.high).y == Approx(frame.top));
}

TEST_CASE("chart: a value that cannot be drawn breaks the line", "[app][chart_svg]")
{
    Chart chart = capacity();
    CHECK(lines_in(chart) == 1);
    chart.series[0].y[20] = kNan;
    chart.series[0].x[40] = std::numeric_limits<double>::infinity();
    CHECK(lines_in(chart) == 3);
    chart.log_y = true; // the first value is 0
    CHECK(lines_in(chart) == 3);
    chart.series[0].y[10] = -1.0;
    CHECK(lines_in(chart) == 4);
}

TEST_CASE("chart: a value between two gaps is a dot", "[app][chart_svg]")
{
    Chart chart = capacity();
    chart.series[0].y[1] = kNan;
    CHECK(elements(parse_xml(line_chart(chart)), "circle").size() == 1);
}

TEST_CASE("chart: points are drawn where asked for, in the legend too", "[app][chart_svg]")
{
    Chart chart = capacity();
    chart.series[0].points = true;
    chart.series[0].line = app::LineStyle::none;
    CHECK(elements(parse_xml(line_chart(chart)), "circle").size() == 61 + 1);
    CHECK(lines_in(chart) == 0);
}

TEST_CASE("chart: curves of one name share a colour and one entry of the legend",
          "[app][chart_svg]")
{
    Chart chart = capacity();
    chart.series[0].name = "tests";
    chart.series.push_back(chart.series[0]);
    chart.series.push_back(chart.series[0]);
    chart.series[2].name = "model";
    chart.series.push_back(chart.series[0]);
    chart.series[3].name = "";
    const app::ChartFrame frame = app::lay_out_chart(chart);
    CHECK(frame.legend.size() == 2);
    CHECK(frame.colours[0] == frame.colours[1]);
    CHECK(frame.colours[2] != frame.colours[0]);
    CHECK(frame.colours[3] != frame.colours[0]);
}

TEST_CASE("chart: a long legend takes more rows and stays on the page", "[app][chart_svg]")
{
    Chart chart = capacity();
    for (int i = 0; i < 9; ++i) {
        chart.series.push_back(chart.series[0]);
        chart.series.back().name =
            "a rather long name of a series, number " + std::to_string(i);
    }
    const app::ChartFrame frame = app::lay_out_chart(chart);
    for (const app::LegendEntry& entry : frame.legend) {
        CHECK(entry.at.x + app::text_width(entry.name, 12.0) < chart.width);
        CHECK(entry.at.y < frame.top);
    }
}

TEST_CASE("chart: no label of a reference line runs over another line", "[app][chart_svg]")
{
    Chart chart = capacity();
    const auto numbers = [&](std::vector<app::ReferenceLine> lines) {
        chart.vertical = std::move(lines);
        std::vector<int> all;
        for (const app::VerticalLabel& label : app::lay_out_chart(chart).vertical)
            all.push_back(label.number);
        return all;
    };
    CHECK(numbers({{10.0, "peak 10.0 mm"}, {22.0, "drop 22.0 mm"}}) == std::vector<int>{0, 0});
    CHECK(numbers({{10.0, "peak 10.0 mm"}, {11.5, "drop 11.5 mm"}}) == std::vector<int>{1, 2});
    // a label at the right end stands to the left of its line
    CHECK(numbers({{26.0, "end"}, {29.9, "last one of all"}}) == std::vector<int>{1, 2});
}

TEST_CASE("chart: a horizontal label goes where no line runs", "[app][chart_svg]")
{
    Chart chart = capacity(); // the curve stays at 50, right above the line
    chart.series.push_back({.x = {0.0, 1.0}, .y = {60.0, 60.0}}); // makes room above
    chart.horizontal = {{49.0, "98 %"}};
    const auto texts = elements(parse_xml(line_chart(chart)), "text");
    const auto at = std::find_if(texts.begin(), texts.end(),
                                 [](const scenes::Xml& t) { return t.data() == "98 %"; });
    REQUIRE(at != texts.end());
    const app::ChartFrame frame = app::lay_out_chart(chart);
    const bool above = scenes::number_of(*at, "y") < frame.place(0.0, 49.0).y;
    const bool right = scenes::number_of(*at, "x") > (frame.left + frame.right) / 2;
    CHECK_FALSE((above && right));
}

TEST_CASE("chart: the axis on top is a factor of the one below", "[app][chart_svg]")
{
    Chart chart = capacity();
    chart.top = app::TopAxis{"drift [%]", 0.1}; // 30 mm: 3 %
    const app::ChartFrame frame = app::lay_out_chart(chart);
    bool found = false;
    for (const auto& text : elements(parse_xml(line_chart(chart)), "text"))
        if (text.data() == "1.5") {
            found = true;
            CHECK(scenes::number_of(text, "x") ==
                  Approx(frame.place(15.0, 0.0).x).margin(0.005)); // two decimals
        }
    CHECK(found);
}

TEST_CASE("chart: a curve near zero is read from zero, one far away is not", "[app][chart_svg]")
{
    Chart chart{.series = {{.x = {2.0, 10.0}, .y = {109.0, 112.0}}}};
    const app::ChartFrame frame = app::lay_out_chart(chart);
    CHECK(frame.x.low == 0.0);
    CHECK(frame.y.low > 100.0);
}

TEST_CASE("chart: a mark shows its point and text", "[app][chart_svg]")
{
    Chart chart = capacity();
    chart.marks = {{10.0, 49.7, "49.7 kN"}, {5.0, kNan, "nowhere"}};
    const auto page = parse_xml(line_chart(chart));
    REQUIRE(elements(page, "circle").size() == 1);
    const app::Pixel at = app::lay_out_chart(chart).place(10.0, 49.7);
    CHECK(scenes::number_of(elements(page, "circle")[0], "cx") == Approx(at.x).margin(0.005));
    CHECK(scenes::number_of(elements(page, "circle")[0], "cy") == Approx(at.y).margin(0.005));
    CHECK_THAT(scenes::texts(page), VectorContains(std::string("49.7 kN")));
    CHECK_THAT(scenes::texts(page), !VectorContains(std::string("nowhere")));
}

TEST_CASE("chart: nothing to show is an empty frame without a NaN", "[app][chart_svg]")
{
    const Chart chart =
        GENERATE(Chart{}, Chart{.series = {{.name = "none"}}},
                 Chart{.series = {{.x = {kNan, 1.0}, .y = {1.0, kNan}}}},
                 Chart{.series = {{.x = {2.0}, .y = {3.0}}}},
                 Chart{.series = {{.x = {-1.0}, .y = {0.0}}}, .log_x = true, .log_y = true},
                 Chart{.vertical = {{kNan, "none"}}, .horizontal = {{kNan, "none"}}});
    const std::string text = line_chart(chart);
    CHECK(scenes::texts(parse_xml(text)).size() >= 4); // ticks
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("inf") == std::string::npos);
}

TEST_CASE("chart: a line of very many points shows one in each pixel", "[app][chart_svg]")
{
    const auto size = [](int points) {
        Series s;
        for (int i = 0; i < points; ++i) {
            s.x.push_back(std::sin(1e-3 * i));
            s.y.push_back(std::cos(1e-3 * i));
        }
        return line_chart(Chart{.series = {s}}).size();
    };
    CHECK(size(10'000) > 100'000);
    CHECK(size(20'000) < size(10'000));
}

TEST_CASE("chart: unequal lengths and a tiny page are refused", "[app][chart_svg]")
{
    CHECK_THROWS_AS(line_chart(Chart{.series = {{.x = {1.0}}}}), std::invalid_argument);
    CHECK_THROWS_AS(line_chart(Chart{.width = 100.0}), std::invalid_argument);
}
