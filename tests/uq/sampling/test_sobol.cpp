#include "uq/designs/sobol.hpp"

#include "uq/designs/latin.hpp"

#include "tests/uq/strata.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;
using scenes::doubled_strata;

TEST_CASE("sobol: unscrambled, the first points are those of Joe and Kuo", "[uq][sobol]")
{
    Eigen::MatrixXd printed(10, 3); // with new-joe-kuo-6.21201, their web page
    printed << 0, 0, 0, .5, .5, .5, .75, .25, .25, .25, .75, .75, .375, .375, .625, .875, .875,
        .125, .625, .125, .875, .125, .625, .375, .1875, .3125, .9375, .6875, .8125, .4375;
    const Eigen::MatrixXd u = sobol(0, 10, 3, 0, Scramble::none);
    CHECK((u - printed).cwiseAbs().maxCoeff() == 0x1p-53);
}

TEST_CASE("sobol: 2^k points are Latin in every dimension up to 3667, scrambled or not",
          "[uq][sobol]")
{
    const auto scramble = GENERATE(Scramble::none, Scramble::matrix_and_shift);
    const Eigen::MatrixXd u = sobol(0, 64, kSobolDimensions, 5, scramble);
    for (const std::int64_t doubled : doubled_strata(u)) REQUIRE(doubled == 0);
    const Eigen::MatrixXd next = sobol(64, 128, kSobolDimensions, 5, scramble);
    for (const std::int64_t doubled : doubled_strata(next)) REQUIRE(doubled == 0);
}

TEST_CASE("sobol: the first two dimensions fill every binary box alike, scrambled or not",
          "[uq][sobol]")
{
    const auto scramble = GENERATE(Scramble::none, Scramble::matrix_and_shift);
    const int side = GENERATE(1, 2, 4, 8, 16, 32, 64);
    const Eigen::MatrixXd u = sobol(0, 64, 2, 7, scramble);
    Eigen::MatrixXi count = Eigen::MatrixXi::Zero(side, 64 / side);
    for (Eigen::Index i = 0; i < 64; ++i)
        ++count(stratum(u(i, 0), side), stratum(u(i, 1), 64 / side));
    CHECK((count.array() == 1).all());
}

TEST_CASE("sobol: scrambled points are uniform one by one", "[uq][sobol]")
{
    double sum = 0.0, squares = 0.0;
    const int repeats = 20000;
    for (int r = 0; r < repeats; ++r) {
        const double u = sobol(5, 6, 1, static_cast<std::uint64_t>(r))(0, 0);
        sum += u - 0.5;
        squares += (u - 0.5) * (u - 0.5);
    }
    CHECK(std::abs(sum / repeats) < 4.0 * std::sqrt(1.0 / 12.0 / repeats));
    CHECK(std::abs(squares / repeats - 1.0 / 12.0) < 4.0 * std::sqrt(1.0 / 180.0 / repeats));
}

TEST_CASE("sobol: the mean of a smooth function converges faster than 1 / n", "[uq][sobol]")
{
    const auto error = [](std::int64_t n) { // over 20 scrambles: root of the mean square
        double squares = 0.0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Eigen::ArrayXXd u = sobol(0, n, 4, seed).array();
            squares += std::pow((1.0 + (u - 0.5)).rowwise().prod().mean() - 1.0, 2);
        }
        return std::sqrt(squares / 20.0);
    };
    CHECK(error(1024) < error(64) / 16.0);
    CHECK(error(1024) < 1e-3 * std::sqrt(std::pow(13.0 / 12.0, 4) - 1.0));
}

TEST_CASE("sobol: dimensions without direction numbers are refused", "[uq][sobol]")
{
    CHECK_THROWS_AS(sobol(0, 1, 0, 0), std::invalid_argument);
    CHECK_THROWS_WITH(sobol(0, 1, 3668, 0), Catch::Contains("1 to 3667"));
}
