/// How often the factor that `drystone calibrate` finds from tests holds a known truth, on
/// synthetic tests; writes docs/bench/fragility/factor_coverage.md.

#include "app/fragility/numbers/tested_walls.hpp"
#include "app/text/number_text.hpp"
#include "bench/report.hpp"

#include "fragility/laws/standard_law.hpp"
#include "tests/fragility/fit_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace {

constexpr double kMedian = 0.8; ///< of test over prediction

struct Truth {
    double levels;  ///< tau, scatter of stresses about the median [ln]
    double repeats; ///< s, scatter of tests under one stress [ln]
};
constexpr std::array<Truth, 5> kTruths{
    {{0.0, 0.1}, {0.1, 0.2}, {0.2, 0.3}, {0.3, 0.3}, {0.5, 0.5}}};

struct Tests {
    int levels, repeats;
    double ended; ///< share of the tests that end before their drop [-]
};
constexpr std::array<Tests, 6> kTests{
    {{3, 1, 0.0}, {4, 2, 0.0}, {4, 2, 0.3}, {2, 4, 0.0}, {8, 1, 0.0}, {10, 3, 0.0}}};

/// Counts of the sets of tests whose factor holds the truth.
struct Tally {
    int asked = 0, median = 0, dispersion = 0, further = 0, middle = 0;
    double width = 0.0; ///< sum of ln(upper / lower) of the median
};

/// Random numbers of one set of tests, in the order of their calls.
struct Draws {
    std::uint64_t set, next = 0;
    double uniform() { return fragility::uniform(fit_data::bits(11'000'000 + set, next++)); }
    double normal() { return fragility::StandardNormal::quantile(uniform()); }
};

double ratio(const Truth& t, double level, Draws& draws)
{
    return std::exp(std::log(kMedian) + level + t.repeats * draws.normal());
}

/// A test that ended reached a share of its drop, evenly between 40 % and all of it.
std::vector<app::TestedWall> draw(const Truth& t, const Tests& tests, Draws& draws)
{
    std::vector<app::TestedWall> walls;
    for (int i = 0; i < tests.levels; ++i) {
        const double level = t.levels * draws.normal();
        for (int j = 0; j < tests.repeats; ++j) {
            app::TestedWall w{"", 1e5 * (i + 1), ratio(t, level, draws), 1.0, false};
            w.at_least = draws.uniform() < tests.ended;
            if (const double reached = 0.4 + 0.6 * draws.uniform(); w.at_least)
                w.measured *= reached;
            walls.push_back(w);
        }
    }
    return walls;
}

bool holds(const core::Interval& i, double x) { return i.lower <= x && x <= i.upper; }

Tally judge(const Truth& t, const Tests& tests, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        Draws draws{static_cast<std::uint64_t>(k)};
        const std::vector<app::TestedWall> walls = draw(t, tests, draws);
        if (std::ranges::count(walls, false, &app::TestedWall::at_least) < 3) continue;
        const app::EstimatedFactor e = app::estimated_factor(walls);
        const double further = ratio(t, t.levels * draws.normal(), draws);
        const double deviate = std::log(further / e.factor.median) / model_dispersion(e.factor);
        ++tally.asked;
        tally.median += holds(e.median, kMedian);
        tally.dispersion += holds(e.dispersion, std::hypot(t.levels, t.repeats));
        tally.further += std::abs(deviate) < fragility::StandardNormal::quantile(0.95);
        tally.middle += std::abs(deviate) < fragility::StandardNormal::quantile(0.84);
        tally.width += std::log(e.median.upper / e.median.lower);
    }
    return tally;
}

app::Row row_of(const Truth& t, const Tests& tests, const Tally& tally)
{
    const auto share = [&](int held) { return app::fixed(100.0 * held / tally.asked, 1); };
    return {app::fixed(t.levels, 1),
            app::fixed(t.repeats, 1),
            std::to_string(tests.levels) + " x " + std::to_string(tests.repeats),
            app::fixed(100.0 * tests.ended, 0),
            share(tally.median),
            share(tally.dispersion),
            share(tally.further),
            share(tally.middle),
            app::fixed(tally.width / tally.asked, 2)};
}

void write(const std::string& path, int sets)
{
    app::Table table;
    table.head = {"scatter of stresses", "of repeats",     "stresses x tests",
                  "ended [%]",           "median [%]",     "dispersion [%]",
                  "further wall [%]",    "16 to 84 % [%]", "ln width of median"};
    for (const Truth& t : kTruths)
        for (const Tests& tests : kTests)
            table.rows.push_back(row_of(t, tests, judge(t, tests, sets)));
    const std::string opening =
        "How often do the factor of `drystone calibrate` and its intervals of 90 % hold a "
        "known "
        "truth? " +
        std::to_string(sets) +
        " synthetic sets of tests a row, with a median of test over prediction of 0.8. "
        "Scatters "
        "are those of ln. Ended: tests that end at 40 to 100 % of their drop. Median and "
        "dispersion: the intervals of 90 % hold them. Further wall, under a further stress: "
        "within 90 %, and within 16 to 84 % (68 %), of the lognormal factor that "
        "`model_factor.ini` states. Error of a share: " +
        app::fixed(100.0 * std::sqrt(0.09 / sets), 1) + " %.";
    bench::write_report(path, {"Coverage of the model factor", opening, {{"", "", "", table}}});
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: factor_coverage OUT.md [SETS=1000]\n", stderr);
        return 2;
    }
    write(argv[1], argc > 2 ? std::atoi(argv[2]) : 1000);
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "factor_coverage: %s\n", e.what());
    return 1;
}
