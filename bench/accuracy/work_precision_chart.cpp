#include "bench/accuracy/work_precision.hpp"

#include "app/output/picture/chart_svg.hpp"

#include <algorithm>

namespace bench {

std::vector<const Point*> front(const std::vector<Point>& points, double Point::*error)
{
    std::vector<const Point*> sorted;
    for (const Point& p : points)
        if (p.failed == 0) sorted.push_back(&p);
    std::sort(sorted.begin(), sorted.end(), [error](const Point* a, const Point* b) {
        return a->seconds != b->seconds ? a->seconds < b->seconds : a->*error < b->*error;
    });
    std::vector<const Point*> best;
    for (const Point* p : sorted)
        if (best.empty() || p->*error < best.back()->*error) best.push_back(p);
    return best;
}

namespace {

std::string panel(const std::vector<Point>& points, double Point::*error, std::string y_label)
{
    app::Chart chart;
    chart.title = "Cost against error";
    chart.x_label = "core seconds per wall";
    chart.y_label = std::move(y_label);
    chart.log_x = chart.log_y = true;
    chart.width = 860.0;
    chart.height = 560.0;
    app::Series edge{.name = "front", .colour = "#999999", .width = 5.0};
    for (const Point* p : front(points, error)) {
        edge.x.push_back(p->seconds);
        edge.y.push_back(100.0 * (p->*error));
    }
    chart.series.push_back(edge);
    for (const Point& p : points) {
        if (chart.series.back().name != p.setting.family)
            chart.series.push_back({.name = p.setting.family, .width = 1.2, .points = true});
        chart.series.back().x.push_back(p.seconds);
        chart.series.back().y.push_back(100.0 * (p.*error));
        if (p.setting.is_default)
            chart.marks.push_back({p.seconds, 100.0 * (p.*error), "default"});
    }
    return app::line_chart(chart);
}

} // namespace

Panels draw(const std::vector<Point>& points)
{
    return {panel(points, &Point::peak_median, "median error of the peak force [%]"),
            panel(points, &Point::ultimate, "error of the mean ultimate displacement [%]")};
}

} // namespace bench
