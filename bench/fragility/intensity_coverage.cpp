/// How often the intervals of `drystone fragility` on the intensity of an earthquake hold the
/// truth, on synthetic studies; writes docs/bench/fragility/intensity_coverage.md.

#include "bench/report.hpp"
#include "core/interval.hpp"

#include "fragility/fits/bootstrap_random.hpp"
#include "fragility/intensity/intensity_fit.hpp"
#include "fragility/laws/standard_law.hpp"
#include "tests/fragility/fit_data.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace fragility;

constexpr double kMedian = 0.5, kSlope = 1.4, kFallsAt = 1.8; ///< of the capacity
constexpr double kThreshold = 1.0, kLeast = 0.02;

struct Design {
    const char* name;
    std::size_t walls, records;
    bool paired;
    double of_records, of_walls, rest; ///< standard deviations of ln capacity
};

double dispersion_of(const Design& d) { return std::hypot(d.of_records, d.of_walls, d.rest); }

/// ln capacity = ln median + record + wall + rest. The response is a power of the intensity,
/// and the wall falls at a multiple of its capacity.
std::vector<ShakenWallPoint> study(const Design& d, std::uint64_t which)
{
    const auto normal = [&](std::uint64_t kind, std::uint64_t i) {
        return StandardNormal::quantile(
            uniform(fit_data::bits(70'000'000 + 4 * which + kind, i)));
    };
    std::vector<ShakenWallPoint> all;
    for (std::size_t w = 0; w < d.walls; ++w)
        for (std::size_t r = 0; r < d.records; ++r) {
            if (d.paired && r != w % d.records) continue;
            const double capacity =
                kMedian * std::exp(d.of_records * normal(0, r) + d.of_walls * normal(1, w) +
                                   d.rest * normal(2, w * d.records + r));
            for (const double x : {0.15, 0.25, 0.35, 0.5, 0.7, 1.0, 1.4, 2.0}) {
                const bool fell = x > kFallsAt * capacity;
                const double seen = std::min(x, kFallsAt * capacity) / capacity;
                all.push_back({w, r, x, kThreshold * std::pow(seen, kSlope), fell});
            }
        }
    return all;
}

struct Tally {
    int held = 0, records_alone = 0, dispersions = 0, asked = 0;
    double width = 0.0;
};

bool holds(const core::Interval& i, double x) { return i.lower <= x && x <= i.upper; }

Tally tally(const Design& d, IntensityMethod method, int studies)
{
    Tally t;
    for (int i = 0; i < studies; ++i) {
        const std::vector<ShakenWallPoint> points = study(d, static_cast<std::uint64_t>(i));
        const ClusteredFit c = fit_clustered(method, points, kThreshold, kLeast);
        if (!c.reason.empty()) continue;
        ++t.asked;
        t.held += holds(c.median, kMedian);
        t.dispersions += holds(c.dispersion, dispersion_of(d));
        t.records_alone += std::abs(std::log(c.fit.curve.median / kMedian)) <=
                           StandardNormal::quantile(0.975) * c.record_error;
        t.width += std::log(c.median.upper / c.median.lower);
    }
    return t;
}

app::Number tenth(double x) { return {.value = x, .decimals = 1}; }

void write(const std::string& path, int studies)
{
    const std::vector<Design> designs = {
        {"few walls, many records, walls differ much", 4, 20, false, 0.15, 0.35, 0.1},
        {"few walls, many records", 5, 40, false, 0.35, 0.15, 0.1},
        {"the same number", 15, 15, false, 0.3, 0.3, 0.2},
        {"many walls, few records", 30, 6, false, 0.35, 0.15, 0.1},
        {"only the rest", 10, 10, false, 0.0, 0.0, 0.4},
        {"one wall", 1, 20, false, 0.35, 0.0, 0.1},
        {"a record for each wall", 40, 40, true, 0.35, 0.15, 0.1},
        {"each record for five walls", 40, 8, true, 0.35, 0.15, 0.1}};
    constexpr std::array kMethods = {std::pair{IntensityMethod::stripes, "stripes"},
                                     std::pair{IntensityMethod::ida, "IDA"},
                                     std::pair{IntensityMethod::cloud, "cloud"}};
    app::Table table;
    table.head = {"design",
                  "walls",
                  "records",
                  "method",
                  "answers",
                  "median held [%]",
                  "by records alone [%]",
                  "dispersion held [%]",
                  "width of ln median"};
    for (const Design& d : designs)
        for (const auto& [method, name] : kMethods) {
            const Tally t = tally(d, method, studies);
            const double n = std::max(1, t.asked);
            table.rows.push_back({d.name, std::to_string(d.walls), std::to_string(d.records),
                                  name, std::to_string(t.asked), tenth(100.0 * t.held / n),
                                  tenth(100.0 * t.records_alone / n),
                                  tenth(100.0 * t.dispersions / n),
                                  app::Number{.value = t.width / n, .decimals = 2}});
        }
    const std::string opening =
        "How often do the 95 % intervals of median and dispersion on the intensity hold the "
        "truth? " +
        std::to_string(studies) +
        " synthetic studies of each kind, by the functions of the program "
        "(fragility/intensity/intensity_fit.hpp) in this process: ln capacity = record + wall "
        "+ rest, "
        "all "
        "normal, at eight intensities. Answers: studies that give an interval. By records "
        "alone: the normal interval with the jackknife error of records, which knows nothing "
        "of the walls. Error of a percentage near 95: 1.1 of 400.";
    bench::write_report(path, {"Coverage on intensity", opening, {{"", "", "", table}}});
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: intensity_coverage OUT.md [STUDIES=400]\n", stderr);
        return 2;
    }
    write(argv[1], argc > 2 ? std::atoi(argv[2]) : 400);
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "intensity_coverage: %s\n", e.what());
    return 1;
}
