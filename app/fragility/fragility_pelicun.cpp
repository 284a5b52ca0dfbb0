#include "app/fragility/fragility_limits.hpp"

#include "app/fragility/drift_fits.hpp"
#include "app/output/markup.hpp"
#include "app/output/unique_names.hpp"
#include "app/study/fragility_text.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace app {
namespace {

constexpr std::size_t kMostStates = 4;

struct Parameters {
    double median, dispersion;
    double known_to; ///< drift up to which walls were seen [rad]
};

/// A lognormal fit of a limit state [rad]; nothing without.
std::optional<Parameters> parameters(const DriftData& data, std::size_t g, std::size_t state,
                                     std::string& rejection)
{
    if (!(data.percent > 0.0)) return {};
    const JudgedFit f = judged_lognormal(data, g, state);
    if (rejected(f))
        rejection += "; " + state_name(data.states[state]) +
                     ": the tests reject the lognormal law (p = " +
                     number(fragility::least_p(f.tests), 2) + ")";
    if (const std::string limit = limit_text(data, g, state); !limit.empty())
        rejection += "; " + state_name(data.states[state]) + ": " + limit;
    if (!describes(f)) return {};
    const double radians = data.percent / 100.0;
    return Parameters{std::exp(f.fit.law.location) * radians, f.fit.law.dispersion,
                      known_to(limits_of(data.groups[g], state)) * radians};
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

std::string head_line()
{
    std::string line = "ID,Incomplete,Demand-Type,Demand-Unit,Demand-Offset,Demand-Directional";
    for (std::size_t i = 1; i <= kMostStates; ++i)
        for (const char* const field : {"Family", "Theta_0", "Theta_1", "DamageStateWeights"})
            line += ",LS" + std::to_string(i) + "-" + field;
    return line + ",Notes\n";
}

/// "0.5 MPa: LS1 tested up to 0.002 rad; LS2 tested up to 0.027 rad (median extrapolated)"
std::string notes(const DriftGroup& group, const std::vector<std::optional<Parameters>>& found)
{
    std::string text = group.name + ":";
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!found[i]) continue;
        text += (text.back() == ':' ? " LS" : "; LS") + std::to_string(i + 1) +
                " tested up to " + number(found[i]->known_to, 4) + " rad";
        if (found[i]->median > found[i]->known_to) text += " (median extrapolated)";
    }
    return text;
}

/// Limit states of one set in one row, or in several where it has more than fit in one.
std::string line(const DriftData& data, std::size_t group, const std::string& id,
                 const std::vector<std::size_t>& states)
{
    std::vector<std::optional<Parameters>> found;
    std::string rejection;
    for (const std::size_t s : states) found.push_back(parameters(data, group, s, rejection));
    const bool whole = std::ranges::all_of(found, [](const auto& p) { return p.has_value(); });
    if (whole) std::ranges::stable_sort(found, {}, [](const auto& p) { return p->median; });
    std::string text = id + (whole ? ",0" : ",1") + ",Peak Interstory Drift Ratio,rad,0,1";
    for (std::size_t i = 0; i < kMostStates; ++i) {
        if (i >= states.size()) {
            text += ",,,,";
        } else if (found[i]) {
            text += ",lognormal," + number(found[i]->median, 6) + "," +
                    number(found[i]->dispersion, 6) + ",";
        } else {
            text += ",lognormal,,,";
        }
    }
    return text + "," + csv_cell(notes(data.groups[group], found) + rejection) + "\n";
}

} // namespace

std::string pelicun_csv(const DriftData& data)
{
    std::string text = head_line();
    UniqueNames ids;
    for (const std::string& set : sets_of(data))
        for (std::size_t g = 0; g < data.groups.size(); ++g) {
            std::vector<std::size_t> states;
            for (std::size_t s = 0; s < data.states.size(); ++s)
                if (data.states[s].set == set) states.push_back(s);
            std::size_t part = 0;
            while (!states.empty()) {
                const std::size_t n = std::min(kMostStates, states.size());
                std::string id = "DRYSTONE." + (set.empty() ? "" : id_part(set) + ".") +
                                 id_part(data.groups[g].name);
                if (states.size() > kMostStates || part > 0)
                    id += ".part" + std::to_string(++part);
                text += line(data, g, ids.add(id), {states.begin(), states.begin() + n});
                states.erase(states.begin(), states.begin() + n);
            }
        }
    return text;
}

} // namespace app
