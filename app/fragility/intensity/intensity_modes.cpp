#include "app/fragility/intensity/intensity_modes.hpp"

#include "app/fragility/intensity/intensity_output.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/output/table/cells.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/stored/study_walls.hpp"
#include "core/binomial.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "fragility/fits/share.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace app {
namespace {

using dem::FailureMode;
using fragility::ShakenWallPoint;

constexpr std::array kModes = {FailureMode::rocking, FailureMode::sliding, FailureMode::mixed};

double reached_of(const std::vector<ShakenWallPoint>& points, const IntensityState& state)
{
    return static_cast<double>(std::ranges::count_if(points, [&](const ShakenWallPoint& p) {
        return p.fell || p.response > state.threshold;
    }));
}

/// Median and dispersion of the curve that stands, and why there is none.
Row curve_cells(const IntensityFits& fits, std::string& note)
{
    const auto chosen = chosen_fit(fits);
    const fragility::ClusteredFit& c = *fits.by[chosen.value_or(0)];
    if (!chosen) {
        note = "No curve: " + c.fit.reason + ".";
        return {std::string(), Number{}, Number{}};
    }
    if (!c.reason.empty()) note = "No interval: " + c.reason + ".";
    Row row = {std::string(kIntensityMethods[*chosen].second)};
    return joined(std::move(row), intensity_curve_cells(c));
}

} // namespace

Table intensity_mode_table(const IntensityData& data)
{
    Table t;
    t.title = "Fragility by failure mode";
    t.caption =
        "The mode of a history is that where its wall turned back from the largest drift, or "
        "fell. Share: of the histories that reached the state, with a Wilson interval that "
        "takes them as independent and holds whatever the failed ones would have been. The "
        "curve is that of the histories of this mode alone: P(state reached | " +
        data.measure_name +
        ", mode). With the shares of the modes at an intensity the curves add up to that of "
        "all. There is no IDA, as a wall under a record may change its mode from one intensity "
        "to the next.";
    t.head = {"stress [MPa]",
              "state",
              "mode",
              {"share [%]", kInterval},
              "method",
              {"median [" + data.unit + "]", kInterval},
              {"dispersion", kInterval},
              {"reached", kDetail},
              {"n", kDetail},
              {"note", kNote}};
    t.keys = 3;
    for (std::size_t l = 0; l < data.histories.levels.size(); ++l) {
        const HistoryLevel& level = data.histories.levels[l];
        const auto failed = static_cast<double>(
            std::ranges::count(level.histories, true, &StoredHistory::failed));
        for (const IntensityState& s : data.states) {
            const double all = reached_of(shaken_points(data, l, s), s);
            for (const FailureMode mode : kModes) {
                const std::vector<ShakenWallPoint> points = shaken_points(data, l, s, mode);
                if (points.empty()) continue;
                const double reached = reached_of(points, s);
                Row row = {stress_cell(level.stress), s.name, std::string(dem::name(mode))};
                if (all > 0.0) {
                    const fragility::Share share = fragility::share(
                        reached, all, failed, core::BinomialInterval::wilson, data.confidence);
                    row.emplace_back(percent(share.value, share.interval, 0));
                } else {
                    row.emplace_back(Number{});
                }
                std::string note;
                row =
                    joined(std::move(row), curve_cells(intensity_fits(data, l, s, mode), note));
                add_row(t, joined(std::move(row), {count(reached), count(points.size())}),
                        std::move(note));
            }
        }
    }
    return t;
}

std::vector<NamedPicture> intensity_mode_pictures(const IntensityData& data)
{
    std::vector<NamedPicture> all;
    for (const HistoryLevel& level : data.histories.levels) {
        struct Stripe {
            std::vector<double> intensity;
            std::array<double, kModes.size()> modes{};
        };
        std::map<std::size_t, Stripe> stripes;
        for (const StoredHistory& h : level.histories) {
            if (h.failed) continue;
            Stripe& s = stripes[h.intensity];
            s.intensity.push_back(h.measures.at(data.column) / data.unit_value);
            s.modes[static_cast<std::size_t>(std::ranges::find(kModes, h.mode) -
                                             kModes.begin())] += 1.0;
        }
        if (stripes.size() < 2) continue; // no axis
        Chart c;
        c.title = stress_text(level.stress);
        c.x_label = "median " + data.measure_name + " [" + data.unit + "]";
        c.y_label = "share of the histories";
        for (std::size_t m = 0; m < kModes.size(); ++m) {
            std::vector<std::pair<double, double>> dots;
            for (auto& [intensity, s] : stripes) {
                std::ranges::sort(s.intensity);
                const auto n = static_cast<double>(s.intensity.size());
                dots.emplace_back(s.intensity[s.intensity.size() / 2], s.modes[m] / n);
            }
            std::ranges::sort(dots);
            Series line;
            line.name = std::string(dem::name(kModes[m]));
            line.colour = palette(m);
            line.points = true;
            for (const auto& [x, share] : dots) {
                line.x.push_back(x);
                line.y.push_back(share);
            }
            c.series.push_back(std::move(line));
        }
        all.push_back({"modes_" + level_file(level),
                       "Failure modes at each intensity under " + c.title, line_chart(c)});
    }
    return all;
}

} // namespace app
