#include "app/push/capacity_svg.hpp"

#include "app/input/number_text.hpp"
#include "app/output/chart_svg.hpp"

namespace app {

std::string capacity_svg(const PushedWall& w)
{
    Chart chart;
    chart.title =
        "Capacity curve, vertical stress " + fixed(w.vertical_stress * 1e-6, 2) + " MPa";
    chart.x_label = "Displacement [mm]";
    chart.y_label = "Horizontal force [kN]";
    chart.top = TopAxis{"Drift [%]", 100.0 / (w.loads.height * 1e3)};
    Series curve;
    for (std::size_t i = 0; i < w.displacement.size(); ++i) {
        curve.x.push_back(w.displacement[i] * 1e3);
        curve.y.push_back(w.force[i] * 1e-3);
    }
    chart.series.push_back(curve);
    if (w.peak)
        chart.marks.push_back({w.peak->displacement * 1e3, w.peak->force * 1e-3,
                               "peak " + fixed(w.peak->force * 1e-3, 1) + " kN"});
    if (w.ultimate.reading == fragility::Reading::observed)
        chart.vertical.push_back({w.ultimate.displacement * 1e3, "80 % of the peak"});
    return line_chart(chart);
}

} // namespace app
