#include "app/report/report_fragility.hpp"

#include "app/input/number_text.hpp"
#include "app/study/fragility_text.hpp"
#include "fragility/binomial.hpp"
#include "fragility/equal_modes.hpp"
#include "fragility/fragility_curve.hpp"
#include "fragility/kaplan_meier.hpp"
#include "fragility/mode_lack_of_fit.hpp"
#include "fragility/mode_model.hpp"
#include "fragility/performance_limits.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

namespace app {
namespace {

using Json = nlohmann::ordered_json;
using fragility::Observation;

constexpr std::size_t kDrifts = 121;
constexpr std::array<const char*, 2> kModeNames = {"rocking", "mixed"};
constexpr double kDoubtful = 0.05; ///< p-value below which a line over the stress is not drawn

struct LevelWalls {
    std::vector<Observation> all;
    std::array<fragility::ModeGroup, 2> modes; ///< rocking, mixed
};

LevelWalls walls_of_level(const ReportStudy& study, std::size_t level)
{
    LevelWalls walls;
    for (const ReportWall* w : study.sound(level)) {
        const auto limit =
            fragility::observation({w->ultimate, w->reading, ""}, 100.0 / study.height);
        if (!limit) continue;
        walls.all.push_back(*limit);
        walls.modes[w->rocking ? 0 : 1].limits.push_back(*limit);
    }
    return walls;
}

double rounded(double p) { return std::round(p * 1e5) / 1e5; }

std::string fit_text(const fragility::ModeGroup& group, const fragility::Fit& fit,
                     const char* mode)
{
    const auto n = group.limits.size();
    std::string text = std::string(mode) + ", " + std::to_string(n) + " walls: ";
    if (fit.outcome != fragility::FitOutcome::converged) return text + "no fit, " + fit.reason;
    const fragility::Interval m = fragility::wald_interval(fit, fragility::median());
    const double median = std::exp(fit.law.location), end = known_to(group.limits);
    return text + "median drift [%] " + cell_text(with_interval(median, m, 2, end)) +
           (median > end ? " (extrapolated)" : "") + ", dispersion " +
           fixed(fit.law.dispersion, 2) + " ± " + fixed(fit.dispersion_error, 2);
}

Json kaplan_meier_json(const std::vector<Observation>& limits, Json& curve)
{
    const fragility::KaplanMeier km = fragility::kaplan_meier(limits);
    Json steps = Json::array();
    for (const auto& s : km.steps) steps.push_back({rounded(s.at), rounded(s.probability)});
    curve["known_to"] = rounded(km.end);
    return steps;
}

/// @param end of the axis: largest drift [%]
Json level_curve(const LevelWalls& walls, std::size_t level, double end)
{
    std::vector<fragility::ModeGroup> groups;
    std::vector<const char*> names;
    for (std::size_t m = 0; m < 2; ++m)
        if (!walls.modes[m].limits.empty()) {
            groups.push_back(walls.modes[m]);
            names.push_back(kModeNames[m]);
        }
    std::vector<double> drifts;
    for (std::size_t i = 1; i <= kDrifts; ++i)
        drifts.push_back(end * static_cast<double>(i) / kDrifts);
    const fragility::Mixture mix = fragility::mixture_curve(groups, drifts);
    Json c = {{"level", level}};
    for (const char* const key : {"drift", "least", "most", "lower", "upper"})
        c[key] = Json::array();
    for (const fragility::MixturePoint& p : mix.points) {
        c["drift"].push_back(rounded(p.drift));
        c["least"].push_back(rounded(p.least));
        c["most"].push_back(rounded(p.most));
        c["lower"].push_back(rounded(p.band.lower));
        c["upper"].push_back(rounded(p.band.upper));
    }
    c["steps"] = kaplan_meier_json(walls.all, c);
    c["fitted"] = std::any_of(mix.fits.begin(), mix.fits.end(), [](const fragility::Fit& f) {
        return f.outcome == fragility::FitOutcome::converged;
    });
    c["fits"] = Json::array();
    for (std::size_t m = 0; m < groups.size(); ++m)
        c["fits"].push_back(fit_text(groups[m], mix.fits[m], names[m]));
    return c;
}

std::string interval_text(const fragility::Interval& i, int digits)
{
    return "[" + fixed(i.lower, digits) + ", " +
           (std::isfinite(i.upper) ? fixed(i.upper, digits) : std::string("no limit")) + "]";
}

Row table_row(const ReportStudy& study, std::size_t level)
{
    const LevelWalls walls = walls_of_level(study, level);
    std::size_t observed = 0;
    for (const Observation& o : walls.all) observed += o.lower == o.upper ? 1 : 0;
    Row row = {given(study.stress(level)), count(static_cast<double>(walls.all.size())),
               count(static_cast<double>(observed))};
    if (walls.all.empty()) return row.resize(7), row;
    const auto limits = fragility::performance_limits(fragility::Law::lognormal, walls.all);
    if (limits.fitted) {
        for (const std::size_t k : {1u, 2u, 3u})
            row.emplace_back(with_interval(limits.drifts[k].drift, limits.drifts[k].interval, 2,
                                           known_to(walls.all)));
        row.emplace_back(with_interval(limits.dispersion, limits.dispersion_interval, 2));
        return row;
    }
    row.insert(row.end(), {{}, median_bound(limits.bound, 2), {}, {}});
    return row;
}

Json model_json(const fragility::ModeModel& model, double low, double high)
{
    Json m;
    constexpr int kPoints = 61;
    for (int i = 0; i < kPoints; ++i) {
        Eigen::VectorXd at(1);
        at(0) = low + (high - low) * i / (kPoints - 1);
        const auto p = fragility::mode_probability(model, 0, at);
        m["stress"].push_back(rounded(at(0)));
        m["value"].push_back(rounded(p.value));
        m["lower"].push_back(rounded(p.interval.lower));
        m["upper"].push_back(rounded(p.interval.upper));
    }
    return m;
}

std::string equal_text(const fragility::ModeModel& model, const fragility::ModeData& data)
{
    const auto e = fragility::equal_modes(model, data, 0, 1, 0, Eigen::VectorXd::Zero(1));
    if (!e.found) return "No stress at which both modes are equally likely: " + e.reason + ".";
    const auto stress = data.covariates.col(0);
    if (e.at < stress.minCoeff() || e.at > stress.maxCoeff())
        return "Neither mode is overtaken by the other between the stresses studied.";
    return "Both modes are equally likely at " + fixed(e.at, 2) + " MPa " +
           interval_text(e.delta, 2) + ".";
}

void add_model(Json& modes, const fragility::ModeData& data)
{
    const fragility::ModeModel model = fragility::fit_modes_safely(data);
    if (model.outcome != fragility::ModelOutcome::converged) {
        modes["note"] = "No logistic regression: " + model.reason + ".";
        return;
    }
    const fragility::LackOfFit f = fragility::lack_of_fit(model, data);
    const std::string test = "deviance " + fixed(f.deviance, 1) + " on " +
                             std::to_string(f.degrees) + " degrees of freedom, p " +
                             (f.p_value < 0.001 ? "< 0.001" : "= " + fixed(f.p_value, 3));
    if (f.p_value < kDoubtful) {
        modes["note"] =
            "No line: logistic regression on the stress does not fit these shares (" + test +
            ").";
        return;
    }
    const auto stress = data.covariates.col(0);
    modes["model"] = model_json(model, stress.minCoeff(), stress.maxCoeff());
    const bool firth = model.penalty == fragility::ModePenalty::firth;
    modes["note"] = std::string("Line: logistic regression on the stress") +
                    (firth ? ", with Firth's penalty (" + model.reason + ")" : "") +
                    (f.degrees > 0 ? "; lack of fit: " + test : "") + ". " +
                    equal_text(model, data);
}

struct ModeCount {
    double stress = 0.0; ///< [MPa]
    double rocking = 0.0, walls = 0.0, failed = 0.0;
};

ModeCount mode_count(const ReportStudy& study, std::size_t level)
{
    ModeCount c{study.stress(level)};
    for (const ReportWall& w : study.walls) {
        if (w.row.key.level != level) continue;
        (w.failed ? c.failed : c.walls) += 1.0;
        if (!w.failed && w.rocking) c.rocking += 1.0;
    }
    return c;
}

fragility::ModeData mode_data(const std::vector<ModeCount>& counts)
{
    const auto n = static_cast<Eigen::Index>(counts.size());
    fragility::ModeData data{Eigen::MatrixXd(n, 1), Eigen::MatrixXd(n, 2)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const ModeCount& c = counts[static_cast<std::size_t>(i)];
        data.covariates(i, 0) = c.stress;
        data.counts.row(i) << c.rocking, c.walls - c.rocking;
    }
    return data;
}

} // namespace

Json fragility_json(const ReportStudy& study)
{
    Json curves = Json::array();
    std::vector<LevelWalls> levels;
    std::vector<Observation> all;
    for (std::size_t level = 0; level < study.head.levels.size(); ++level) {
        levels.push_back(walls_of_level(study, level));
        all.insert(all.end(), levels.back().all.begin(), levels.back().all.end());
    }
    const double end = common_end(all);
    if (!(end > 0.0)) return curves;
    for (std::size_t level = 0; level < levels.size(); ++level)
        if (!levels[level].all.empty())
            curves.push_back(level_curve(levels[level], level, end));
    return curves;
}

Table fragility_table(const ReportStudy& study)
{
    Table t;
    t.caption = "Ultimate drift (first fall to 80 % of the peak), displacement / height of the "
                "load, lognormal by censored maximum likelihood over all modes, 95 % intervals "
                "by profile likelihood. Where nothing can be fitted: a bound of the median "
                "without any law (95 %, one-sided). " +
                extrapolated_text("any wall of the row") + ".";
    constexpr unsigned kHolds = kInterval | kExtrapolated;
    t.head = {"stress [MPa]",
              "walls",
              "observed",
              {"drift of 16 % of the walls [%]", kHolds},
              {"median [%]", kHolds},
              {"84 % [%]", kHolds},
              {"dispersion", kInterval}};
    for (std::size_t level = 0; level < study.head.levels.size(); ++level)
        t.rows.push_back(table_row(study, level));
    return t;
}

Json modes_json(const ReportStudy& study)
{
    Json modes = {{"levels", Json::array()}, {"note", ""}};
    std::vector<ModeCount> counts;
    for (std::size_t level = 0; level < study.head.levels.size(); ++level) {
        const ModeCount c = mode_count(study, level);
        if (c.walls == 0.0) continue;
        const fragility::Share s = fragility::share(c.rocking, c.walls, c.failed);
        modes["levels"].push_back({{"stress", c.stress},
                                   {"value", s.value},
                                   {"lower", s.bounds.lower},
                                   {"upper", s.bounds.upper},
                                   {"walls", c.walls}});
        counts.push_back(c);
    }
    if (counts.size() >= 2) add_model(modes, mode_data(counts));
    return modes;
}

} // namespace app
