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

/// Intensities over which a function holds [unit of the measure].
struct ShownRange {
    double least, most;
};

/// Whether no curve exceeds the one before it within the range. Two lognormal curves cross at
/// one intensity at most, so that both ends tell.
bool ordered(const std::vector<StateCurve>& curves, const ShownRange& range)
{
    for (std::size_t i = 1; i < curves.size(); ++i)
        for (const double x : {range.least, range.most})
            if (share_reached(curves[i].curve, x) > share_reached(curves[i - 1].curve, x))
                return false;
    return true;
}

constexpr int kDigits = 6;

/// The curves as lognormal laws of the intensity itself.
std::string continuous_function(const IntensityData& data, const MeasureName& measure,
                                const std::vector<StateCurve>& curves, const ShownRange& range)
{
    const auto shown = [&](double x) { return number(x / measure.value, kDigits); };
    std::string text = "\" format=\"continuous\" shape=\"logncdf\">\n      <imls imt=\"" +
                       measure.name + "\" noDamageLimit=\"" + shown(range.least) +
                       "\" minIML=\"" + shown(range.least) + "\" maxIML=\"" +
                       shown(range.most) + "\"/>\n";
    for (const StateCurve& c : curves) {
        const double b = c.curve.dispersion, mean = c.curve.median * std::exp(0.5 * b * b);
        text += "      <params ls=\"" + state_word(data.states[c.state].name) + "\" mean=\"" +
                shown(mean) + "\" stddev=\"" + shown(mean * std::sqrt(std::expm1(b * b))) +
                "\"/>\n";
    }
    return text;
}

/// Curves that cross, by points: each is lifted to the severer ones where it lies below them,
/// since the engine takes the difference of neighbours as the probability of a damage state.
/// @param lifted the states that were
std::string discrete_function(const IntensityData& data, const MeasureName& measure,
                              const std::vector<StateCurve>& curves, const ShownRange& range,
                              std::vector<std::string>& lifted)
{
    constexpr int kPoints = 60;
    std::vector<double> at;
    std::string text;
    for (int i = 0; i < kPoints; ++i) {
        at.push_back(range.least * std::pow(range.most / range.least, i / (kPoints - 1.0)));
        text += (i == 0 ? "" : " ") + number(at.back() / measure.value, kDigits);
    }
    text = "\" format=\"discrete\">\n      <imls imt=\"" + measure.name +
           "\" noDamageLimit=\"" + number(range.least / measure.value, kDigits) + "\">" + text +
           "</imls>\n";
    std::vector<double> severer(kPoints, 0.0);
    std::string lines;
    for (std::size_t k = curves.size(); k-- > 0;) {
        const std::string& name = data.states[curves[k].state].name;
        bool below = false;
        std::string row;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double own = share_reached(curves[k].curve, at[i]);
            below = below || own < severer[i];
            severer[i] = std::max(severer[i], own);
            row += (i == 0 ? "" : " ") + number(severer[i], kDigits);
        }
        if (below) lifted.push_back(name);
        lines = "      <poes ls=\"" + state_word(name) + "\">" + row + "</poes>\n" + lines;
    }
    return text + lines;
}

std::string with_commas(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Why states of the study are not in the file; empty where all are.
std::string left_out_states(const IntensityData& data, const std::vector<std::size_t>& states)
{
    std::vector<std::string> residual, no_curve;
    for (std::size_t s = 0; s < data.states.size(); ++s) {
        if (std::ranges::count(states, s) > 0) continue;
        const bool of_residual = data.states[s].of == IntensityResponse::residual;
        (of_residual ? residual : no_curve).push_back(data.states[s].name);
    }
    std::string text;
    if (!residual.empty())
        text += "; left out, as residual drifts do not stand in one order with largest ones: " +
                with_commas(residual);
    if (!no_curve.empty())
        text += "; left out, without a curve under " +
                level_file(data.histories.levels.front()) + ": " + with_commas(no_curve);
    return text;
}

} // namespace

std::string openquake_xml(const IntensityData& data, const AllIntensityFits& fits)
{
    const MeasureName measure = openquake_measure(data);
    // The engine wants the same limit states, in the same order, for all functions.
    std::vector<std::size_t> states;
    if (!measure.name.empty() && !fits.empty())
        for (const StateCurve& c : state_curves(data, fits.front(), false))
            states.push_back(c.state);
    std::string functions, remarks = left_out_states(data, states);
    for (std::size_t l = 0; l < fits.size() && !states.empty(); ++l) {
        const std::string level = level_file(data.histories.levels[l]);
        const std::vector<StateCurve> all = state_curves(data, fits[l], false);
        std::vector<StateCurve> curves;
        std::vector<std::string> missing, lifted;
        for (const std::size_t s : states)
            if (const auto at = std::ranges::find(all, s, &StateCurve::state); at != all.end())
                curves.push_back(*at);
            else
                missing.push_back(data.states[s].name);
        if (!missing.empty()) {
            remarks += "; " + level + " left out, without a curve of " + with_commas(missing);
            continue;
        }
        const auto [least, most] = intensity_range(data, l);
        const ShownRange range{0.1 * least, 2.0 * most};
        functions +=
            "    <fragilityFunction id=\"wall_" + level +
            (ordered(curves, range) ? continuous_function(data, measure, curves, range)
                                    : discrete_function(data, measure, curves, range, lifted)) +
            "    </fragilityFunction>\n";
        if (!lifted.empty())
            remarks += "; " + level + ": curves cross, lifted to those of severer states: " +
                       with_commas(lifted);
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
           "validated" +
           xml_name(remarks) + "</description>\n    <limitStates>" + names +
           "</limitStates>\n" + functions + "  </fragilityModel>\n</nrml>\n";
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
