#include "app/report/report_parts.hpp"

#include "app/fragility/fragility_means.hpp"
#include "app/report/report_bytes.hpp"
#include "app/text/json_text.hpp"
#include "fragility/curve/resampled_curve.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// Largest distance and force of all walls.
struct Extent {
    double displacement = 0.0, force = 0.0; ///< [m] [N]
};

Extent extent_of(const StudyWalls& study)
{
    Extent e;
    for (const StudyLevel& level : study.levels)
        for (const StudyWall& w : level.walls) {
            e.displacement = std::max(e.displacement, largest_size(w.curve.displacement));
            e.force = std::max(e.force, largest_size(w.curve.force));
        }
    return e;
}

} // namespace

Json curves_json(const StudyWalls& study, const WallList& listed)
{
    const std::size_t points = listed.size() > kManyWalls ? kFewCurvePoints : kCurvePoints;
    const Extent largest = extent_of(study);
    const double step = largest.displacement / static_cast<double>(points - 1);
    const double force_step = std::max(largest.force, 1.0) / 32000.0;
    std::vector<double> all;
    Json counts = Json::array();
    for (const StudyWall* w : listed) {
        std::vector<double> f;
        if (step > 0.0 && !w->failed) {
            const auto read =
                capacity_curve({w->curve.displacement, w->curve.force}, study.rules);
            f = fragility::resampled({read.displacement, read.force}, step, points);
        }
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

Json mean_curves_json(const StudyWalls& study)
{
    const auto rounded = [](double kn) { return std::round(kn * 1e3) / 1e3; };
    Json means = Json::array();
    for (std::size_t level = 0; level < study.levels.size(); ++level)
        for (const int mode : {kAllModes, kRocking, kSliding, kMixed}) {
            const auto points = mean_points(study, study.levels[level], mode);
            if (points.empty() || points.front().walls < 2) continue;
            Json mean = {{"level", level},
                         {"mode", mode == kAllModes ? "all" : mode_name(mode)},
                         {"walls", points.front().walls},
                         {"step", study.step}};
            for (const MeanPoint& p : points) {
                mean["mean"].push_back(rounded(p.mean));
                mean["lower"].push_back(rounded(p.interval.lower));
                mean["upper"].push_back(rounded(p.interval.upper));
            }
            means.push_back(mean);
        }
    return means;
}

} // namespace app
