#include "app/report/report_parts.hpp"

#include "app/fragility/fragility_curves.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/mode_rule.hpp"
#include "app/study/answers/mode_share.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "core/interval.hpp"
#include "fragility/fits/kaplan_meier.hpp"
#include "fragility/limits/fragility_curve.hpp"
#include "fragility/modes/equal_modes.hpp"
#include "fragility/modes/mode_lack_of_fit.hpp"
#include "fragility/modes/mode_model.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t kDrifts = 121;
constexpr double kDoubtful = 0.05; ///< p-value below which a line over the stress is not drawn

double five_decimals(double p) { return std::round(p * 1e5) / 1e5; }

void add_mixture(const std::vector<fragility::ModeGroup>& modes,
                 const std::vector<double>& drifts, double confidence, Json& c)
{
    const fragility::Mixture mix = fragility::mixture_curve(modes, drifts, confidence);
    for (const fragility::MixturePoint& p : mix.points) {
        c["least"].push_back(five_decimals(p.least));
        c["most"].push_back(five_decimals(p.most));
        c["lower"].push_back(five_decimals(p.band.lower));
        c["upper"].push_back(five_decimals(p.band.upper));
    }
    c["fitted"] = std::ranges::any_of(mix.fits, [](const fragility::Fit& f) {
        return f.outcome == fragility::FitOutcome::converged;
    });
}

/// The curves of fragility_pictures of one stress and limit state.
Json curve_json(const DriftData& data, std::size_t state, std::size_t level,
                const std::vector<double>& drifts)
{
    const DriftGroup& group = data.groups[level];
    const auto modes = mode_groups(data, level, state);
    Json c = {{"level", level}, {"drift", Json::array()}, {"fitted", false}};
    for (const double d : drifts) c["drift"].push_back(five_decimals(d));
    if (no_mixture(modes).empty()) add_mixture(modes, drifts, data.options.confidence, c);
    const fragility::KaplanMeier km = fragility::kaplan_meier(limits_of(group, state));
    c["known_to"] = five_decimals(km.end);
    c["steps"] = Json::array();
    if (only_limits(limits_of(group, state))) { // one value is no curve
        c["limit"] = limit_text(data, level, state);
        return c;
    }
    for (const auto& s : km.steps)
        c["steps"].push_back({five_decimals(s.at), five_decimals(s.probability)});
    return c;
}

std::string interval_text(const core::Interval& i, int digits)
{
    return "[" + fixed(i.lower, digits) + ", " +
           (std::isfinite(i.upper) ? fixed(i.upper, digits) : std::string("no limit")) + "]";
}

Json model_json(const fragility::ModeModel& model, double low, double high, double confidence)
{
    Json m;
    constexpr int kPoints = 61;
    for (int i = 0; i < kPoints; ++i) {
        Eigen::VectorXd at(1);
        at(0) = low + (high - low) * i / (kPoints - 1);
        const auto p = fragility::mode_probability(model, 0, at, confidence);
        m["stress"].push_back(five_decimals(at(0)));
        m["value"].push_back(five_decimals(p.value));
        m["lower"].push_back(five_decimals(p.interval.lower));
        m["upper"].push_back(five_decimals(p.interval.upper));
    }
    return m;
}

std::string equal_text(const fragility::ModeModel& model, const fragility::ModeData& data,
                       double confidence)
{
    const auto e =
        fragility::equal_modes(model, data, 0, 1, 0, Eigen::VectorXd::Zero(1), confidence);
    if (!e.found) return "No stress at which both modes are equally likely: " + e.reason + ".";
    const auto stress = data.covariates.col(0);
    if (e.at < stress.minCoeff() || e.at > stress.maxCoeff())
        return "Neither mode is overtaken by the other between the stresses studied.";
    return "Both modes are equally likely at " + fixed(e.at, 2) + " MPa " +
           interval_text(e.delta, 2) + ".";
}

void add_model(Json& modes, const fragility::ModeData& data, double confidence)
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
    modes["model"] = model_json(model, stress.minCoeff(), stress.maxCoeff(), confidence);
    const bool firth = model.penalty == fragility::ModePenalty::firth;
    modes["note"] = std::string("Line: logistic regression on the stress") +
                    (firth ? ", with Firth's penalty (" + model.reason + ")" : "") +
                    (f.degrees > 0 ? "; lack of fit: " + test : "") + ". " +
                    equal_text(model, data, confidence);
}

struct ModeCount {
    double stress = 0.0; ///< [MPa]
    double rocking = 0.0, sliding = 0.0, walls = 0.0;
};

ModeCount mode_count(const StudyWalls& study, std::size_t level)
{
    ModeCount c{1e-6 * study.levels[level].stress};
    for (const StudyWall& w : study.levels[level].walls) {
        c.rocking += w.reading.mode == dem::FailureMode::rocking ? 1.0 : 0.0;
        c.sliding += w.reading.mode == dem::FailureMode::sliding ? 1.0 : 0.0;
    }
    c.walls = static_cast<double>(study.levels[level].walls.size());
    return c;
}

fragility::ModeData mode_data(const std::vector<ModeCount>& counts)
{
    const auto n = static_cast<Eigen::Index>(counts.size());
    fragility::ModeData data{Eigen::MatrixXd(n, 1), Eigen::MatrixXd(n, 2)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const ModeCount& c = counts[i];
        data.covariates(i, 0) = c.stress;
        data.counts.row(i) << c.rocking, c.walls - c.rocking;
    }
    return data;
}

} // namespace

Json fragility_json(const DriftData& data)
{
    Json states = Json::array();
    for (std::size_t s = 0; s < data.states.size(); ++s) {
        Json curves = Json::array();
        const std::vector<double> drifts = drift_grid(data, s, kDrifts);
        for (std::size_t g = 0; g < data.groups.size() && !drifts.empty(); ++g)
            if (!limits_of(data.groups[g], s).empty())
                curves.push_back(curve_json(data, s, g, drifts));
        states.push_back({{"name", state_name(data.states[s])},
                          {"rule", data.states[s].rule},
                          {"curves", curves}});
    }
    return states;
}

Json modes_json(const StudyWalls& study)
{
    Json modes = {{"levels", Json::array()},
                  {"note", ""},
                  {"either_way", undecided_text(study.study.fragility)}};
    std::vector<ModeCount> counts;
    for (std::size_t level = 0; level < study.levels.size(); ++level) {
        const ModeCount c = mode_count(study, level);
        if (c.walls == 0.0) continue;
        const fragility::Share s =
            mode_share(study.levels[level], kRocking, study.study.fragility.confidence);
        modes["levels"].push_back({{"stress", c.stress},
                                   {"value", s.value},
                                   {"lower", s.interval.lower},
                                   {"upper", s.interval.upper},
                                   {"sliding", c.sliding / c.walls},
                                   {"walls", c.walls}});
        counts.push_back(c);
    }
    if (counts.size() >= 2)
        add_model(modes, mode_data(counts), study.study.fragility.confidence);
    return modes;
}

} // namespace app
