#include "bench/tested/comparison.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace {

using Catch::Matchers::Contains;

/// Drops to 80 % at 1.4 mm.
const bench::CurveTable kDrops{{0.0, 1.0, 3.0}, {0.0, 10.0, 0.0}};
const bench::CurveTable kHolds{{0.0, 1.0, 29.85}, {0.0, 20.0, 20.0}};
const bench::CurveTable kNothing{{0.0, 1.0}, {0.0, 0.0}};

bench::LevelComparison level(double stress_MPa, const bench::CurveTable& ours, bool tested)
{
    bench::LevelComparison l{stress_MPa, bench::facts("drystone", ours), {}};
    if (tested) l.tests = {bench::facts("SW.1", kDrops), bench::facts("SW.2", kHolds)};
    return l;
}

} // namespace

TEST_CASE("comparison: a level has its tests, their mean, the paper and the ratios",
          "[fragility][comparison]")
{
    const std::vector<bench::LevelComparison> levels = {level(0.50, kHolds, true)};
    const std::string text = bench::comparison_markdown(levels);
    // 0.28 x 47.71 + 0.72 x 45.90 = 46.41 kN
    CHECK_THAT(text,
               Contains("| 0.50 | 10.0 (SW.1), 20.0 (SW.2) | 15.0 | 47.7 | 45.9 | 46.4 | 20.0 "
                        "| 1.33 | 0.43 |\n"));
    CHECK_THAT(text, Contains("| 0.50 | 1.40 (SW.1), > 29.85 (SW.2) | 18.3 | > 29.85 |\n"));
}

TEST_CASE("comparison: what a level does not have is a dash", "[fragility][comparison]")
{
    const std::vector<bench::LevelComparison> levels = {
        level(0.15, kDrops, true), level(0.75, kDrops, false), level(0.60, kNothing, false)};
    const std::string text = bench::comparison_markdown(levels);
    CHECK_THAT(text, Contains("| 15.0 | 16.2 | - | 16.2 | 10.0 | 0.67 | 0.62 |\n"));
    CHECK_THAT(text, Contains("| 0.75 | - | - | 69.5 | 63.9 | 65.8 | 10.0 | - | 0.15 |\n"));
    CHECK_THAT(text, Contains("| 0.60 | - | - | - | - | - | 0.0 | - | - |\n"));
    CHECK_THAT(text, Contains("| 0.60 | - | - | - |\n"));
}

TEST_CASE("comparison: the long table has a row per source and empty cells, never nan",
          "[fragility][comparison]")
{
    const std::vector<bench::LevelComparison> levels = {level(1.25, kHolds, true),
                                                        level(0.60, kNothing, false)};
    CHECK(bench::comparison_csv(levels) == "stress_MPa,source,peak_force_kN,drystone_over_"
                                           "source,ultimate_displacement_mm,censored\n"
                                           "1.25,drystone,20,1,29.85,1\n"
                                           "1.25,SW.1,10,2,1.4,0\n"
                                           "1.25,SW.2,20,1,29.85,1\n"
                                           "1.25,mean of tests,15,1.33333,,\n"
                                           "1.25,paper rocking mean,112.13,0.178364,,\n"
                                           "1.25,paper mixed mean,100.72,0.19857,16.26,0\n"
                                           "1.25,paper mean of all walls,101.633,0.196787,,\n"
                                           "0.60,drystone,0,,,\n");
}
