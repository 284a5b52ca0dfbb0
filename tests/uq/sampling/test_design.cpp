#include "uq/designs/design.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;

TEST_CASE("design: sample 17 is the same alone, in a shard and in the whole", "[uq][design]")
{
    const auto kind =
        GENERATE(DesignKind::monte_carlo, DesignKind::latin_random, DesignKind::latin_centred,
                 DesignKind::latin_optimised, DesignKind::sobol);
    const Design design{kind, {40}, 6, 11};
    const Eigen::MatrixXd all = unit_cube(design);
    CHECK((unit_cube(design, 17, 18) - all.row(17)).norm() == 0.0);
    CHECK((unit_cube(design, 10, 33) - all.middleRows(10, 23)).norm() == 0.0);
    CHECK(unit_cube(design, 5, 5).rows() == 0);
    CHECK((unit_cube({kind, {40}, 6, 12}) - all).norm() > 0.1);
}

TEST_CASE("design: rows of a size stay when sizes are added", "[uq][design]")
{
    const auto kind =
        GENERATE(DesignKind::monte_carlo, DesignKind::latin_random, DesignKind::latin_centred,
                 DesignKind::latin_optimised, DesignKind::sobol);
    const Eigen::MatrixXd grown = unit_cube({kind, {50, 100, 130}, 3, 2});
    CHECK((grown.topRows(50) - unit_cube({kind, {50}, 3, 2})).norm() == 0.0);
    CHECK((grown.topRows(100) - unit_cube({kind, {50, 100}, 3, 2})).norm() == 0.0);
    CHECK(
        (grown.middleRows(90, 20) - unit_cube({kind, {50, 100, 130}, 3, 2}, 90, 110)).norm() ==
        0.0);
}

TEST_CASE("design: a variable more moves none of the others", "[uq][design]")
{
    const auto kind =
        GENERATE(DesignKind::monte_carlo, DesignKind::latin_random, DesignKind::sobol);
    const Eigen::MatrixXd few = unit_cube({kind, {30}, 5, 2});
    const Eigen::MatrixXd more = unit_cube({kind, {30}, 6, 2});
    CHECK((more.leftCols(5) - few).norm() == 0.0);
}

TEST_CASE("design: what cannot be is refused with what can", "[uq][design]")
{
    const auto refused = [](const Design& d, const char* says) {
        CHECK_THROWS_WITH(unit_cube(d), Catch::Contains(says));
        CHECK_THROWS_AS(unit_cube(d), std::invalid_argument);
    };
    refused({DesignKind::monte_carlo, {}, 1, 0}, "one at least");
    refused({DesignKind::monte_carlo, {0}, 1, 0}, "1 to 4294967296");
    refused({DesignKind::latin_random, {50, 50}, 1, 0}, "ascending, 1 to 1048576");
    refused({DesignKind::latin_random, {10}, 0, 0}, "variables are 0");
    refused({DesignKind::latin_optimised, {5000}, 2, 0}, "at most 4096");
    refused({DesignKind::sobol, {10}, 3668, 0}, "use monte_carlo or latin_random");
    CHECK_THROWS_AS(unit_cube({DesignKind::sobol, {10}, 2, 0}, 3, 11), std::invalid_argument);
    CHECK_THROWS_AS(unit_cube({DesignKind::sobol, {10}, 2, 0}, 5, 4), std::invalid_argument);
}
