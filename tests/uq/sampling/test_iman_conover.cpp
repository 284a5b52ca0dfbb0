#include "uq/designs/iman_conover.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace uq;

namespace {

// S. J. Mildenhall, "The Report of the Research Working Party on Correlations and Dependencies
// Among All Risk Sources, Part 1: Correlation and Aggregate Loss Distributions", CAS Forum,
// Winter 2006: the worked example, X, scores M, target S, reordered X.
// clang-format off
Eigen::MatrixXd example_x()
{
    Eigen::MatrixXd x(20, 4);
    x <<
        123567, 44770, 15934, 13273,
        126109, 45191, 16839, 15406,
        138713, 47453, 17233, 16706,
        139016, 47941, 17265, 16891,
        152213, 49345, 17620, 18821,
        153224, 49420, 17859, 19569,
        153407, 50686, 20804, 20166,
        155716, 52931, 21110, 20796,
        155780, 54010, 22728, 20968,
        161678, 57346, 24072, 21178,
        161805, 57685, 25198, 23236,
        167447, 57698, 25393, 23375,
        170737, 58380, 30357, 24019,
        171592, 60948, 30779, 24785,
        178881, 66972, 32634, 25000,
        181678, 68053, 33117, 26754,
        184381, 70592, 35248, 27079,
        206940, 72243, 36656, 30136,
        217092, 86685, 38483, 30757,
        240935, 87138, 39483, 35108;
    return x;
}

Eigen::MatrixXd example_scores()
{
    Eigen::MatrixXd m(20, 4);
    m <<
        -1.92062, 1.22896, -1.00860, -0.49584,
        -1.50709, -1.50709, -1.50709, 0.82015,
        -1.22896, 1.92062, 0.82015, -0.65151,
        -1.00860, -0.20723, 1.00860, -1.00860,
        -0.82015, 0.82015, 0.34878, 1.92062,
        -0.65151, -1.22896, -0.65151, 0.20723,
        -0.49584, -0.65151, 1.22896, -0.34878,
        -0.34878, -0.49584, -0.49584, -0.06874,
        -0.20723, -1.00860, 0.20723, 0.65151,
        -0.06874, 0.49584, 0.06874, -1.22896,
        0.06874, -0.34878, -1.22896, 0.49584,
        0.20723, 0.34878, 0.65151, 0.34878,
        0.34878, -0.06874, -0.20723, 1.22896,
        0.49584, -1.92062, -0.82015, -0.20723,
        0.65151, 0.20723, 1.92062, -1.92062,
        0.82015, 1.00860, 1.50709, 1.50709,
        1.00860, -0.82015, -1.92062, 1.00860,
        1.22896, 1.50709, 0.49584, -1.50709,
        1.50709, 0.06874, -0.06874, 0.06874,
        1.92062, 0.65151, -0.34878, -0.82015;
    return m;
}

Eigen::MatrixXd example_result()
{
    Eigen::MatrixXd y(20, 4);
    y <<
        123567, 50686, 15934, 16706,
        126109, 44770, 16839, 25000,
        138713, 57685, 17620, 19569,
        139016, 47453, 35248, 20166,
        152213, 57346, 20804, 30757,
        153224, 45191, 21110, 24019,
        153407, 47941, 38483, 23375,
        155716, 52931, 17859, 20796,
        155780, 49420, 33117, 27079,
        161678, 58380, 22728, 15406,
        161805, 54010, 17265, 23236,
        167447, 66972, 32634, 24785,
        170737, 57698, 24072, 30136,
        171592, 49345, 30357, 20968,
        178881, 68053, 39483, 16891,
        181678, 72243, 36656, 35108,
        184381, 60948, 17233, 26754,
        206940, 86685, 25393, 13273,
        217092, 70592, 30779, 21178,
        240935, 87138, 25198, 18821;
    return y;
}

Eigen::MatrixXd example_target()
{
    Eigen::MatrixXd s(4, 4);
    s << 1.0, 0.8, 0.4, 0.0,
         0.8, 1.0, 0.3, -0.2,
         0.4, 0.3, 1.0, 0.1,
         0.0, -0.2, 0.1, 1.0;
    return s;
}
// clang-format on

Eigen::MatrixXd correlation(Eigen::MatrixXd x)
{
    x.rowwise() -= x.colwise().mean().eval();
    const Eigen::VectorXd norm = x.colwise().norm();
    return (x.transpose() * x).cwiseQuotient(norm * norm.transpose());
}

Eigen::MatrixXd ranks(const Eigen::MatrixXd& x)
{
    Eigen::MatrixXd r(x.rows(), x.cols());
    for (Eigen::Index j = 0; j < x.cols(); ++j)
        for (Eigen::Index i = 0; i < x.rows(); ++i)
            r(i, j) = static_cast<double>((x.col(j).array() < x(i, j)).count());
    return r;
}

} // namespace

TEST_CASE("iman_conover: the worked example of Mildenhall comes out as printed",
          "[uq][iman_conover]")
{
    const Eigen::MatrixXd y = reordered(example_x(), example_target(), example_scores());
    CHECK((y - example_result()).cwiseAbs().maxCoeff() == 0.0);
    const Eigen::MatrixXd r = correlation(y), s = correlation(ranks(y));
    const double pearson[] = {0.8497, 0.2641, -0.1136, 0.1885, -0.1998, 0.0957};
    const double spearman[] = {0.7865, 0.388, -0.0346, 0.2271, -0.1789, 0.0391};
    int k = 0;
    for (Eigen::Index i = 0; i < 4; ++i)
        for (Eigen::Index j = i + 1; j < 4; ++j, ++k) {
            CHECK(std::abs(r(i, j) - pearson[k]) <= 0.5e-4);
            CHECK(std::abs(s(i, j) - spearman[k]) <= 0.5e-4);
        }
}

TEST_CASE("iman_conover: columns keep their values, the first with its scores keeps its order",
          "[uq][iman_conover]")
{
    const Eigen::MatrixXd x = example_x();
    Eigen::MatrixXd y = reordered(x, example_target(), normal_scores(example_result()));
    CHECK((ranks(y).col(0) - ranks(example_result()).col(0)).norm() == 0.0);
    for (Eigen::Index j = 0; j < 4; ++j) {
        std::sort(y.col(j).begin(), y.col(j).end());
        CHECK((y.col(j) - x.col(j)).norm() == 0.0);
    }
}

TEST_CASE(
    "iman_conover: scores are quantiles of rank / (n + 1), equal values in the order of rows",
    "[uq][iman_conover]")
{
    const Eigen::MatrixXd s = normal_scores(Eigen::Vector3d(5.0, -1.0, 5.0));
    CHECK(s(0, 0) == 0.0);
    CHECK(s(1, 0) == Approx(-0.6744897501960817).epsilon(1e-15));
    CHECK(s(2, 0) == Approx(0.6744897501960817).epsilon(1e-15));
    const Eigen::VectorXd equal = normal_scores(Eigen::MatrixXd::Ones(100, 1));
    for (Eigen::Index i = 1; i < 100; ++i) CHECK(equal[i - 1] < equal[i]);
}

TEST_CASE("iman_conover: too few rows, or columns in one order, are refused",
          "[uq][iman_conover]")
{
    const Eigen::MatrixXd x = example_x();
    CHECK_THROWS_WITH(reordered(x.topRows(4), example_target(), example_scores().topRows(4)),
                      Catch::Contains("more rows than variables"));
    CHECK_THROWS_AS(reordered(x, example_target(), normal_scores(x)), std::invalid_argument);
}
