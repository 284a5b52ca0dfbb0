#include "app/push/capacity_svg.hpp"

#include "app/output/chart_svg.hpp"
#include "app/study/fragility_text.hpp"
#include "app/study/study_walls.hpp"
#include "app/text/number_text.hpp"

#include <utility>
#include <vector>

namespace app {

namespace {

void add_marks(const FragilityInput& f, const WallReading& r, double way, Chart& chart)
{
    if (r.peak)
        chart.marks.push_back({way * r.peak->displacement * 1e3, way * r.peak->force * 1e-3,
                               "peak " + fixed(r.peak->force * 1e-3, 1) + " kN"});
    if (is_observed(r.ultimate))
        chart.vertical.push_back({way * r.ultimate.displacement * 1e3,
                                  percent_text(f.ultimate_share) + " of the peak"});
}

/// Of a push that turns back, over its path.
void add_backbone(const PushedWall& w, int direction, Chart& chart)
{
    const auto b = fragility::backbone({w.displacement, w.force}, direction);
    Series line{.name = "backbones", .colour = "#D55E00", .width = 2.2};
    for (std::size_t i = 0; i < b.force.size(); ++i) {
        line.x.push_back(direction * b.displacement[i] * 1e3);
        line.y.push_back(direction * b.force[i] * 1e-3);
    }
    chart.series.push_back(std::move(line));
}

Chart empty_chart(const std::string& title, double height)
{
    Chart chart;
    chart.title = title;
    chart.x_label = "Displacement [mm]";
    chart.y_label = "Horizontal force [kN]";
    chart.top = TopAxis{"Drift [%]", 100.0 / (height * 1e3)};
    return chart;
}

Series curve_of(const PushedWall& w)
{
    Series curve;
    for (std::size_t i = 0; i < w.displacement.size(); ++i) {
        curve.x.push_back(w.displacement[i] * 1e3);
        curve.y.push_back(w.force[i] * 1e-3);
    }
    return curve;
}

} // namespace

std::string capacity_svg(const Study& study, const PushedWall& w)
{
    Chart chart = empty_chart(
        "Capacity curve, vertical stress " + stress_text(w.vertical_stress), w.loads.height);
    Series curve = curve_of(w);
    const std::vector<WallReading>& sides = w.reading.backbones;
    if (!sides.empty()) curve.width = 1.0;
    chart.series.push_back(curve);
    // Readings count in the direction of the push.
    const double way = push_way(study).direction < 0 ? -1.0 : 1.0;
    if (sides.empty()) {
        add_marks(study.fragility, w.reading, way, chart);
        return line_chart(chart);
    }
    for (const int direction : {1, -1}) {
        add_backbone(w, direction, chart);
        const auto side = direction > 0 ? fragility::Side::right : fragility::Side::left;
        add_marks(study.fragility, sides[static_cast<int>(side)], direction, chart);
    }
    return line_chart(chart);
}

std::string levels_svg(const Study& study, const std::vector<PushedWall>& walls)
{
    Chart chart = empty_chart("Capacity curves, by vertical stress", study.load.height);
    for (const PushedWall& w : walls) {
        if (dem::failed(w.result.outcome)) continue;
        chart.series.push_back(curve_of(w));
        chart.series.back().name = stress_text(w.vertical_stress);
    }
    return line_chart(chart);
}

} // namespace app
