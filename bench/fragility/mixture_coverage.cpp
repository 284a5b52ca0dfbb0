/// How often bands of the mixture over modes hold the true probability where runs end apart;
/// writes docs/bench/fragility/mixture_coverage.md.

#include "bench/report.hpp"
#include "core/interval.hpp"

#include "core/sample_quantile.hpp"
#include "fragility/limits/fragility_curve.hpp"
#include "tests/fragility/fit_data.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace fragility;

constexpr std::size_t kWalls = 50;
constexpr std::array<double, 4> kShares{0.05, 0.16, 0.50, 0.84};

struct Scene {
    const char* name;
    double rocking;                  ///< share of the first mode [-]
    std::array<Distribution, 2> law; ///< of each mode, drift in %
    double first_end, last_end;      ///< runs end evenly between these [%]
};

constexpr Distribution kMixed{Law::lognormal, 0.26, 0.5}; ///< median 1.3 %
const std::array<Scene, 4> kScenes{{
    {"both modes fall, runs end at 2.6 to 2.75 %",
     0.4,
     {{{Law::lognormal, 0.79, 0.4}, kMixed}},
     2.6,
     2.75},
    {"both modes fall, runs end at 1 to 2.75 %",
     0.4,
     {{{Law::lognormal, 0.79, 0.4}, kMixed}},
     1.0,
     2.75},
    {"rocking walls stand, runs end at 2.6 to 2.75 %",
     0.3,
     {{{Law::lognormal, 2.3, 0.4}, kMixed}},
     2.6,
     2.75},
    {"few rocking walls, runs end at 1 to 2.75 %",
     0.06,
     {{{Law::lognormal, 0.79, 0.4}, kMixed}},
     1.0,
     2.75},
}};

double truth_at(const Scene& s, double drift)
{
    return s.rocking * cdf(s.law[0], drift) + (1.0 - s.rocking) * cdf(s.law[1], drift);
}

/// Drift at which the true probability is p, by bisection.
double drift_of(const Scene& s, double p)
{
    double low = 0.0, high = 100.0;
    for (int i = 0; i < 80; ++i) {
        const double mid = 0.5 * (low + high);
        (truth_at(s, mid) < p ? low : high) = mid;
    }
    return 0.5 * (low + high);
}

std::vector<ModeGroup> study(const Scene& s, std::uint64_t which)
{
    std::vector<ModeGroup> modes(2);
    for (std::size_t k = 0; k < kWalls; ++k) {
        const auto u = [&](std::uint64_t i) {
            return uniform(fit_data::bits(9'000'000 + which, 3 * k + i));
        };
        const std::size_t mode = u(0) < s.rocking ? 0 : 1;
        const double x = quantile(s.law[mode], u(1));
        const double end = s.first_end + (s.last_end - s.first_end) * u(2);
        modes[mode].limits.push_back(x < end ? observed(x) : right_censored(end));
    }
    std::erase_if(modes, [](const ModeGroup& m) { return m.limits.empty(); });
    return modes;
}

/// Walls of all modes drawn with replacement, so that shares and fits vary together.
std::vector<ModeGroup> redrawn(const std::vector<ModeGroup>& modes, std::uint64_t replicate)
{
    std::vector<std::pair<std::size_t, Observation>> walls;
    for (std::size_t k = 0; k < modes.size(); ++k)
        for (const Observation& o : modes[k].limits) walls.emplace_back(k, o);
    std::vector<ModeGroup> drawn(modes.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const auto& [mode, o] =
            walls[fit_data::below(fit_data::bits(replicate, i), walls.size())];
        drawn[mode].limits.push_back(o);
    }
    std::erase_if(drawn, [](const ModeGroup& m) { return m.limits.empty(); });
    return drawn;
}

/// Percentiles of resampled mixtures, widened upwards by what is unknown of modes without a
/// fit. Resamples that lack a fit which the data allow are left out.
std::vector<core::Interval> bootstrap_bands(const std::vector<ModeGroup>& modes,
                                            const Mixture& whole,
                                            const std::vector<double>& drifts,
                                            std::uint64_t study, std::size_t replicates)
{
    const auto fitted = [](const Mixture& m) {
        return std::ranges::count(m.fits, FitOutcome::converged, &Fit::outcome);
    };
    std::vector<std::vector<double>> values(drifts.size());
    for (std::size_t r = 0; r < replicates; ++r) {
        const Mixture m = mixture_curve(redrawn(modes, study * 1'000'003 + r), drifts);
        if (fitted(m) < fitted(whole)) continue;
        for (std::size_t i = 0; i < drifts.size(); ++i) values[i].push_back(m.points[i].least);
    }
    std::vector<core::Interval> bands;
    for (std::size_t i = 0; i < drifts.size(); ++i) {
        std::ranges::sort(values[i]);
        bands.push_back({core::sample_quantile(values[i], 0.025),
                         core::sample_quantile(values[i], 0.975), 0.95});
        const MixturePoint& p = whole.points[i];
        bands.back().upper = std::min(1.0, bands.back().upper + p.most - p.least);
    }
    return bands;
}

struct Tally {
    int held = 0, below = 0, above = 0, asked = 0; ///< truth below / above the band
    double width = 0.0;
    void note(const core::Interval& i, double truth)
    {
        ++asked;
        held += i.lower <= truth && truth <= i.upper;
        below += truth < i.lower;
        above += truth > i.upper;
        width += i.upper - i.lower;
    }
};

struct Judged {
    std::array<Tally, kShares.size()> delta, bootstrap;
    double delta_time = 0.0, bootstrap_time = 0.0; ///< [ms] per study
};

double milliseconds(std::chrono::steady_clock::time_point since)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since)
        .count();
}

/// 30 drifts as in the tables, and those asked for.
std::vector<double> grid(const std::array<double, kShares.size()>& asked)
{
    std::vector<double> drifts(asked.begin(), asked.end());
    for (int i = 1; i <= 30; ++i) drifts.push_back(2.75 * i / 30.0);
    std::ranges::sort(drifts);
    return drifts;
}

Judged judge(const Scene& s, int studies, std::size_t replicates)
{
    std::array<double, kShares.size()> asked{};
    std::ranges::transform(kShares, asked.begin(), [&](double p) { return drift_of(s, p); });
    const std::vector<double> drifts = grid(asked);
    Judged j;
    for (int i = 0; i < studies; ++i) {
        const auto which = static_cast<std::uint64_t>(i);
        const auto modes = study(s, which);
        auto start = std::chrono::steady_clock::now();
        const Mixture m = mixture_curve(modes, drifts);
        j.delta_time += milliseconds(start) / studies;
        start = std::chrono::steady_clock::now();
        const auto bands = bootstrap_bands(modes, m, drifts, which, replicates);
        j.bootstrap_time += milliseconds(start) / studies;
        for (std::size_t k = 0; k < asked.size(); ++k) {
            const auto at =
                static_cast<std::size_t>(std::ranges::find(drifts, asked[k]) - drifts.begin());
            const MixturePoint& p = m.points[at];
            j.delta[k].note(p.band, kShares[k]);
            j.bootstrap[k].note(bands[at], kShares[k]);
        }
    }
    return j;
}

std::string shown(double x, const char* format)
{
    char text[32];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

void add_rows(app::Table& table, const Scene& s, const Judged& j)
{
    for (std::size_t k = 0; k < kShares.size(); ++k)
        for (const bool delta : {true, false}) {
            const Tally& t = (delta ? j.delta : j.bootstrap)[k];
            const double n = t.asked;
            table.rows.push_back(
                {s.name, shown(kShares[k], "%.2f"), shown(drift_of(s, kShares[k]), "%.2f"),
                 delta ? "delta method" : "bootstrap", shown(100.0 * t.held / n, "%.1f"),
                 shown(100.0 * t.below / n, "%.1f"), shown(100.0 * t.above / n, "%.1f"),
                 shown(t.width / n, "%.3f"),
                 shown(delta ? j.delta_time : j.bootstrap_time, "%.2f")});
        }
}

/// "93.1 to 98.2 %": least and most coverage of a kind of band.
std::string range(const app::Table& table, const std::string& kind)
{
    double least = 100.0, most = 0.0;
    for (const auto& row : table.rows) {
        if (app::cell_text(row[3]) != kind) continue;
        least = std::min(least, std::stod(app::cell_text(row[4])));
        most = std::max(most, std::stod(app::cell_text(row[4])));
    }
    return shown(least, "%.1f") + " to " + shown(most, "%.1f") + " %";
}

void write(const std::string& path, int studies, std::size_t replicates)
{
    app::Table table;
    table.head = {"scene",           "true probability", "drift [%]",  "band",     "holds [%]",
                  "truth below [%]", "truth above [%]",  "mean width", "time [ms]"};
    for (const Scene& s : kScenes) {
        add_rows(table, s, judge(s, studies, replicates));
        std::fprintf(stderr, "%s: done\n", s.name);
    }
    const std::string opening =
        "How often do 95 % bands of the mixture over modes hold the true probability? " +
        std::to_string(studies) + " synthetic studies of " + std::to_string(kWalls) +
        " walls for each scene; both modes lognormal, every run ended at a drift of its own. "
        "Standing: a rocking median of 10 %, of which the runs see nothing. Bootstrap: walls "
        "of "
        "both modes resampled, percentiles of " +
        std::to_string(replicates) +
        " mixtures. What is not known of a mode without a fit widens both bands upwards. Error "
        "of the coverage: " +
        shown(100.0 * std::sqrt(0.05 * 0.95 / studies), "%.1f") +
        " %.\n\nThe delta method on the logit holds " + range(table, "delta method") +
        ", the bootstrap " + range(table, "bootstrap") +
        ". The tables of `drystone fragility` have the delta method.";
    bench::write_report(path,
                        {"Coverage of bands of mixtures", opening, {{"", "", "", table}}});
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc < 2 || argc > 4) {
        std::fputs("usage: mixture_coverage OUT.md [STUDIES=2000 [REFITS=200]]\n", stderr);
        return 2;
    }
    write(argv[1], argc > 2 ? std::atoi(argv[2]) : 2000,
          argc > 3 ? static_cast<std::size_t>(std::atoi(argv[3])) : 200);
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "mixture_coverage: %s\n", e.what());
    return 1;
}
