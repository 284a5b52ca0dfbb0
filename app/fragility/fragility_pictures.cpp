#include "app/fragility/fragility_curves.hpp"

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/number_text.hpp"
#include "fragility/fits/kaplan_meier.hpp"
#include "fragility/limits/fragility_curve.hpp"

#include <algorithm>

namespace app {
namespace {

using fragility::Observation;

constexpr std::size_t kChartDrifts = 120;

/// "Limit state SLD (ntc)": fits on a chart beside the name of a group.
std::string short_title(const StateName& s)
{
    return "Limit state " + s.name + (s.set.empty() ? "" : " (" + s.set + ")");
}

/// Horizontal pieces, up to where anything is known.
Series steps(const std::vector<Observation>& limits, const std::string& name,
             const std::string& shade)
{
    Series s{name, {}, {}, shade, LineStyle::dotted, 1.4, false};
    if (limits.empty()) return s;
    const auto km = fragility::kaplan_meier(limits);
    double last = 0.0;
    s.x.push_back(0.0);
    s.y.push_back(0.0);
    for (const auto& step : km.steps) {
        s.x.insert(s.x.end(), {step.at, step.at});
        s.y.insert(s.y.end(), {last, step.probability});
        last = step.probability;
    }
    s.x.push_back(km.end);
    s.y.push_back(last);
    return s;
}

/// Two lines of one look: as far as walls were seen, and dashed beyond.
std::vector<Series> parted(const Series& line, double end)
{
    std::vector<Series> parts{line, line};
    parts[1].name.clear();
    parts[1].line = LineStyle::dashed;
    const auto seen = std::ranges::upper_bound(line.x, end) - line.x.begin();
    for (auto* const v : {&parts[0].x, &parts[0].y}) v->resize(seen);
    const auto overlap = std::max<std::ptrdiff_t>(seen - 1, 0);
    for (auto* const v : {&parts[1].x, &parts[1].y}) v->erase(v->begin(), v->begin() + overlap);
    if (parts[1].x.size() < 2) parts.pop_back();
    return parts;
}

/// Fitted curve from zero on; empty where no law describes the walls.
Series fitted(const DriftData& data, const JudgedFit& law, const std::vector<double>& drifts)
{
    Series s;
    if (!describes(law)) return s;
    for (const auto& p : fragility::fragility_curve(law.fit, drifts, data.options.confidence)) {
        s.x.push_back(p.drift);
        s.y.push_back(p.probability);
    }
    return s;
}

/// The curve of the drifts of the tables: of one law or of the mixture of modes; empty where
/// they are observed.
Series chosen_curve(const DriftData& data, std::size_t group, std::size_t state,
                    const LimitDrifts& chosen, const std::vector<double>& drifts)
{
    if (of_one_law(chosen.quantiles)) return fitted(data, chosen.judged, drifts);
    Series s;
    const auto source = chosen.quantiles.source;
    if (!fragility::is_mixture(source)) return s;
    const auto modes = source == fragility::QuantileSource::heaps
                           ? chosen.quantiles.heaps
                           : mode_groups(data, group, state);
    for (const auto& p :
         fragility::mixture_curve(modes, drifts, data.options.confidence).points) {
        s.x.push_back(p.drift);
        s.y.push_back(p.least);
    }
    return s;
}

Chart empty_chart(const DriftData& data, const std::string& title)
{
    Chart c;
    c.title = title;
    c.x_label = drift_head(data, "drift");
    c.y_label = "probability that the limit state is reached";
    c.series.push_back({"", {0.0, 0.0}, {0.0, 1.0}, "#ffffff", LineStyle::none, 0.1, false});
    return c;
}

/// Whether there is a curve to draw: walls, and not drift limits alone.
bool has_curve(const DriftGroup& group, std::size_t state)
{
    const auto limits = limits_of(group, state);
    return !limits.empty() && !only_limits(limits);
}

NamedPicture all_groups(const DriftData& data, std::size_t state,
                        const std::vector<double>& drifts)
{
    Chart c = empty_chart(data, short_title(data.states[state]));
    std::string left_out;
    for (std::size_t g = 0; g < data.groups.size(); ++g) {
        const auto limits = limits_of(data.groups[g], state);
        if (only_limits(limits)) { // one value is no curve
            left_out += (left_out.empty() ? "; left out, since it reached drift limits alone: "
                                          : ", ") +
                        data.groups[g].name;
            continue;
        }
        const LimitDrifts chosen = limit_drifts(data, g, state);
        Series line = chosen_curve(data, g, state, chosen, drifts);
        const bool found = !line.x.empty();
        line.name = data.groups[g].name;
        line.colour = palette(g);
        if (found) c.series.push_back(parted(line, chosen.quantiles.tested_to).front());
        if (!limits.empty())
            c.series.push_back(
                steps(limits, found ? "" : line.name + " (observed)", palette(g)));
    }
    const std::string file = "curve_" + state_file(data.states[state]);
    return {file,
            "fragility curves of " + state_name(data.states[state]) + " (" +
                data.states[state].rule +
                "), all walls of a group, as far as they were tested; dotted: observed shares "
                "(Kaplan-Meier)" +
                left_out,
            line_chart(c)};
}

void add_mixture(const DriftData& data, const std::vector<fragility::ModeGroup>& modes,
                 const std::vector<double>& drifts, Chart& c)
{
    Band least(palette(0), 1.2);
    Series most{.name = "upper bound where a mode has no fit",
                .colour = palette(0),
                .line = LineStyle::dashed};
    for (const auto& p :
         fragility::mixture_curve(modes, drifts, data.options.confidence).points) {
        least.add(p.drift, p.least, p.band.lower, p.band.upper);
        most.x.push_back(p.drift);
        most.y.push_back(p.most);
    }
    least.line.name = data.modes.empty() ? "fitted law" : "all modes, weighted";
    least.line.width = 2.4;
    least.low.name = least.high.name = percent_text(data.options.confidence) + " band";
    add_band(c, least);
    if (most.y != least.line.y) c.series.push_back(most);
}

NamedPicture one_group(const DriftData& data, std::size_t state, std::size_t g,
                       const std::vector<double>& drifts)
{
    const DriftGroup& group = data.groups[g];
    Chart c = empty_chart(data, group.name + ", " + short_title(data.states[state]));
    const auto modes = mode_groups(data, g, state);
    const auto all = limits_of(group, state);
    if (no_mixture(modes).empty()) add_mixture(data, modes, drifts, c);
    for (std::size_t m = 0; m < data.modes.size(); ++m) {
        const auto limits = limits_of(group, state, static_cast<int>(m));
        Series line = fitted(data, judged_fit(data, g, state, static_cast<int>(m)), drifts);
        if (line.x.empty()) continue;
        line.name = data.modes[m] + " walls alone";
        line.colour = palette(m + 1);
        for (const Series& part : parted(line, known_to(limits))) c.series.push_back(part);
    }
    Series shares = steps(all, "observed shares (Kaplan-Meier)", "#000000");
    shares.line = LineStyle::solid;
    shares.width = 1.0;
    if (!all.empty()) c.series.push_back(shares);
    return {"curve_" + state_file(data.states[state]) + "_" + file_name(group.name),
            "fragility curve of " + state_name(data.states[state]) + ", " + group.name +
                (data.modes.empty()
                     ? ": fitted law with its band"
                     : ": modes weighted by their shares, with a band; single modes dashed "
                       "where extrapolated"),
            line_chart(c)};
}

} // namespace

std::vector<NamedPicture> curve_pictures(const DriftData& data)
{
    std::vector<NamedPicture> pictures;
    for (std::size_t s = 0; s < data.states.size(); ++s) {
        const std::vector<double> drifts = drift_grid(data, s, kChartDrifts);
        const auto curves = [s](const DriftGroup& g) { return has_curve(g, s); };
        if (drifts.empty() || std::ranges::none_of(data.groups, curves)) continue;
        pictures.push_back(all_groups(data, s, drifts));
        constexpr std::size_t kMostGroups = 12; // a picture of each
        for (std::size_t g = 0; g < data.groups.size() && g < kMostGroups; ++g)
            if (has_curve(data.groups[g], s)) pictures.push_back(one_group(data, s, g, drifts));
    }
    return pictures;
}

} // namespace app
