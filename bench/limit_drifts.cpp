#include "bench/limit_drifts.hpp"

#include "app/text/number_text.hpp"
#include "fragility/fits/kaplan_meier.hpp"

#include <array>
#include <optional>

namespace bench {

namespace {

/// The smallest drift at which the share of walls reaches a probability; nothing: beyond the
/// last wall.
template <class Share>
std::optional<double> quantile(const fragility::KaplanMeier& km, double p, Share share)
{
    for (const fragility::KaplanMeierStep& s : km.steps)
        if (share(s) >= p) return s.at;
    return {};
}

std::string drift_text(std::optional<double> drift, double end)
{
    return drift ? app::fixed(100.0 * *drift, 2) : "> " + app::fixed(100.0 * end, 2);
}

/// "0.66 [0.60, 0.71]": a quantile of the drifts with its 95 % interval [%].
std::string quantile_text(const fragility::KaplanMeier& km, double p)
{
    using Step = fragility::KaplanMeierStep;
    const auto at = [&](auto share) { return drift_text(quantile(km, p, share), km.end); };
    return at([](const Step& s) { return s.probability; }) + " [" +
           at([](const Step& s) { return s.band.upper; }) + ", " +
           at([](const Step& s) { return s.band.lower; }) + "]";
}

/// A limit drift of each wall. @param limit where the wall reached it
template <class Limit>
fragility::KaplanMeier drifts(const app::WallList& walls, double height, Limit limit)
{
    std::vector<fragility::Observation> all;
    for (const app::StudyWall* w : walls) {
        const fragility::LimitDisplacement& u = limit(*w);
        const double drift = u.displacement / height;
        all.push_back(is_observed(u) ? fragility::observed(drift)
                                     : fragility::right_censored(drift));
    }
    return fragility::kaplan_meier(all);
}

const fragility::LimitDisplacement& ultimate(const app::StudyWall& w)
{
    return w.reading.ultimate;
}
const fragility::LimitDisplacement& collapse(const app::StudyWall& w)
{
    return w.reading.collapse;
}

} // namespace

app::Row limit_row(const std::string& name, const app::StudyWalls& study,
                   std::size_t level_number)
{
    const app::StudyLevel& level = study.levels.at(level_number);
    const double n = static_cast<double>(level.walls.size());
    double force = 0.0, stood = 0.0;
    for (const app::StudyWall& w : level.walls) {
        force += app::peak_force(w.reading) * 1e-3;
        stood += is_observed(w.reading.ultimate) ? 0.0 : 1.0;
    }
    std::string shares;
    for (const int mode : {app::kRocking, app::kSliding, app::kMixed})
        shares += (shares.empty() ? "" : " / ") +
                  app::fixed(100.0 * static_cast<double>(walls_of(level, mode).size()) / n, 0);
    const fragility::KaplanMeier km =
        drifts(app::walls_of(level, app::kAllModes), study.height, ultimate);
    return {app::fixed(level.stress * 1e-6, 2),
            name,
            app::fixed(force / n, 1),
            shares,
            quantile_text(km, 0.16),
            quantile_text(km, 0.50),
            quantile_text(km, 0.84),
            app::fixed(100.0 * stood / n, 0),
            std::to_string(level.failed_walls.size())};
}

std::vector<app::Head> limit_head()
{
    return {"stress [MPa]",
            "choice",
            "mean peak [kN]",
            "rocking / sliding / mixed [%]",
            "drift limit, 16 % of walls [%]",
            "median [%]",
            "84 % [%]",
            "never fell to 80 % [%]",
            "failed"};
}

app::Table limits_by_mode(const app::StudyWalls& study)
{
    constexpr std::size_t kFewest = 5;
    app::Table t;
    t.caption = "Finite displacements, load that moves with the beam, pushed until no force is "
                "left: drifts by mode, five walls or more.";
    t.head = {"stress [MPa]",
              "mode",
              "walls",
              "80 %: 16 % of walls [%]",
              "median [%]",
              "84 % [%]",
              "zero force: 16 %",
              "median [%]",
              "84 % [%]"};
    for (const app::StudyLevel& level : study.levels)
        for (const int mode : {app::kRocking, app::kSliding, app::kMixed}) {
            const auto walls = walls_of(level, mode);
            if (walls.size() < kFewest) continue;
            app::Row r = {app::fixed(level.stress * 1e-6, 2), app::mode_name(mode),
                          std::to_string(walls.size())};
            for (const auto limit : {ultimate, collapse})
                for (const double p : {0.16, 0.50, 0.84})
                    r.push_back(quantile_text(drifts(walls, study.height, limit), p));
            t.rows.push_back(r);
        }
    return t;
}

} // namespace bench
