#include "fragility/intensity/crossed_design.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

/// Records, walls and interaction of these standard deviations about a mean of 1.
Eigen::MatrixXd crossed(int records, int walls, double r, double w, double e,
                        std::uint64_t seed)
{
    uq::Stream random(seed, 0, uq::Purpose::monte_carlo);
    Eigen::MatrixXd y = Eigen::MatrixXd::Constant(records, walls, 1.0);
    for (int i = 0; i < records; ++i) y.row(i).array() += r * random.normal();
    for (int j = 0; j < walls; ++j) y.col(j).array() += w * random.normal();
    for (double& cell : y.reshaped()) cell += e * random.normal();
    return y;
}

} // namespace

TEST_CASE("crossed design: an exact table splits exactly", "[fragility][crossed_design]")
{
    Eigen::MatrixXd y(2, 2); // means of rows 1, 3, of columns 1.5, 2.5, no interaction
    y << 0.5, 1.5, 2.5, 3.5;
    const auto s = fragility::variance_split(y);
    CHECK(s.mean == 2.0);
    CHECK(s.records == Approx(2.0));
    CHECK(s.walls == Approx(0.5));
    CHECK(s.interaction == Approx(0.0).margin(1e-12));
    CHECK(s.mean_error == Approx(std::sqrt(2.0 / 2.0 + 0.5 / 2.0)));
    CHECK_THROWS_AS(fragility::variance_split(y.topRows(1)), std::invalid_argument);
}

TEST_CASE(
    "crossed design: .1727 comes apart into records .1364, walls .0244 and interaction .0119",
    "[fragility][crossed_design]")
{
    double records = 0.0, walls = 0.0, interaction = 0.0, total = 0.0;
    constexpr int kTables = 200;
    for (int k = 0; k < kTables; ++k) {
        const auto s = fragility::variance_split(
            crossed(44, 60, std::sqrt(.1364), std::sqrt(.0244), std::sqrt(.0119), 7 + k));
        records += s.records / kTables;
        walls += s.walls / kTables;
        interaction += s.interaction / kTables;
        total += s.total / kTables;
    }
    CHECK(records == Approx(.1364).epsilon(0.05));
    CHECK(walls == Approx(.0244).epsilon(0.05));
    CHECK(interaction == Approx(.0119).epsilon(0.01));
    CHECK(total == Approx(.1727).epsilon(0.05));
}

TEST_CASE("crossed design: 95 % intervals hold the mean in 93 to 97 of 100 studies, with few "
          "walls too",
          "[fragility][crossed_design]")
{
    const auto [records, walls, r, w] = GENERATE(table<int, int, double, double>(
        {{44, 60, 0.37, 0.16}, {44, 5, 0.37, 0.4}, {20, 8, 0.3, 0.3}}));
    constexpr int kStudies = 3000;
    int held = 0, held_by_records = 0;
    for (int k = 0; k < kStudies; ++k) {
        const Eigen::MatrixXd y = crossed(records, walls, r, w, 0.11, 1000 + k);
        const auto i = fragility::mean_interval(fragility::variance_split(y));
        held += i.lower < 1.0 && 1.0 < i.upper;
        // the trap: records alone as the sample
        const Eigen::VectorXd by_record = y.rowwise().mean();
        const double mean = by_record.mean();
        const double error =
            std::sqrt((by_record.array() - mean).square().sum() / (records - 1.0) / records);
        held_by_records += std::abs(mean - 1.0) < 2.05 * error;
    }
    INFO(records << " records, " << walls << " walls: " << 100.0 * held / kStudies
                 << " %, by records alone " << 100.0 * held_by_records / kStudies << " %");
    CHECK(held > 0.93 * kStudies);
    CHECK(held < 0.97 * kStudies);
    if (walls == 5) CHECK(held_by_records < 0.65 * kStudies);
}
