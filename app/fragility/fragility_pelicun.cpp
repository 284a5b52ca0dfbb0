#include "app/fragility/numbers/fragility_limits.hpp"

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/fragility/numbers/model_doubt.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/unique_names.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/number_text.hpp"
#include "fragility/limits/model_factor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace app {
namespace {

struct PelicunParameters {
    double median; ///< that of limits_with_doubt [rad]
    fragility::Dispersions dispersion;
    double factor;   ///< median of that factor [-]
    bool doubted;    ///< else the dispersion is that from wall to wall alone
    double known_to; ///< drift up to which walls were seen [rad]
};

/// The 16, 50 and 84 % drifts of performance_limits; nothing where one of them is not known.
std::optional<std::array<double, 3>> middle_drifts(const LimitDrifts& limits)
{
    if (limits.quantiles.at.size() != fragility::kLimitShares.size()) return {};
    const auto& at = limits.quantiles.at;
    if (!at[1].value || !at[2].value || !at[3].value || !(*at[1].value > 0.0)) return {};
    return std::array{*at[1].value, *at[2].value, *at[3].value};
}

/// A lognormal law of the drift limit of piers, which has no error of the model: through the
/// median, and the distance of the 16 and 84 % drifts.
PelicunParameters pier_parameters(const std::array<double, 3>& middle, double radians,
                                  double end)
{
    constexpr double kDeviates = 2.0 * 0.994457883209753; // of 16 and 84 %
    const double material = std::log(middle[2] / middle[0]) / kDeviates;
    return {middle[1] * radians, fragility::dispersions(material, 0.0, {}), 1.0, false, end};
}

/// Median and dispersion of a limit state [rad]; nothing without.
/// @param reasons why there is none
std::optional<PelicunParameters> parameters(const DriftData& data, std::size_t g,
                                            std::size_t state, std::string& reasons)
{
    if (!(data.percent > 0.0)) return {};
    const LimitDrifts limits = limit_drifts(data, g, state);
    const auto walls = limits_of(data.groups[g], state);
    const double radians = data.percent / 100.0;
    const double tested = limits.quantiles.tested_to;
    const double end = (std::isfinite(tested) ? tested : known_to(walls)) * radians;
    const std::string name = "; " + state_name(data.states[state]) + ": ";
    const bool mixed = fragility::is_mixture(limits.quantiles.source);
    const JudgedFit f = judged_lognormal(data, g, state);
    if (rejected(f) && !mixed)
        reasons += name + "the tests reject the lognormal law (p = " +
                   number(fragility::least_p(f.tests), 2) + ")";
    if (const std::string limit = limit_text(data, g, state); !limit.empty())
        reasons += name + limit;
    const auto middle = middle_drifts(limits);
    const bool by_law = limits.quantiles.source == fragility::QuantileSource::law;
    if (!middle || !(mixed || (by_law && describes(f)))) {
        const auto& at = limits.quantiles.at;
        if (!at.empty() && !at[3].value)
            reasons += name + "84 % of the walls reach it beyond the drift tested, " +
                       number(end, 4) + " rad";
        return {};
    }
    if (const std::string pier = pier_text(data, g, state); !pier.empty()) {
        reasons += name + "drift limit of " + pier + " of walls";
        return pier_parameters(*middle, radians, end);
    }
    const auto limit = doubted_limit(data, g, state);
    const bool doubted = data.groups[g].model.source != "none";
    const auto known = [](const fragility::QuantileBounds& q) {
        return std::isfinite(q.upper) && q.upper <= q.lower * (1.0 + 1e-9);
    };
    if (!limit || !known(limit->quantiles[1]) ||
        !std::isfinite(doubted ? limit->dispersion.total : limit->dispersion.material)) {
        reasons += name + "limits_with_doubt has no median and dispersion of it";
        return {};
    }
    if (!of_one_law(limits.quantiles))
        reasons += name + "through the 16, 50 and 84 % drifts of the shares observed";
    return PelicunParameters{limit->quantiles[1].lower * radians, limit->dispersion,
                             data.groups[g].model.factor.median, doubted, end};
}

std::vector<std::string> sets_of(const DriftData& data)
{
    std::vector<std::string> sets;
    for (const StateName& s : data.states)
        if (std::ranges::find(sets, s.set) == sets.end()) sets.push_back(s.set);
    return sets;
}

std::string id_part(const std::string& text)
{
    std::string safe = file_name(text);
    std::ranges::replace(safe, '-', '_'); // pelicun splits at hyphens
    return safe;
}

/// ", dispersion: material 0.5, sampling 0.07, model 0.4"; nothing without an error of the
/// model
std::string dispersion_text(const PelicunParameters& p)
{
    if (!p.doubted) return {};
    return ", dispersion: material " + number(p.dispersion.material, 3) + ", sampling " +
           number(p.dispersion.sampling, 3) + ", model " + number(p.dispersion.model, 3) +
           (p.factor == 1.0 ? "" : ", median times " + number(p.factor, 3));
}

/// "0.5 MPa: LS1 tested up to 0.002 rad; LS2 tested up to 0.027 rad"
std::string notes(const DriftGroup& group,
                  const std::vector<std::optional<PelicunParameters>>& found)
{
    std::string text = group.name + ":";
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i]) continue;
        text += (text.back() == ':' ? " LS" : "; LS") + std::to_string(i + 1) +
                " tested up to " + number(found[i]->known_to, 4) + " rad";
        text += dispersion_text(*found[i]);
    }
    return text;
}

/// Limit states of one set in one row, or in several where it has more than fit in one.
std::string line(const DriftData& data, std::size_t group, const std::string& id,
                 const std::vector<std::size_t>& states)
{
    std::vector<std::optional<PelicunParameters>> found;
    std::string rejection;
    for (const std::size_t s : states) found.push_back(parameters(data, group, s, rejection));
    const bool whole = std::ranges::all_of(found, [](const auto& p) { return p.has_value(); });
    if (whole) std::ranges::stable_sort(found, {}, [](const auto& p) { return p->median; });
    std::string text = id + (whole ? ",0" : ",1") + ",Peak Interstory Drift Ratio,rad,0,1";
    for (std::size_t i = 0; i < kPelicunStates; ++i) {
        if (i >= states.size()) {
            text += ",,,,";
        } else if (found[i]) {
            text += ",lognormal," + number(found[i]->median, 6) + "," +
                    number(found[i]->doubted ? found[i]->dispersion.total
                                             : found[i]->dispersion.material,
                           6) +
                    ",";
        } else {
            text += ",lognormal,,,";
        }
    }
    return text + "," + csv_cell(notes(data.groups[group], found) + rejection) + "\n";
}

} // namespace

std::string pelicun_head()
{
    std::string line = "ID,Incomplete,Demand-Type,Demand-Unit,Demand-Offset,Demand-Directional";
    for (std::size_t i = 1; i <= kPelicunStates; ++i)
        for (const char* const field : {"Family", "Theta_0", "Theta_1", "DamageStateWeights"})
            line += ",LS" + std::to_string(i) + "-" + field;
    return line + ",Notes\n";
}

std::string pelicun_csv(const DriftData& data)
{
    std::string text = pelicun_head();
    UniqueNames ids;
    for (const std::string& set : sets_of(data))
        for (std::size_t g = 0; g < data.groups.size(); ++g) {
            std::vector<std::size_t> states;
            for (std::size_t s = 0; s < data.states.size(); ++s)
                if (data.states[s].set == set) states.push_back(s);
            std::size_t part = 0;
            while (!states.empty()) {
                const std::size_t n = std::min(kPelicunStates, states.size());
                std::string id = "DRYSTONE." + (set.empty() ? "" : id_part(set) + ".") +
                                 id_part(data.groups[g].name);
                if (states.size() > kPelicunStates || part > 0)
                    id += ".part" + std::to_string(++part);
                text += line(data, g, ids.add(id), {states.begin(), states.begin() + n});
                states.erase(states.begin(), states.begin() + n);
            }
        }
    return text;
}

} // namespace app
