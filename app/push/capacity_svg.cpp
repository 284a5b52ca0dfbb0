#include "app/push/capacity_svg.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/output/chart_svg.hpp"
#include "app/study/fragility_text.hpp"
#include "app/text/number_text.hpp"

namespace app {

std::string capacity_svg(const Study& study, const PushedWall& w)
{
    Chart chart;
    chart.title =
        "Capacity curve, vertical stress " + fixed(w.vertical_stress / 1e6, 2) + " MPa";
    chart.x_label = "Displacement [mm]";
    chart.y_label = "Horizontal force [kN]";
    chart.top = TopAxis{"Drift [%]", 100.0 / (w.loads.height * 1e3)};
    Series curve;
    for (std::size_t i = 0; i < w.displacement.size(); ++i) {
        curve.x.push_back(w.displacement[i] * 1e3);
        curve.y.push_back(w.force[i] * 1e-3);
    }
    chart.series.push_back(curve);
    const WallReading& r = w.reading;
    // Readings count in the direction of the push.
    const double way = reading_rules(study).direction < 0 ? -1.0 : 1.0;
    if (r.peak)
        chart.marks.push_back({way * r.peak->displacement * 1e3, way * r.peak->force * 1e-3,
                               "peak " + fixed(r.peak->force * 1e-3, 1) + " kN"});
    if (is_observed(r.ultimate))
        chart.vertical.push_back(
            {way * r.ultimate.displacement * 1e3,
             percent_text(study.fragility.ultimate_share) + " of the peak"});
    return line_chart(chart);
}

} // namespace app
