/// How often intervals hold the true value: synthetic studies of a lognormal law with 0, 20 and
/// 60 % right-censored; writes docs/bench/fragility/interval_coverage.md.

#include "bench/report.hpp"
#include "core/interval.hpp"

#include "fragility/fits/fit_intervals.hpp"
#include "tests/fragility/fit_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace fragility;

constexpr Distribution kTruth{Law::lognormal, 0.0, 0.4}; ///< scale-free; dispersion of a drift
constexpr std::size_t kWalls = 50;
constexpr double kHigh = 0.97; ///< coverage called right: 93 to 97 %
constexpr double kLow = 0.93;
constexpr std::array<Quantity, 2> kQuantities{median(), dispersion()};
constexpr std::array<const char*, 2> kKinds{"Wald on ln", "profile likelihood"};

struct Tally {
    int held = 0, below = 0, above = 0, asked = 0; ///< truth below / above the interval
    double log_width = 0.0;
    int open = 0;
};
using Tallies = std::array<std::array<Tally, kKinds.size()>, kQuantities.size()>;

/// The interval that the profile likelihood is compared with: 1.96 standard errors on the axis
/// that suits the quantity.
core::Interval wald_interval(const Fit& fit, Quantity q)
{
    constexpr double kHalf = 1.959963984540054; // of 95 %
    const Uncertain u = uncertain(fit, q);
    const double half = kHalf * u.axis_error;
    if (u.logarithmic) return {u.value * std::exp(-half), u.value * std::exp(half), 0.95};
    return {u.value - half, u.value + half, 0.95};
}

void note(Tally& t, const core::Interval& i, double truth)
{
    ++t.asked;
    t.held += i.lower <= truth && truth <= i.upper;
    t.below += truth < i.lower;
    t.above += truth > i.upper;
    if (std::isfinite(i.upper) && i.lower > 0.0)
        t.log_width += std::log(i.upper / i.lower);
    else
        ++t.open;
}

std::vector<Observation> study(double censored, std::uint64_t which)
{
    const double limit = censored > 0.0 ? quantile(kTruth, 1.0 - censored)
                                        : std::numeric_limits<double>::infinity();
    std::vector<Observation> data;
    for (std::size_t k = 0; k < kWalls; ++k) {
        const double x = quantile(kTruth, uniform(fit_data::bits(7'000'000 + which, k)));
        data.push_back(x < limit ? observed(x) : right_censored(limit));
    }
    return data;
}

/// @return false: no fit
bool judge(double censored, std::uint64_t which, Tallies& tallies)
{
    const std::vector<Observation> data = study(censored, which);
    const Fit f = fit(kTruth.law, data);
    if (f.outcome != FitOutcome::converged) return false;
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
        const double truth = value(kTruth, kQuantities[q]);
        auto& t = tallies[q];
        note(t[0], wald_interval(f, kQuantities[q]), truth);
        note(t[1], profile_interval(f, data, kQuantities[q]), truth);
    }
    return true;
}

std::string shown(double x, const char* format)
{
    char text[32];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

void add_rows(app::Table& table, double censored, int no_fit, const Tallies& tallies)
{
    for (std::size_t q = 0; q < kQuantities.size(); ++q)
        for (std::size_t k = 0; k < kKinds.size(); ++k) {
            const Tally& t = tallies[q][k];
            const double n = t.asked;
            const double share = t.held / n;
            const bool right = share >= kLow && share <= kHigh;
            table.rows.push_back(
                {shown(100.0 * censored, "%.0f"), q == 0 ? "median" : "dispersion", kKinds[k],
                 shown(100.0 * share, "%.1f"),
                 shown(100.0 * std::sqrt(share * (1.0 - share) / n), "%.1f"),
                 right ? "yes" : "no", shown(100.0 * t.below / n, "%.1f"),
                 shown(100.0 * t.above / n, "%.1f"), shown(t.log_width / (n - t.open), "%.3f"),
                 std::to_string(t.open), std::to_string(no_fit)});
        }
}

/// Which kinds hold 93 to 97 % in every row, and which do not.
std::string verdict(const app::Table& table)
{
    std::string all;
    std::string not_all;
    for (const char* kind : kKinds) {
        int missed = 0;
        double least = 100.0;
        double most = 0.0;
        for (const auto& row : table.rows) {
            if (app::cell_text(row[2]) != kind) continue;
            missed += app::cell_text(row[5]) == "no";
            least = std::min(least, std::stod(app::cell_text(row[3])));
            most = std::max(most, std::stod(app::cell_text(row[3])));
        }
        std::string& list = missed == 0 ? all : not_all;
        list += (list.empty() ? "" : "; ") + std::string(kind) + " (" + shown(least, "%.1f") +
                " to " + shown(most, "%.1f") + " %)";
    }
    return "Within 93 to 97 % in every row: " + (all.empty() ? "none" : all) +
           ". Not in every row: " + (not_all.empty() ? "none" : not_all) + ".";
}

void write(const std::string& path, int studies)
{
    app::Table table;
    table.head = {"censored [%]",  "of",         "interval",        "holds [%]",
                  "error [%]",     "93 to 97 %", "truth below [%]", "truth above [%]",
                  "mean ln width", "open",       "no fit"};
    for (const double censored : {0.0, 0.2, 0.6}) {
        Tallies tallies{};
        int no_fit = 0;
        for (int i = 0; i < studies; ++i)
            no_fit += !judge(censored, static_cast<std::uint64_t>(i), tallies);
        add_rows(table, censored, no_fit, tallies);
        std::fprintf(stderr, "%.0f %% censored: done\n", 100.0 * censored);
    }
    const std::string opening =
        "How often do 95 % intervals hold the true value? " + std::to_string(studies) +
        " synthetic studies of 50 walls each, lognormal with a dispersion of 0.4, all walls "
        "stopped at the drift that the stated share of walls exceeds. Error: of the coverage, "
        "from the number of studies. Truth below and above: "
        "2.5 % each would be even. Width: mean ln(upper / lower). Open: intervals without an "
        "upper "
        "end.\n\n" +
        verdict(table) +
        " Tables show the profile likelihood (fragility/fits/fit_intervals.hpp).";
    bench::write_report(path, {"Coverage of intervals", opening, {{"", "", "", table}}});
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: interval_coverage OUT.md [STUDIES=2000]\n", stderr);
        return 2;
    }
    write(argv[1], argc > 2 ? std::atoi(argv[2]) : 2000);
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "interval_coverage: %s\n", e.what());
    return 1;
}
