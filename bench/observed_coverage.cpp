/// How often the drifts of the tables hold the truth where walls are two heaps, which no law of two
/// parameters describes: of the law alone, and by the rule that a rejected law gives way to the shares
/// observed; writes docs/bench/observed_coverage.md.

#include "bench/report.hpp"

#include "fragility/goodness_of_fit.hpp"
#include "fragility/observed_quantile.hpp"
#include "fragility/performance_limits.hpp"
#include "tests/fragility/fit_data.hpp"

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

constexpr std::size_t kSamples = 199; ///< behind a p-value
constexpr double kFirst = 0.6;        ///< share of the lower heap
constexpr std::array<Distribution, 2> kHeaps{Distribution{Law::lognormal, 0.0, 0.05},
                                             Distribution{Law::lognormal, 1.0, 0.10}};

struct Case {
    std::size_t walls;
    bool stopped; ///< all runs between the heaps: the upper heap is censored
};

/// Quantile of the two heaps, by bisection.
double truth(double p)
{
    double low = 0.1, high = 10.0;
    for (int i = 0; i < 200; ++i) {
        const double x = 0.5 * (low + high);
        const double f = kFirst * cdf(kHeaps[0], x) + (1.0 - kFirst) * cdf(kHeaps[1], x);
        (f < p ? low : high) = x;
    }
    return high;
}

std::vector<Observation> study(const Case& c, std::uint64_t which)
{
    const double stop = c.stopped ? 2.0 : std::numeric_limits<double>::infinity();
    std::vector<Observation> data;
    for (std::size_t k = 0; k < c.walls; ++k) {
        const bool first = uniform(fit_data::bits(9'000'000 + which, 2 * k)) < kFirst;
        const double x = quantile(kHeaps[first ? 0 : 1],
                                  uniform(fit_data::bits(9'000'000 + which, 2 * k + 1)));
        data.push_back(x < stop ? observed(x) : right_censored(stop));
    }
    return data;
}

bool rejected(const std::vector<Observation>& data, std::uint64_t which)
{
    const auto bits = [which](std::uint64_t r, std::uint64_t draw) {
        return fit_data::bits(100'000'000 + 1000 * which + r, draw);
    };
    return least_p(goodness_of_fit(fit(Law::lognormal, data), data, bits, kSamples)) <
           kRejected;
}

struct Tally {
    int studies = 0, rejected = 0;
    std::array<int, 5> law{}, rule{};
};

Tally tally(const Case& c, int studies)
{
    Tally t;
    for (int i = 0; i < studies; ++i) {
        const auto which = static_cast<std::uint64_t>(i);
        const auto data = study(c, which);
        const PerformanceLimits limits = performance_limits(Law::lognormal, data);
        if (!limits.fitted) continue;
        ++t.studies;
        const bool out = rejected(data, which);
        t.rejected += out;
        const auto seen = observed_quantiles(data, kLimitShares);
        for (std::size_t q = 0; q < kLimitShares.size(); ++q) {
            const double x = truth(kLimitShares[q]);
            const auto holds = [&](const Interval& i) { return i.lower <= x && x <= i.upper; };
            const bool law = holds(limits.drifts[q].interval);
            t.law[q] += law;
            t.rule[q] += out ? holds(seen[q].interval) : law;
        }
    }
    return t;
}

void write(const std::string& path, int studies)
{
    app::Table table;
    table.head = {"walls", "censored", "rejected [%]", "by",  "5 %",
                  "16 %",  "50 %",     "84 %",         "95 %"};
    for (const Case& c : {Case{30, false}, {60, false}, {30, true}, {60, true}}) {
        const Tally t = tally(c, studies);
        const auto percent = [&](int n) {
            return app::Number{.value = 100.0 * n / t.studies, .decimals = 1};
        };
        for (const bool rule : {false, true}) {
            app::Row row = {std::to_string(c.walls), c.stopped ? "upper heap" : "none",
                            percent(t.rejected), rule ? "the rule" : "the law alone"};
            for (const int held : rule ? t.rule : t.law) row.emplace_back(percent(held));
            table.rows.push_back(row);
        }
    }
    const std::string opening =
        "Limit drifts of walls that are two heaps: lognormal around 1 (60 % of the walls, "
        "dispersion "
        "0.05) and around 2.72 (dispersion 0.10); with \"upper heap\" all runs stop at 2. How "
        "often do "
        "the 95 % intervals of the 5 to 95 % drifts hold the truth [%], of " +
        std::to_string(studies) +
        " studies? The rule: where a goodness-of-fit test rejects the lognormal law (p < "
        "0.01, " +
        std::to_string(kSamples) +
        " samples), the interval is that of the shares observed "
        "(fragility/observed_quantile.hpp), "
        "which holds what it cannot bound. Rejected: share of the studies.";
    bench::write_report(path, {"Coverage of observed drifts", opening, {{"", "", "", table}}});
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: observed_coverage OUT.md [STUDIES=500]\n", stderr);
        return 2;
    }
    write(argv[1], argc > 2 ? std::atoi(argv[2]) : 500);
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "observed_coverage: %s\n", e.what());
    return 1;
}
