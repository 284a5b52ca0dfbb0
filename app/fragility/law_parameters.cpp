#include "app/fragility/drift_fits.hpp"
#include "app/fragility/fragility_limits.hpp"
#include "app/fragility/table_texts.hpp"
#include "app/output/cells.hpp"
#include "app/text/number_text.hpp"
#include "fragility/censored_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

using fragility::Law;

constexpr std::array kLaws = {Law::lognormal, Law::normal, Law::weibull, Law::gamma};

struct Parameter {
    const char* name;
    double value, std_error;
};

struct LawParameters {
    Parameter first, second;
    double correlation; ///< of both estimates
};

/// The law's own parameters are first = value, ln second = ... of (location, ln dispersion): their
/// covariance is J C J' to first order.
LawParameters parameters_of(const fragility::Fit& fit)
{
    const double location = fit.law.location, dispersion = fit.law.dispersion;
    const Eigen::Matrix2d& c = fit.covariance;
    Eigen::Matrix2d j = Eigen::Matrix2d::Identity();
    LawParameters p{};
    switch (fit.law.law) {
    case Law::lognormal:
    case Law::normal:
        p = {{"ln median", location, 0.0}, {"dispersion", dispersion, 0.0}, 0.0};
        if (fit.law.law == Law::normal) {
            p.first.name = "mean";
            p.second.name = "std deviation";
        }
        j(1, 1) = dispersion;
        break;
    case Law::weibull: // shape = 1 / dispersion, scale = exp(location)
    case Law::gamma:   // shape = 1 / dispersion^2, scale = exp(location) dispersion^2
        p = {{"shape", fragility::shape(fit.law), 0.0},
             {"scale", fragility::scale(fit.law), 0.0},
             0.0};
        const double power = fit.law.law == Law::weibull ? 1.0 : 2.0;
        j << 0.0, -power * p.first.value, p.second.value,
            (fit.law.law == Law::weibull ? 0.0 : 2.0) * p.second.value;
        break;
    }
    const Eigen::Matrix2d v = j * c * j.transpose();
    p.first.std_error = std::sqrt(v(0, 0));
    p.second.std_error = std::sqrt(v(1, 1));
    p.correlation = v(0, 1) / (p.first.std_error * p.second.std_error);
    return p;
}

Cell value_of(const Parameter& p)
{
    return with_error(p.value, p.std_error, std::max(0, decimals_for(p.std_error) - 1));
}

Row law_row(const DriftData& data, std::size_t g, std::size_t s, Law law)
{
    const auto observations = limits_of(data.groups[g], s);
    const fragility::Fit fit = fragility::fit(law, observations);
    Row row = {group_cell(data.groups[g]), state_name(data.states[s]), std::string(name(law)),
               count(static_cast<double>(observations.size()))};
    if (fit.outcome != fragility::FitOutcome::converged) {
        row.insert(row.end(), {{}, {}, {}, {}, {}, {}, "No fit: " + fit.reason + "."});
        return row;
    }
    const JudgedFit chosen = judged_fit(data, g, s);
    const bool refused = law == data.options.law && rejected(chosen);
    const LawParameters p = parameters_of(fit);
    row.insert(row.end(),
               {std::string(p.first.name), value_of(p.first), std::string(p.second.name),
                value_of(p.second), plain_number(p.correlation, 2), plain_number(fit.aic, 1),
                refused ? "The goodness-of-fit tests reject this law (p = " +
                              number(fragility::least_p(chosen.tests), 2) + ")."
                        : std::string()});
    return row;
}

} // namespace

Table law_table(const DriftData& data)
{
    Table t = titled_table("law_parameters", words_of(data));
    t.keys = 3;
    t.head = {data.group_head,
              "limit state",
              "law",
              "n",
              "first parameter",
              {"first value", kError},
              "second parameter",
              {"second value", kError},
              "correlation",
              "AIC",
              {"note", kNote}};
    for (std::size_t g = 0; g < data.groups.size(); ++g)
        for (std::size_t s = 0; s < data.states.size(); ++s)
            for (const Law law : kLaws) t.rows.push_back(law_row(data, g, s, law));
    return t;
}

} // namespace app
