#include "app/report/report_curves.hpp"

#include "app/report/report_bytes.hpp"
#include "uq/estimates/estimate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using Json = nlohmann::ordered_json;

double largest_displacement(const ReportStudy& study)
{
    double largest = 0.0;
    for (const ReportWall& w : study.walls)
        if (!w.row.curve.displacement.empty())
            largest = std::max(largest, w.row.curve.displacement.back());
    return largest;
}

double largest_force(const ReportStudy& study)
{
    double largest = 0.0;
    for (const ReportWall& w : study.walls)
        for (const double f : w.row.curve.force) largest = std::max(largest, std::abs(f));
    return largest;
}

/// Forces at one displacement of the curves that go so far [kN].
std::vector<double> forces_at(const std::vector<std::vector<double>>& curves, std::size_t i)
{
    std::vector<double> forces;
    for (const auto& c : curves)
        if (i < c.size()) forces.push_back(1e-3 * c[i]);
    return forces;
}

Json mean_curve(const std::vector<std::vector<double>>& curves)
{
    Json mean = Json::array(), lower = Json::array(), upper = Json::array();
    const auto rounded = [](double kn) { return std::round(kn * 1e3) / 1e3; };
    for (std::size_t i = 0; i < kMeanPoints; ++i) {
        const std::vector<double> f = forces_at(curves, i);
        if (f.size() < 2 || static_cast<double>(f.size()) <
                                kMeanNeedsShare * static_cast<double>(curves.size()))
            break;
        const uq::Estimate e = uq::estimate_mean(f);
        mean.push_back(rounded(e.value));
        lower.push_back(rounded(e.interval.lower));
        upper.push_back(rounded(e.interval.upper));
    }
    return {{"mean", mean}, {"lower", lower}, {"upper", upper}};
}

} // namespace

Json curves_json(const ReportStudy& study, const std::vector<std::size_t>& listed)
{
    const std::size_t points = listed.size() > kManyWalls ? kFewCurvePoints : kCurvePoints;
    const double step = largest_displacement(study) / static_cast<double>(points - 1);
    const double force_step = std::max(largest_force(study), 1.0) / 32000.0;
    std::vector<double> all;
    Json counts = Json::array();
    for (const std::size_t i : listed) {
        std::vector<double> f;
        if (step > 0.0) f = resampled(study.walls[i].row.curve, step, points);
        counts.push_back(f.size());
        f.resize(points, f.empty() ? 0.0 : f.back());
        all.insert(all.end(), f.begin(), f.end());
    }
    const auto bytes = differences(all, points, force_step, 1);
    return {{"step", step},
            {"points", points},
            {"force_step", force_step},
            {"counts", counts},
            {"data", base64(deflated(bytes))}};
}

Json mean_curves_json(const ReportStudy& study)
{
    Json means = Json::array();
    const double step = largest_displacement(study) / static_cast<double>(kMeanPoints - 1);
    if (!(step > 0.0)) return means;
    for (std::size_t level = 0; level < study.head.levels.size(); ++level)
        for (const char* const mode : {"all", "rocking", "mixed"}) {
            std::vector<std::vector<double>> curves;
            for (const ReportWall* w : study.sound(level))
                if (mode[0] == 'a' || w->rocking == (mode[0] == 'r'))
                    curves.push_back(resampled(w->row.curve, step, kMeanPoints));
            if (curves.size() < 2) continue;
            Json mean = mean_curve(curves);
            mean["level"] = level;
            mean["mode"] = mode;
            mean["walls"] = curves.size();
            mean["step"] = step;
            means.push_back(mean);
        }
    return means;
}

} // namespace app
