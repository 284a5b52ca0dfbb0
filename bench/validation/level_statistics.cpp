#include "bench/validation/level_statistics.hpp"

#include "core/moments.hpp"
#include "fragility/bilinear.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bench {
namespace {

struct Values {
    std::vector<double> friction, strength, peak, displacement, dropped, plateau;
};

ModeStatistics statistics(const Values& v)
{
    return {sample(v.friction),     sample(v.strength), sample(v.peak),
            sample(v.displacement), sample(v.dropped),  sample(v.plateau)};
}

/// Force of the equal-energy bilinear of a curve on the grid of mean curves [kN]; 0: there is
/// none.
double plateau_of(const app::StudyWall& w, double step, double share)
{
    std::vector<double> at(w.forces.size());
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = static_cast<double>(k) * step;
    if (at.empty()) return 0.0;
    const double end = std::min(w.reading.ultimate.displacement, at.back());
    return fragility::equal_energy_bilinear({at, w.forces}, end, share).yield_force * 1e-3;
}

} // namespace

double Sample::std_error() const
{
    return n > 0 ? sd / std::sqrt(static_cast<double>(n)) : 0.0;
}

Sample sample(const std::vector<double>& values)
{
    if (values.empty()) return {};
    if (values.size() == 1) return {1, values.front(), 0.0};
    const core::Moments m = core::moments(values);
    return {values.size(), m.mean, m.sd};
}

LevelStatistics level_statistics(const app::StudyWalls& walls, std::size_t level,
                                 const dem::ModeThresholds& thresholds)
{
    dem::ModeThresholds mode = thresholds;
    mode.modes = dem::ModeRule::paper; // the paper's
    const app::StudyLevel& l = walls.levels.at(level);
    const auto friction = app::input_of(walls, "joint.friction_angle"),
               strength = app::input_of(walls, "unit.tensile_strength");
    LevelStatistics s;
    s.stress_MPa = l.stress * 1e-6;
    s.walls = l.walls.size();
    s.failed = l.failed_walls.size();
    Values modes[2];
    std::vector<double> peaks, unslid, plateaus;
    for (const app::StudyWall& w : l.walls) {
        const dem::Mechanism& m = w.mechanism;
        const bool rocks =
            dem::failure_mode(m, w.reading.dropped, mode) == dem::FailureMode::rocking;
        Values& v = modes[rocks ? 0 : 1];
        if (friction) v.friction.push_back(w.inputs[*friction]);
        if (strength) v.strength.push_back(w.inputs[*strength]);
        v.peak.push_back(app::peak_force(w.reading) * 1e-3);
        v.displacement.push_back(w.reading.ultimate.displacement * 1e3);
        if (w.reading.dropped) v.dropped.push_back(w.reading.ultimate.displacement * 1e3);
        if (const double force = plateau_of(w, walls.step, walls.rules.options.bilinear_share);
            force > 0.0) {
            v.plateau.push_back(force);
            plateaus.push_back(force);
        }
        peaks.push_back(app::peak_force(w.reading) * 1e-3);
        s.rocking_walls += rocks;
        s.dropped_walls += w.reading.dropped;
        const bool slid = app::slid_whole(m, w.reading.dropped, mode);
        s.slid_walls += slid;
        if (!slid) unslid.push_back(app::peak_force(w.reading) * 1e-3);
    }
    s.peak_kN = sample(peaks);
    s.unslid_kN = sample(unslid);
    s.plateau_kN = sample(plateaus);
    s.rocking = statistics(modes[0]);
    s.mixed = statistics(modes[1]);
    return s;
}

Sample last_falls_mm(const app::StudyWalls& walls, std::size_t level)
{
    std::vector<double> falls;
    for (const app::StudyWall& w : walls.levels.at(level).walls)
        if (app::mode_of(w) == app::kMixed)
            falls.push_back(w.reading.limits.at(0).displacement * 1e3);
    return sample(falls);
}

std::vector<LevelStatistics> level_statistics(const app::StudyWalls& walls)
{
    std::vector<LevelStatistics> all;
    for (std::size_t l = 0; l < walls.levels.size(); ++l)
        all.push_back(level_statistics(walls, l, walls.study.fragility.mode));
    return all;
}

std::vector<LevelStatistics> read_levels(const std::filesystem::path& file)
{
    return level_statistics(app::read_study_walls(file, {}));
}

} // namespace bench
