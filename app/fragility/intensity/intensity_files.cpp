#include "app/fragility/intensity/intensity_output.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/output/picture/markup.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace app {
namespace {

/// A state with the curve that stands for it.
struct StateCurve {
    std::size_t state = 0;
    const char* method = "";
    fragility::IntensityCurve curve{};
};

/// Curves of one stress in the order of their medians.
std::vector<StateCurve> state_curves(const IntensityData& data,
                                     const std::vector<IntensityFits>& fits, bool residuals)
{
    std::vector<StateCurve> all;
    for (std::size_t s = 0; s < fits.size(); ++s) {
        if (!residuals && data.states[s].of == IntensityResponse::residual) continue;
        if (const auto m = chosen_fit(fits[s]))
            all.push_back({s, kIntensityMethods[*m].second, fits[s].by[*m]->fit.curve});
    }
    std::ranges::stable_sort(all, {}, [](const StateCurve& c) { return c.curve.median; });
    return all;
}

struct MeasureName {
    std::string name; ///< empty: none
    std::string unit;
    double value = 1.0; ///< of the unit, in that of IntensityData
};

MeasureName openquake_measure(const IntensityData& data)
{
    using Kind = ground::MeasureKind;
    constexpr double kCentimetres = 0.01;
    switch (data.measure.kind) {
    case Kind::pga:
        return {"PGA", "g", 1.0};
    case Kind::pgv:
        return {"PGV", "cm/s", kCentimetres};
    case Kind::sa:
        return {"SA(" + number(data.measure.period, 6) + ")", "g", 1.0};
    default:
        return {};
    }
}

MeasureName pelicun_measure(const IntensityData& data)
{
    using Kind = ground::MeasureKind;
    switch (data.measure.kind) {
    case Kind::pga:
        return {"Peak Ground Acceleration", "g", 1.0};
    case Kind::pgv:
        return {"Peak Ground Velocity", "mps", 1.0};
    case Kind::sa:
        return {"Spectral Acceleration|" + number(data.measure.period, 6), "g", 1.0};
    default:
        return {};
    }
}

/// "drift_0.5" of "drift 0.5 %": names of limit states have no blanks.
std::string state_word(const std::string& name)
{
    std::string word;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.';
        if (plain || (!word.empty() && word.back() != '_')) word += plain ? c : '_';
    }
    while (word.ends_with('_')) word.pop_back();
    return word;
}

std::string xml_name(const std::string& name)
{
    constexpr Replacement kXml[] = {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}};
    return replaced(name, kXml);
}

/// Largest and least intensity of the histories of a stress [unit of the measure].
std::pair<double, double> intensity_range(const IntensityData& data, std::size_t level)
{
    double least = HUGE_VAL, most = 0.0;
    for (const auto& p : shaken_points(data, level, data.states.front())) {
        least = std::min(least, p.intensity);
        most = std::max(most, p.intensity);
    }
    return {least, most};
}

} // namespace

std::string openquake_xml(const IntensityData& data, const AllIntensityFits& fits)
{
    constexpr int kDigits = 6;
    const MeasureName measure = openquake_measure(data);
    // The engine wants the same limit states, in the same order, for all functions.
    std::vector<std::size_t> states;
    if (!measure.name.empty() && !fits.empty())
        for (const StateCurve& c : state_curves(data, fits.front(), false))
            states.push_back(c.state);
    std::string functions;
    for (std::size_t l = 0; l < fits.size() && !states.empty(); ++l) {
        const std::vector<StateCurve> curves = state_curves(data, fits[l], false);
        std::string lines;
        for (const std::size_t s : states) {
            const auto at = std::ranges::find(curves, s, &StateCurve::state);
            if (at == curves.end()) break;
            const double median = at->curve.median / measure.value, b = at->curve.dispersion;
            const double mean = median * std::exp(0.5 * b * b);
            lines += "      <params ls=\"" + state_word(data.states[s].name) + "\" mean=\"" +
                     number(mean, kDigits) + "\" stddev=\"" +
                     number(mean * std::sqrt(std::expm1(b * b)), kDigits) + "\"/>\n";
        }
        if (static_cast<std::size_t>(std::ranges::count(lines, '\n')) != states.size())
            continue; // a state without a curve under this stress
        const auto [least, most] = intensity_range(data, l);
        functions +=
            "    <fragilityFunction id=\"wall_" + level_file(data.histories.levels[l]) +
            "\" format=\"continuous\" shape=\"logncdf\">\n      <imls imt=\"" + measure.name +
            "\" noDamageLimit=\"" + number(0.1 * least / measure.value, kDigits) +
            "\" minIML=\"" + number(0.1 * least / measure.value, kDigits) + "\" maxIML=\"" +
            number(2.0 * most / measure.value, kDigits) + "\"/>\n" + lines +
            "    </fragilityFunction>\n";
    }
    if (functions.empty()) return {};
    std::string names;
    for (const std::size_t s : states)
        names += (names.empty() ? "" : " ") + state_word(data.states[s].name);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<nrml xmlns=\"http://openquake.org/xmlns/nrml/0.5\">\n"
           "  <fragilityModel id=\"drystone\" assetCategory=\"buildings\" "
           "lossCategory=\"structural\">\n    <description>" +
           xml_name(data.histories.name) + ": walls of blocks shaken in their plane; " +
           measure.name + " in " + measure.unit +
           ", mean and stddev of the intensity itself; no error of the model; verified, not "
           "validated</description>\n    <limitStates>" +
           names + "</limitStates>\n" + functions + "  </fragilityModel>\n</nrml>\n";
}

std::string intensity_pelicun_csv(const IntensityData& data, const AllIntensityFits& fits)
{
    const MeasureName measure = pelicun_measure(data);
    if (measure.name.empty()) return {};
    std::string text = pelicun_head();
    for (std::size_t l = 0; l < fits.size(); ++l) {
        std::vector<StateCurve> curves = state_curves(data, fits[l], true);
        const std::size_t all = data.states.size();
        std::string note = level_file(data.histories.levels[l]) + ":";
        std::string cells;
        for (std::size_t i = 0; i < kPelicunStates; ++i) {
            if (i >= curves.size()) {
                cells += ",,,,";
                continue;
            }
            const StateCurve& c = curves[i];
            cells += ",lognormal," + number(c.curve.median, 6) + "," +
                     number(c.curve.dispersion, 6) + ",";
            note += (note.back() == ':' ? " LS" : "; LS") + std::to_string(i + 1) + " " +
                    data.states[c.state].name + " by " + c.method;
        }
        if (curves.size() < all)
            note +=
                "; " + counted(all - curves.size(), "state has", "states have") + " no curve";
        if (curves.size() > kPelicunStates)
            note += "; " +
                    counted(curves.size() - kPelicunStates, "severer state does",
                            "severer states do") +
                    " not fit in";
        std::string id = level_file(data.histories.levels[l]);
        std::ranges::replace(id, '-', '_'); // pelicun splits at hyphens
        text += "DRYSTONE.shaken." + id + (curves.size() < all ? ",1," : ",0,") + measure.name +
                "," + measure.unit + ",0,1" + cells + "," + csv_cell(note) + "\n";
    }
    return text;
}

} // namespace app
