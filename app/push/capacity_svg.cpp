#include "app/push/capacity_svg.hpp"

#include "app/study/answers/fragility_text.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/number_text.hpp"
#include "fragility/curve/drift.hpp"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace app {

namespace {

/// "paper ultimate, ntc SLC 24.1 mm" for each displacement at which limit states are reached.
void add_limits(const ReadingRules& rules, const WallReading& r, double way, Chart& chart)
{
    if (!r.no_reading.empty()) return;
    const std::vector<StateName> names = state_names(rules);
    std::map<std::string, ReferenceLine> lines; // by what people read
    const auto add = [&](const std::string& name, const fragility::LimitDisplacement& d) {
        if (!is_observed(d)) return;
        const double at = d.displacement * 1e3;
        ReferenceLine& line = lines[never_rounded_away(at, 1) + " mm"];
        line.at = way * at;
        line.label += (line.label.empty() ? "" : ", ") + name;
    };
    add(percent_text(rules.options.ultimate_share) + " of the peak", r.ultimate);
    for (std::size_t i = 0; i < names.size(); ++i) add(state_name(names[i]), r.limits.at(i));
    for (auto& [at, line] : lines) {
        line.label += " " + at;
        chart.vertical.push_back(std::move(line));
    }
}

/// @param last displacement of the curve, in its own direction [m]
void add_marks(const ReadingRules& rules, const WallReading& r, double way, double last,
               Chart& chart)
{
    if (r.peak) {
        constexpr double kNear =
            0.99; // of the way: the force has hardly begun to fall, if at all
        const std::string force = fixed(r.peak->force * 1e-3, 1) + " kN";
        const bool ends = r.peak->at_end || r.peak->displacement >= kNear * last;
        chart.marks.push_back(
            {way * r.peak->displacement * 1e3, way * r.peak->force * 1e-3,
             ends ? "largest force " + force + ", where the push ends" : "peak " + force});
    }
    add_limits(rules, r, way, chart);
}

/// A wall that is not symmetric leans when it is loaded, and is held at zero displacement.
void add_start(const PushedWall& w, Chart& chart)
{
    constexpr double kSeen = 0.02; // of the peak
    if (w.force.empty() || std::abs(w.force.front()) <= kSeen * std::abs(peak_force(w.reading)))
        return;
    const double force = w.force.front() * 1e-3;
    chart.marks.push_back(
        {0.0, force, fixed(force, 1) + " kN hold the loaded wall upright before the push"});
}

Series backbone_series(const fragility::Backbone& b, double way)
{
    Series line;
    for (std::size_t i = 0; i < b.force.size(); ++i) {
        line.x.push_back(way * b.displacement[i] * 1e3);
        line.y.push_back(way * b.force[i] * 1e-3);
    }
    return line;
}

/// A push that turns back: both backbones, and the one that its table is read on.
void add_backbones(const PushedWall& w, const ReadingRules& rules, Chart& chart)
{
    const fragility::Path path{w.displacement, w.force};
    for (const int direction : {1, -1}) {
        Series line = backbone_series(fragility::backbone(path, direction), direction);
        line.name = "backbones of both directions";
        line.colour = "#D55E00";
        chart.series.push_back(std::move(line));
    }
    const bool left = rules.backbone == fragility::Side::left;
    Series read =
        backbone_series(capacity_curve({w.displacement, w.force}, rules), left ? -1 : 1);
    read.name = rules.backbone == fragility::Side::right || left
                    ? "the backbone that the table is read on"
                    : "their mean: the peak and the limits of the table";
    if (rules.backbone == fragility::Side::worse)
        read.name = "their mean; limits are those of the direction that comes first";
    read.colour = "#000000";
    read.width = 2.4;
    chart.series.push_back(std::move(read));
}

Chart empty_chart(const std::string& title, double height)
{
    Chart chart;
    chart.title = title;
    chart.x_label = "Displacement [mm]";
    chart.y_label = "Horizontal force [kN]";
    chart.top = TopAxis{"Drift [%]", fragility::percent_per_metre(height * 1e3)};
    return chart;
}

void add_tests(const std::vector<TestCurve>& tests, Chart& chart)
{
    for (const TestCurve& test : tests) {
        Series line;
        line.name = test.name + ", measured";
        line.line = LineStyle::dashed;
        for (std::size_t i = 0; i < test.force.size(); ++i) {
            line.x.push_back(test.displacement[i] * 1e3);
            line.y.push_back(test.force[i] * 1e-3);
        }
        chart.series.push_back(std::move(line));
    }
}

/// @param way -1 turns the curve round
Series curve_of(const PushedWall& w, double way = 1.0)
{
    Series curve;
    for (std::size_t i = 0; i < w.displacement.size(); ++i) {
        curve.x.push_back(way * w.displacement[i] * 1e3);
        curve.y.push_back(way * w.force[i] * 1e-3);
    }
    return curve;
}

std::string way_words(int direction) { return std::string("to the ") + way_name(direction); }

/// The push the other way, drawn over the push itself. @return whether there is one
bool add_other_way(int direction, const PushedWall& w, const std::string& prefix, Chart& chart)
{
    const PushedWall* const other = other_way_of(w);
    if (other == nullptr || dem::failed(other->result.outcome)) return false;
    chart.series.back().name = prefix + way_words(direction);
    Series curve = curve_of(*other, -1.0);
    curve.name = prefix + way_words(-direction);
    curve.line = LineStyle::dashed;
    chart.series.push_back(std::move(curve));
    return true;
}

} // namespace

Chart capacity_chart(const ReadingRules& rules, const PushedWall& w)
{
    Chart chart = empty_chart(
        "Capacity curve, vertical stress " + stress_text(w.vertical_stress), w.loads.height);
    Series curve = curve_of(w);
    // Readings count in the direction of the push.
    double way = rules.direction < 0 ? -1.0 : 1.0;
    bool both = false;
    if (w.reading.backbones.empty()) {
        chart.series.push_back(curve);
        both = add_other_way(rules.direction, w, "", chart);
    } else {
        curve.width = 1.0;
        curve.name = "path of the push";
        chart.series.push_back(curve);
        add_backbones(w, rules, chart);
        if (rules.backbone == fragility::Side::left) way = -1.0;
    }
    add_start(w, chart);
    double last = 0.0;
    if (w.reading.peak)
        last = capacity_curve({w.displacement, w.force}, rules).displacement.back();
    add_marks(rules, both ? worse_way(w) : w.reading, way, last, chart);
    return chart;
}

std::string capacity_svg(const ReadingRules& rules, const PushedWall& w,
                         const std::vector<TestCurve>& beside)
{
    Chart chart = capacity_chart(rules, w);
    if (!beside.empty() && chart.series.size() == 1) chart.series.front().name = "computed";
    add_tests(beside, chart);
    return line_chart(chart);
}

std::string levels_svg(const ReadingRules& rules, const std::vector<PushedWall>& walls,
                       const std::vector<TestCurve>& beside)
{
    Chart chart = empty_chart("Capacity curves, by vertical stress", rules.height);
    for (const PushedWall& w : walls) {
        if (dem::failed(w.result.outcome)) continue;
        chart.series.push_back(curve_of(w));
        chart.series.back().name = stress_text(w.vertical_stress);
        add_other_way(rules.direction, w, stress_text(w.vertical_stress) + ", ", chart);
    }
    add_tests(beside, chart);
    return line_chart(chart);
}

} // namespace app
