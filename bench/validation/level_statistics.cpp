#include "bench/validation/level_statistics.hpp"

#include "app/fragility/numbers/sampling_errors.hpp"
#include "core/moments.hpp"
#include "fragility/curve/bilinear.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bench {
namespace {

/// Numbers of the walls of a level, one for each wall.
struct Values {
    const app::StudyWalls& walls;
    const app::StudyLevel& level;

    /// Mean over those that are members.
    [[nodiscard]] Sample of(const std::vector<double>& y, const std::vector<bool>& member) const
    {
        std::vector<double> counted;
        for (std::size_t i = 0; i < y.size(); ++i)
            if (member[i]) counted.push_back(y[i]);
        Sample s = sample(counted);
        s.hypercube = app::hypercube_error(walls, level, y, member);
        return s;
    }
};

std::vector<bool> both(const std::vector<bool>& a, const std::vector<bool>& b)
{
    std::vector<bool> result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] && b[i];
    return result;
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
    if (hypercube) return *hypercube;
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
    std::vector<double> peaks, plateaus, displacements, rocking;
    std::vector<bool> all(l.walls.size(), true), rocks, slides, unslid, dropped, has_plateau;
    for (const app::StudyWall& w : l.walls) {
        const dem::Mechanism& m = w.mechanism;
        rocks.push_back(dem::failure_mode(m, w.reading.dropped, mode) ==
                        dem::FailureMode::rocking);
        slides.push_back(!rocks.back());
        unslid.push_back(!app::slid_whole(m, w.reading.dropped, mode));
        dropped.push_back(w.reading.dropped);
        rocking.push_back(rocks.back() ? 100.0 : 0.0);
        peaks.push_back(app::peak_force(w.reading) * 1e-3);
        displacements.push_back(w.reading.ultimate.displacement * 1e3);
        plateaus.push_back(plateau_of(w, walls.step, walls.rules.options.bilinear_share));
        has_plateau.push_back(plateaus.back() > 0.0);
    }
    const auto inputs = [&](const std::optional<std::size_t>& place) {
        std::vector<double> values;
        for (const app::StudyWall& w : l.walls)
            values.push_back(place ? w.inputs[*place] : 0.0);
        return values;
    };
    const Values values{walls, l};
    const auto of_mode = [&](const std::vector<bool>& member) {
        ModeStatistics s;
        if (friction) s.friction_deg = values.of(inputs(friction), member);
        if (strength) s.strength_MPa = values.of(inputs(strength), member);
        s.peak_kN = values.of(peaks, member);
        s.displacement_mm = values.of(displacements, member);
        s.dropped_mm = values.of(displacements, both(member, dropped));
        s.plateau_kN = values.of(plateaus, both(member, has_plateau));
        return s;
    };
    s.rocking_walls = static_cast<std::size_t>(std::ranges::count(rocks, true));
    s.dropped_walls = static_cast<std::size_t>(std::ranges::count(dropped, true));
    s.slid_walls = static_cast<std::size_t>(std::ranges::count(unslid, false));
    s.rocking_percent = values.of(rocking, all);
    s.peak_kN = values.of(peaks, all);
    s.unslid_kN = values.of(peaks, unslid);
    s.plateau_kN = values.of(plateaus, has_plateau);
    s.rocking = of_mode(rocks);
    s.mixed = of_mode(slides);
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
