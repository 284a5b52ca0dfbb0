#include "uq/designs/latin.hpp"

#include "uq/designs/design.hpp"
#include "uq/designs/stream.hpp"

#include "tests/uq/strata.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace uq;
using scenes::doubled_strata;

namespace {

/// Rows in each of m strata, least and most over all strata and variables.
struct Filling {
    int least, most;
};

Filling filling(const Eigen::MatrixXd& u, int m)
{
    Filling f{1 << 30, 0};
    for (Eigen::Index j = 0; j < u.cols(); ++j) {
        Eigen::VectorXi count = Eigen::VectorXi::Zero(m);
        for (Eigen::Index i = 0; i < u.rows(); ++i)
            ++count[static_cast<Eigen::Index>(std::floor(u(i, j) * m))];
        f.least = std::min(f.least, count.minCoeff());
        f.most = std::max(f.most, count.maxCoeff());
    }
    return f;
}

Eigen::MatrixXd latin(DesignKind kind, std::vector<std::int64_t> sizes, int d,
                      std::uint64_t seed = 1)
{
    return unit_cube({kind, std::move(sizes), d, seed});
}

} // namespace

TEST_CASE("latin: each stratum of each variable holds one row", "[uq][latin]")
{
    const auto kind = GENERATE(DesignKind::latin_random, DesignKind::latin_centred,
                               DesignKind::latin_optimised);
    const int n = GENERATE(1, 2, 7, 50, 100);
    const Eigen::MatrixXd u = latin(kind, {n}, 5);
    const Filling f = filling(u, n);
    CHECK(f.least == 1);
    CHECK(f.most == 1);
    CHECK(u.minCoeff() > 0.0);
    CHECK(u.maxCoeff() < 1.0);
    if (kind == DesignKind::latin_centred)
        CHECK((u * n)
                  .unaryExpr([](double x) { return std::abs(x - std::floor(x) - 0.5); })
                  .maxCoeff() < 1e-12);
}

TEST_CASE("latin: no row lies on the edge of a stratum, of a million neither", "[uq][latin]")
{
    const std::int64_t n = 1 << 20;
    const Eigen::MatrixXd u = latin_hypercube(n, 1, 3, Place::random, 0, n);
    CHECK(doubled_strata(u)[0] == 0);
    const double edge = (u * static_cast<double>(n))
                            .unaryExpr([](double x) { return std::abs(x - std::round(x)); })
                            .minCoeff();
    CHECK(edge > 1e-10);
    CHECK_THROWS_AS(latin_hypercube(n + 1, 1, 3, Place::random, 0, 1), std::invalid_argument);
}

TEST_CASE("latin: 50 rows grow to 100 on 100 strata, and to 130 with the fewest shared",
          "[uq][latin]")
{
    const auto place = GENERATE(Place::random, Place::centred);
    const std::uint64_t seed = GENERATE(1u, 2u, 3u);
    const Eigen::MatrixXd start = latin_hypercube(50, 5, seed, place, 0, 50);
    const Eigen::MatrixXd twice = grow_latin(start, 100, seed, place);
    CHECK((twice.topRows(50) - start).norm() == 0.0);
    CHECK(filling(twice, 100).least == 1);
    CHECK(filling(twice, 100).most == 1);
    CHECK(doubled_strata(twice) == std::vector<std::int64_t>(5, 0));

    const Eigen::MatrixXd more = grow_latin(twice, 130, seed, place);
    CHECK((more.topRows(100) - twice).norm() == 0.0);
    // 100 rows on 130 strata: those that share one cannot be parted, no new row joins them.
    CHECK(filling(more, 130).most <= 2);
    CHECK(filling(more.bottomRows(30), 130).most == 1);
    for (Eigen::Index j = 0; j < 5; ++j) {
        const std::int64_t shared = doubled_strata(more)[static_cast<std::size_t>(j)];
        Eigen::VectorXi count = Eigen::VectorXi::Zero(130);
        for (Eigen::Index i = 0; i < 100; ++i) ++count[stratum(twice(i, j), 130)];
        CHECK(shared == (count.array() == 2).count());
    }
}

TEST_CASE("latin: growing to a multiple is always Latin", "[uq][latin]")
{
    const int factor = GENERATE(2, 3, 7, 11);
    const Eigen::MatrixXd u = latin(DesignKind::latin_random, {49, 49 * factor}, 20);
    CHECK(filling(u, 49 * factor).most == 1);
    CHECK(filling(u.topRows(49), 49).most == 1);
}

TEST_CASE("latin: growths to different sizes fill their empty strata in orders of their own",
          "[uq][latin]")
{
    // One row on 4 strata and two on 5 leave three empty either way.
    const Eigen::MatrixXd one = Eigen::MatrixXd::Constant(1, 20, 0.01);
    Eigen::MatrixXd two(2, 20);
    two << one, Eigen::MatrixXd::Constant(1, 20, 0.25);
    const auto a = grow_latin(one, 4, 1, Place::centred).bottomRows(3).eval();
    const auto b = grow_latin(two, 5, 1, Place::centred).bottomRows(3).eval();
    int alike = 0;
    for (Eigen::Index j = 0; j < 20; ++j)
        alike += (a(0, j) < a(1, j)) == (b(0, j) < b(1, j)) &&
                 (a(1, j) < a(2, j)) == (b(1, j) < b(2, j)) &&
                 (a(0, j) < a(2, j)) == (b(0, j) < b(2, j));
    CHECK(alike < 12); // 1 in 6 by chance
}

TEST_CASE("latin: of three rows in one stratum two are too many", "[uq][latin]")
{
    const Eigen::Vector4d u(0.1, 0.15, 0.2, 0.9);
    CHECK(doubled_strata(u) == std::vector<std::int64_t>{2});
}

TEST_CASE("latin: what is grown fits, whatever it is", "[uq][latin]")
{
    const Eigen::MatrixXd mc = unit_cube({DesignKind::monte_carlo, {40}, 3, 9});
    const Eigen::MatrixXd g = grow_latin(mc, 200, 9, Place::random);
    CHECK((g.topRows(40) - mc).norm() == 0.0);
    CHECK_THROWS_AS(grow_latin(mc, 40, 9, Place::random), std::invalid_argument);
    CHECK_THROWS_AS(grow_latin(Eigen::MatrixXd::Ones(2, 2), 4, 9, Place::random),
                    std::invalid_argument);
}

TEST_CASE("latin: the mean of a sum of d uniforms has variance d / (12 n^3)", "[uq][latin]")
{
    const int n = 50, d = 5, repeats = 4000;
    double sum = 0.0, squares = 0.0;
    for (int r = 0; r < repeats; ++r) {
        const double m = latin_hypercube(n, d, replicate_seed(4, static_cast<std::uint64_t>(r)),
                                         Place::random, 0, n)
                             .sum() /
                         n;
        sum += m - 0.5 * d;
        squares += (m - 0.5 * d) * (m - 0.5 * d);
    }
    const double exact = d / (12.0 * n * n * n); // sd 1.825741858e-3
    CHECK(std::abs(sum / repeats) < 4.0 * std::sqrt(exact / repeats));
    CHECK(std::abs(squares / repeats / exact - 1.0) < 4.0 * std::sqrt(2.0 / repeats));
}

TEST_CASE("latin: every order of the strata is as likely as the other", "[uq][latin]")
{
    int count[27] = {}; // by the strata of the rows, written to base 3
    const int repeats = 30000;
    for (int r = 0; r < repeats; ++r) {
        const Eigen::MatrixXd u =
            latin_hypercube(3, 1, static_cast<std::uint64_t>(r), Place::centred, 0, 3);
        ++count[9 * stratum(u(0, 0), 3) + 3 * stratum(u(1, 0), 3) + stratum(u(2, 0), 3)];
    }
    double chi2 = 0.0;
    for (const int c : {5, 7, 11, 15, 19, 21}) chi2 += std::pow(count[c] - 5000.0, 2) / 5000.0;
    CHECK(chi2 < 20.5); // 99.9 % of chi-square with 5 degrees of freedom
}
