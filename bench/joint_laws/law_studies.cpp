#include "bench/joint_laws/law_studies.hpp"

#include "app/store/store_reader.hpp"
#include "app/study/stored/study_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {
namespace {

std::vector<LevelCost> costs_of(const std::filesystem::path& file, std::size_t levels)
{
    app::StoreReader reader(file);
    const std::size_t steps = app::column_of(reader.head().counts, "steps");
    const std::size_t seconds = app::column_of(reader.head().cost, "solver_seconds");
    const std::size_t residual = app::column_of(reader.head().responses, "energy_residual");
    std::vector<LevelCost> costs(levels);
    reader.for_each_row([&](const app::WallRow& row) {
        LevelCost& c = costs.at(row.key.level);
        c.steps += static_cast<double>(row.counts.at(steps));
        c.seconds += row.cost.at(seconds);
        c.residual = std::fmax(c.residual, row.responses.at(residual));
    });
    return costs;
}

} // namespace

std::optional<LawStudy> LawStudies::read(const std::string& name)
{
    const std::filesystem::path file = folder_ / (name + ".h5");
    LawStudy study;
    if (std::filesystem::exists(file)) {
        study.walls = app::read_study_walls(file, {}, app::Keep::everything);
        study.costs = costs_of(file, study.walls.levels.size());
    } else
        note_missing(name);
    for (std::size_t l = study.walls.levels.size(); l-- > 0;)
        if (study.walls.levels[l].missing > 0) {
            note_missing(name + " (" + app::stress_text(study.walls.levels[l].stress) + ")");
            study.walls.levels.erase(study.walls.levels.begin() +
                                     static_cast<std::ptrdiff_t>(l));
            study.costs.erase(study.costs.begin() + static_cast<std::ptrdiff_t>(l));
        }
    return study.walls.levels.empty() ? std::nullopt : std::optional(std::move(study));
}

void LawStudies::note_missing(const std::string& what)
{
    if (std::ranges::find(missing_, what) == missing_.end()) missing_.push_back(what);
}

fragility::KaplanMeier limit_drifts(const LawStudy& study, std::size_t level)
{
    std::vector<fragility::Observation> drifts;
    for (const app::StudyWall& w : study.walls.levels.at(level).walls) {
        const auto& u = w.reading.ultimate;
        const double drift = 100.0 * u.displacement / study.walls.height;
        drifts.push_back(is_observed(u) ? fragility::observed(drift)
                                        : fragility::right_censored(drift));
    }
    return fragility::kaplan_meier(drifts);
}

std::optional<double> quantile(const fragility::KaplanMeier& drifts, double share)
{
    for (const fragility::KaplanMeierStep& s : drifts.steps)
        if (s.probability >= share) return s.at;
    return {};
}

WallsWithin walls_within(const LawStudy& study, std::size_t level, double drift)
{
    WallsWithin within;
    for (const app::StudyWall& w : study.walls.levels.at(level).walls) {
        const auto& u = w.reading.ultimate;
        const bool early = 100.0 * u.displacement / study.walls.height <= drift;
        within.down += early && is_observed(u);
        within.known += !early || is_observed(u);
    }
    return within;
}

double mean_peak(const LawStudy& study, std::size_t level)
{
    const auto& walls = study.walls.levels.at(level).walls;
    if (walls.empty()) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0;
    for (const app::StudyWall& w : walls) sum += app::peak_force(w.reading) * 1e-3;
    return sum / static_cast<double>(walls.size());
}

std::optional<double> secant(const LawStudy& study, const app::StudyWall& wall, double share)
{
    const fragility::Backbone b =
        app::capacity_curve({wall.curve.displacement, wall.curve.force}, study.walls.rules);
    const auto k = fragility::secant_stiffness({b.displacement, b.force}, share);
    return k ? std::optional(*k * 1e-6) : std::nullopt;
}

std::optional<std::size_t> level_at(const LawStudy& study, double stress)
{
    for (std::size_t l = 0; l < study.walls.levels.size(); ++l)
        if (std::abs(study.walls.levels[l].stress - stress) < 1.0) return l;
    return {};
}

} // namespace bench
