#include "app/fragility/damage_curves.hpp"

#include "app/output/picture/chart_svg.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/text/number_text.hpp"

namespace app {
namespace {

using fragility::ModelOutcome;
using fragility::OrdinalFit;
using fragility::StateCounts;

constexpr const char* kAlone = "alone";
constexpr const char* kTogether = "one dispersion for all states";

/// Walls in all, and those that reached a state.
struct Totals {
    double n = 0.0, reached = 0.0;
};

Totals totals(const std::vector<StateCounts>& rows, std::size_t state)
{
    Totals t;
    for (const StateCounts& row : rows)
        for (std::size_t k = 0; k < row.walls.size(); ++k) {
            t.n += row.walls[k];
            if (k >= state) t.reached += row.walls[k];
        }
    return t;
}

Number estimate(const fragility::LogEstimate& e, double error, int decimals)
{
    return {.value = e.value,
            .error = error,
            .lower = e.interval.lower,
            .upper = e.interval.upper,
            .decimals = decimals};
}

/// @param k place of the state in the fit, from 1
void add_fit(const DamageCounts& d, std::size_t state, const OrdinalFit& f, std::size_t k,
             const char* kind, double confidence, app::Table& table)
{
    const Totals t = totals(d.rows, state);
    const Row start = {d.states[state - 1], kind, count(t.reached), count(t.n)};
    if (f.outcome != ModelOutcome::converged)
        return add_row(table, start, "No fit: " + f.reason + ".");
    const auto median = fragility::median(f, k, confidence);
    const auto dispersion = fragility::dispersion(f, confidence);
    add_row(table, joined(start, {estimate(median, kUnknown, decimals_for(median.value)),
                                  plain_number(median.log_error, 3),
                                  estimate(dispersion, dispersion.std_error, 3),
                                  plain_number(f.deviance, 2),
                                  plain_number(fragility::p_value(f), 3)}));
}

struct Fits {
    std::vector<OrdinalFit> alone; ///< of each state
    OrdinalFit together;           ///< of all; not used for one state
};

Fits fits_of(const DamageCounts& d)
{
    Fits f;
    for (std::size_t k = 1; k <= d.states.size(); ++k)
        f.alone.push_back(fragility::fit_ordinal(fragility::reaching(d.rows, k)));
    if (d.states.size() > 1) f.together = fragility::fit_ordinal(d.rows);
    return f;
}

app::Table fit_table(const DamageCounts& d, const Fits& f, double confidence)
{
    app::Table t;
    t.title = "Median and dispersion of the fragility curve of each limit state";
    t.caption =
        "Lognormal fragility curves by maximum likelihood: median of " + d.intensity +
        " and dispersion (standard deviation of its logarithm), with " +
        percent_text(confidence) +
        " intervals from their standard errors on the logarithmic axis. p: how often "
        "counts drawn from these curves would differ from them more than those of the "
        "table (chi-squared of the deviance; rough where few walls are expected in a cell).";
    t.head = {"limit state",
              "fitted",
              "reached",
              "of",
              {"median " + d.intensity, kInterval},
              {"std error of ln median", kProgramsOnly},
              {"dispersion", kInterval | kError},
              "deviance",
              "p",
              {"note", kNote}};
    t.keys = 2;
    for (std::size_t k = 1; k <= d.states.size(); ++k)
        add_fit(d, k, f.alone[k - 1], 1, kAlone, confidence, t);
    if (d.states.size() > 1)
        for (std::size_t k = 1; k <= d.states.size(); ++k)
            add_fit(d, k, f.together, k, kTogether, confidence, t);
    return t;
}

/// Share of the walls at one intensity that reached a state; not a number without walls.
double share(const StateCounts& row, std::size_t state)
{
    const Totals t = totals({row}, state);
    return t.reached / t.n;
}

app::Table curve_table(const DamageCounts& d, const OrdinalFit& f, std::size_t state,
                       std::size_t k, double confidence)
{
    app::Table t;
    t.title = "Observed shares and probability of " + d.states[state - 1];
    t.caption = "Share of walls that reached " + d.states[state - 1] +
                ", and the fitted probability with its band.";
    t.head = {d.intensity, "reached", "of", "share [%]", {"probability [%]", kInterval}};
    for (const StateCounts& row : d.rows) {
        const Totals n = totals({row}, state);
        const auto p = fragility::probability(f, k, row.intensity);
        t.rows.push_back({given(row.intensity), count(n.reached), count(n.n),
                          n.n > 0.0 ? plain_number(100.0 * n.reached / n.n, 1) : Number{},
                          percent(p.probability, fragility::band(p, confidence), 1)});
    }
    return t;
}

std::vector<double> grid(const DamageCounts& d)
{
    constexpr int kPoints = 120;
    const double most = 1.2 * d.rows.back().intensity;
    std::vector<double> x;
    for (int i = 1; i <= kPoints; ++i) x.push_back(most * i / kPoints);
    return x;
}

NamedPicture picture(const DamageCounts& d, const std::vector<const OrdinalFit*>& fits,
                     const std::vector<std::size_t>& places, double confidence)
{
    Chart c;
    c.title = "Fragility from counts";
    c.x_label = d.intensity;
    c.y_label = "probability of reaching the limit state";
    for (std::size_t s = 0; s < d.states.size(); ++s) {
        Series seen{d.states[s] + ", observed share", {}, {}, "", LineStyle::none, 1.0, true};
        for (const StateCounts& row : d.rows) {
            seen.x.push_back(row.intensity);
            seen.y.push_back(share(row, s + 1));
        }
        c.series.push_back(seen);
        if (fits[s]->outcome != ModelOutcome::converged) continue;
        c.series.back().colour = palette(s);
        Band curve(palette(s), 1.2);
        curve.line.name = d.states[s];
        curve.line.width = 2.0;
        for (const double x : grid(d)) {
            const auto p = fragility::probability(*fits[s], places[s], x);
            const auto band = fragility::band(p, confidence);
            curve.add(x, p.probability, band.lower, band.upper);
        }
        add_band(c, curve);
    }
    return {"curves", "fragility curves with their bands (dotted), and the observed shares",
            line_chart(c)};
}

} // namespace

FragilityOutput damage_output(const DamageCounts& d, double confidence)
{
    const Fits f = fits_of(d);
    const Totals all = totals(d.rows, 1);
    FragilityOutput out;
    out.source = d.source + ": " + number(all.n, 12) + " walls at " +
                 std::to_string(d.rows.size()) + " intensities";
    out.tables.push_back({"fragility_curves", fit_table(d, f, confidence), true});
    std::vector<const OrdinalFit*> shown;
    std::vector<std::size_t> places;
    const bool together = f.together.outcome == ModelOutcome::converged;
    for (std::size_t s = 0; s < d.states.size(); ++s) {
        shown.push_back(together ? &f.together : &f.alone[s]);
        places.push_back(together ? s + 1 : 1);
        if (shown.back()->outcome != ModelOutcome::converged) {
            out.remarks += d.states[s] + ": no curve: " + shown.back()->reason + "\n";
            continue;
        }
        out.tables.push_back({"curve_" + std::to_string(s + 1) + "_" + file_name(d.states[s]),
                              curve_table(d, *shown.back(), s + 1, places.back(), confidence)});
    }
    if (!d.rows.empty()) out.pictures.push_back(picture(d, shown, places, confidence));
    return out;
}

} // namespace app
