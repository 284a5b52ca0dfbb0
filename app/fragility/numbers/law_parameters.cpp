#include "fragility/fits/law_parameters.hpp"
#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/table/cells.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

using fragility::Law;

constexpr std::array kLaws = {Law::lognormal, Law::normal, Law::weibull, Law::gamma};

Number value_of(const fragility::LawParameter& p)
{
    return with_error(p.value, p.std_error, std::max(0, decimals_for(p.std_error) - 1));
}

void add_law(const DriftData& data, std::size_t g, std::size_t s, Law law, Table& t)
{
    const auto observations = limits_of(data.groups[g], s);
    const fragility::Fit fit = fragility::fit(law, observations);
    const Row start = {group_cell(data.groups[g]), state_name(data.states[s]),
                       std::string(name(law)), count(observations.size())};
    if (fit.outcome != fragility::FitOutcome::converged)
        return add_row(t, start, "No fit: " + fit.reason + ".");
    const JudgedFit chosen = judged_fit(data, g, s);
    const bool refused = law == data.options.law && rejected(chosen);
    const fragility::LawParameters p = fragility::law_parameters(fit);
    add_row(t,
            joined(start, {std::string(p.first.name), value_of(p.first),
                           std::string(p.second.name), value_of(p.second),
                           plain_number(p.correlation, 2), plain_number(fit.aic, 1)}),
            refused ? "The goodness-of-fit tests reject this law (p = " +
                          number(fragility::least_p(chosen.tests), 2) + ")."
                    : "");
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
            for (const Law law : kLaws) add_law(data, g, s, law, t);
    return t;
}

} // namespace app
