#include "app/report/report_parts.hpp"

#include "app/fragility/fragility_cycles.hpp"
#include "app/fragility/fragility_means.hpp"
#include "app/report/report_bytes.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "app/text/json_text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// A path at 0, 1, 2, ... steps of its way.
WallCurve evenly(const WallCurve& c, double step, std::size_t most)
{
    WallCurve even;
    double way = 0.0; // up to the point before
    for (std::size_t i = 1; i < c.force.size(); ++i) {
        const double dx = c.displacement[i] - c.displacement[i - 1],
                     df = c.force[i] - c.force[i - 1], length = std::abs(dx);
        while (even.force.size() < most) {
            const double at = step * static_cast<double>(even.force.size());
            if (at > way + length) break;
            const double t = length > 0.0 ? (at - way) / length : 0.0;
            even.displacement.push_back(c.displacement[i - 1] + t * dx);
            even.force.push_back(c.force[i - 1] + t * df);
        }
        way += length;
    }
    return even;
}

} // namespace

Json loops_json(const StudyWalls& study, const WallList& listed)
{
    if (study.pushed_one_way) return nullptr;
    const double step = film_step(study.study.load) / kLoopPoints;
    const auto points =
        static_cast<std::size_t>(film_frames(study.study.load) * kLoopPoints + 1);
    std::vector<double> displacements, forces;
    Json counts = Json::array();
    for (const StudyWall* w : listed) {
        WallCurve even = evenly(w->curve, step, points);
        counts.push_back(even.force.size());
        even.displacement.resize(points,
                                 even.displacement.empty() ? 0.0 : even.displacement.back());
        even.force.resize(points, even.force.empty() ? 0.0 : even.force.back());
        displacements.insert(displacements.end(), even.displacement.begin(),
                             even.displacement.end());
        forces.insert(forces.end(), even.force.begin(), even.force.end());
    }
    const double length_step = std::max(largest_size(displacements), 1e-6) / 32000.0;
    const double force_step = std::max(largest_size(forces), 1.0) / 32000.0;
    std::vector<std::uint8_t> bytes = differences(displacements, points, length_step, 1);
    const std::vector<std::uint8_t> more = differences(forces, points, force_step, 1);
    bytes.insert(bytes.end(), more.begin(), more.end());
    return {{"per_frame", kLoopPoints}, {"points", points}, {"step", length_step},
            {"force_step", force_step}, {"counts", counts}, {"data", base64(deflated(bytes))}};
}

Json damping_json(const StudyWalls& study)
{
    const auto rounded = [](double x) { return or_null(std::round(x * 1e3) / 1e3); };
    std::vector<int> modes = modes_of(study);
    modes.insert(modes.begin(), kAllModes);
    Json all = Json::array();
    for (std::size_t level = 0; level < study.levels.size(); ++level)
        for (const int mode : modes) {
            const auto points = cycle_points(study, study.levels[level], mode);
            if (points.empty()) continue;
            Json one = {{"level", level},
                        {"mode", mode == kAllModes ? "all" : mode_name(mode)}};
            for (const CyclePoint& p : points) {
                one["walls"].push_back(p.walls);
                one["drift"].push_back(rounded(p.drift));
                one["damping"].push_back(rounded(p.damping.value));
                one["lower"].push_back(rounded(p.damping.interval.lower));
                one["upper"].push_back(rounded(p.damping.interval.upper));
            }
            all.push_back(one);
        }
    return all;
}

} // namespace app
