#include "uq/fields/spatial_sample.hpp"

#include "core/normal.hpp"
#include "tests/uq/field_scenes.hpp"
#include "tests/uq/strata.hpp"
#include "uq/designs/design.hpp"
#include "uq/fields/kernel.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

using namespace uq;
using scenes::doubled_strata;

namespace {

/// The paper's Table 5: multipliers [-], tensile strength [MPa], friction angles [deg].
std::vector<Variable> table_5()
{
    return {{"kn_j", {normal_from_moments(1.0, 0.25)}},
            {"kn_u", {normal_from_moments(1.0, 0.25)}},
            {"ft_u", {lognormal_from_moments(3.7, 0.30)}},
            {"phi_u", {normal_from_moments(35.0, 0.20)}},
            {"phi_j", {normal_from_moments(31.8, 0.20)}}};
}

Eigen::MatrixXd correlated()
{
    Eigen::MatrixXd r = Eigen::MatrixXd::Identity(5, 5);
    r(2, 3) = r(3, 2) = 0.6;
    r(0, 2) = r(2, 0) = -0.4;
    return r;
}

SpatialPlan plan_of(bool dependent, bool latin)
{
    const auto variables = table_5();
    std::vector<SpatialInput> inputs;
    for (const Variable& v : variables) inputs.push_back({v.marginal});
    std::optional<NormalCopula> copula;
    if (dependent) copula = normal_copula(variables, correlated());
    return spatial_plan(inputs, {}, copula, latin);
}

/// Samples x inputs of one value each.
Eigen::MatrixXd sampled(const SpatialPlan& plan, DesignKind kind,
                        const std::vector<std::uint32_t>& sizes, std::uint64_t seed)
{
    Eigen::MatrixXd u = unit_cube({kind, {sizes.begin(), sizes.end()}, plan.n_columns, seed});
    if (plan.reordered) reorder(u, plan.dependence->rho_z, sizes);
    Stream unused(0, 0, Purpose::field);
    Eigen::MatrixXd x(u.rows(), u.cols());
    for (Eigen::Index i = 0; i < u.rows(); ++i) {
        const auto values =
            draw(plan, u.row(i).transpose().unaryExpr(&core::normal_quantile), unused);
        for (Eigen::Index j = 0; j < x.cols(); ++j)
            x(i, j) = values[static_cast<std::size_t>(j)].front();
    }
    return x;
}

double correlation(const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    const Eigen::ArrayXd a = x.array() - x.mean(), b = y.array() - y.mean();
    return (a * b).sum() / std::sqrt(a.square().sum() * b.square().sum());
}

Eigen::MatrixXd in_cube(Eigen::MatrixXd x)
{
    const auto variables = table_5();
    for (Eigen::Index j = 0; j < x.cols(); ++j)
        for (double& v : x.col(j)) v = cdf(variables[static_cast<std::size_t>(j)].marginal, v);
    return x;
}

} // namespace

TEST_CASE("spatial sample: inputs that belong together take one row of their table, chosen by "
          "the first",
          "[uq][spatial_sample]")
{
    SpatialPlan plan = plan_of(false, true);
    plan.together.inputs = {3, 0};
    plan.together.rows = {{10.0, 0.5}, {20.0, 0.1}, {30.0, 0.9}, {30.0, 0.2}};
    const Eigen::MatrixXd x = sampled(plan, DesignKind::latin_random, {8}, 3);
    Eigen::VectorXd count = Eigen::VectorXd::Zero(4);
    for (Eigen::Index i = 0; i < 8; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            count(static_cast<Eigen::Index>(k)) +=
                x(i, 3) == plan.together.rows[k][0] && x(i, 0) == plan.together.rows[k][1];
    CHECK(count == Eigen::VectorXd::Constant(4, 2.0)); // eight strata, four rows
    CHECK(x.col(1) == sampled(plan_of(false, true), DesignKind::latin_random, {8}, 3).col(1));
}

TEST_CASE("spatial sample: means of random Latin samples scatter as what is left inside the "
          "strata",
          "[uq][spatial_sample]")
{
    const auto variables = table_5();
    const SpatialPlan plan = plan_of(false, true);
    const int n = 50, repeats = 1000;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(5);
    for (std::uint64_t seed = 0; seed < repeats; ++seed) {
        const Eigen::MatrixXd x = sampled(plan, DesignKind::latin_random, {n}, seed);
        for (Eigen::Index j = 0; j < 5; ++j)
            squares[j] += std::pow(
                x.col(j).mean() - mean(variables[static_cast<std::size_t>(j)].marginal), 2);
    }
    for (Eigen::Index j = 0; j < 5; ++j) {
        const Marginal m = variables[static_cast<std::size_t>(j)].marginal;
        double variance = 0.0;
        for (int k = 0; k < n; ++k) {
            Marginal slice = m;
            if (k > 0) slice.lower = quantile(m, static_cast<double>(k) / n);
            if (k < n - 1) slice.upper = quantile(m, (k + 1.0) / n);
            variance += std::pow(sd(slice) / n, 2);
        }
        CAPTURE(std::sqrt(variance) / mean(m)); // 0.002 to 0.004; Monte Carlo: 0.03 to 0.04
        CHECK(std::abs(squares[j] / repeats / variance - 1.0) < 4.0 * std::sqrt(2.0 / repeats));
    }
}

TEST_CASE("spatial sample: independent rows carry the correlation asked for",
          "[uq][spatial_sample]")
{
    const auto kind = GENERATE(DesignKind::monte_carlo, DesignKind::sobol);
    const Eigen::MatrixXd x = sampled(plan_of(true, false), kind, {20000}, 3);
    CHECK(std::abs(correlation(x.col(2), x.col(3)) - 0.6) < 4.0 / std::sqrt(20000.0));
    CHECK(std::abs(correlation(x.col(0), x.col(2)) + 0.4) < 4.0 / std::sqrt(20000.0));
    CHECK(std::abs(correlation(x.col(0), x.col(4))) < 4.0 / std::sqrt(20000.0));
}

TEST_CASE("spatial sample: a correlated Latin hypercube is Latin, and grows",
          "[uq][spatial_sample]")
{
    const SpatialPlan plan = plan_of(true, true);
    REQUIRE(plan.reordered);
    const Eigen::MatrixXd start = sampled(plan, DesignKind::latin_random, {500}, 3);
    const Eigen::MatrixXd x = sampled(plan, DesignKind::latin_random, {500, 1000}, 3);
    CHECK((x.topRows(500) - start).norm() == 0.0);
    CHECK(doubled_strata(in_cube(start)) == std::vector<std::int64_t>(5, 0));
    CHECK(doubled_strata(in_cube(x)) == std::vector<std::int64_t>(5, 0));
    Eigen::MatrixXd few = Eigen::MatrixXd::Constant(53, 5, 0.5);
    const std::vector<std::uint32_t> sizes{50, 53};
    CHECK_THROWS_AS(reorder(few, plan.dependence->rho_z, sizes), std::invalid_argument);
}

TEST_CASE(
    "spatial sample: a reordered Latin hypercube has the correlation 2.5 times closer than "
    "chance",
    "[uq][spatial_sample]")
{
    // Seen: 3 to 3.6 times, 18 times for the correlation 0 of two normals.
    const SpatialPlan plan = plan_of(true, true);
    const struct {
        Eigen::Index a, b;
        double rho;
    } pairs[] = {{2, 3, 0.6}, {0, 2, -0.4}, {1, 4, 0.0}};
    const int repeats = 50;
    double squares[3] = {};
    for (std::uint64_t seed = 0; seed < repeats; ++seed) {
        const Eigen::MatrixXd x = sampled(plan, DesignKind::latin_random, {500, 1000}, seed);
        for (int k = 0; k < 3; ++k)
            squares[k] +=
                std::pow(correlation(x.col(pairs[k].a), x.col(pairs[k].b)) - pairs[k].rho, 2) /
                repeats;
    }
    for (int k = 0; k < 3; ++k) {
        const double chance = (1.0 - pairs[k].rho * pairs[k].rho) / std::sqrt(1000.0);
        CHECK(std::sqrt(squares[k]) < chance / 2.5);
    }
}

TEST_CASE("spatial sample: columns are numbered coordinate by coordinate",
          "[uq][spatial_sample]")
{
    const Marginal m{Normal{0.0, 1.0}};
    const SpatialPlan plan =
        spatial_plan({{m, 3}, {m, 1}, {m, 2, OverSites::stratified}, {m, 2}}, {}, {}, false);
    CHECK(plan.n_columns == 6);
    CHECK(plan.columns == std::vector<std::vector<int>>{{0, 3, 5}, {1}, {}, {2, 4}});
}

TEST_CASE("spatial sample: sites have their coordinates, one of each stratum, or the field's "
          "correlation",
          "[uq][spatial_sample]")
{
    const Marginal standard{Normal{0.0, 1.0}};
    const Eigen::VectorXd normal = Eigen::VectorXd::LinSpaced(4, -1.5, 1.5);
    Stream random(3, 17, Purpose::field);
    const auto own = draw(spatial_plan({{standard, 4}}, {}, {}, false), normal, random);
    CHECK(own == std::vector<std::vector<double>>{{-1.5, -0.5, 0.5, 1.5}});

    const SpatialPlan strata =
        spatial_plan({{standard, 40, OverSites::stratified}}, {}, {}, false);
    std::set<int> seen;
    const auto in_strata = draw(strata, {}, random);
    for (const double z : in_strata.front())
        seen.insert(static_cast<int>(std::floor(40.0 * cdf(standard, z))));
    CHECK(seen.size() == 40);

    const auto sites = scenes::grid(2, 2, 0.2, 0.1);
    const FieldBasis basis =
        cholesky_basis(correlation_matrix(Kernel{{Exponential{0.5}}}, sites));
    const SpatialPlan field =
        spatial_plan({{standard, 4, OverSites::field, 0}}, {basis}, {}, false);
    const auto values = draw(field, normal, random).front();
    const Eigen::VectorXd expected = basis.map * normal;
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(values[i] == Approx(expected[static_cast<Eigen::Index>(i)]).epsilon(1e-14));
}

TEST_CASE("spatial sample: dependence joins coordinate by coordinate, over sites too",
          "[uq][spatial_sample]")
{
    const std::vector<Variable> two{{"x", {Normal{0.0, 1.0}}}, {"y", {Normal{0.0, 1.0}}}};
    const Eigen::MatrixXd rho = (Eigen::MatrixXd(2, 2) << 1.0, 0.6, 0.6, 1.0).finished();
    const SpatialPlan plan = spatial_plan({{two[0].marginal, 2}, {two[1].marginal, 2}}, {},
                                          normal_copula(two, rho), true);
    CHECK_FALSE(plan.reordered);
    Stream unused(0, 0, Purpose::field);
    const auto v = draw(plan, Eigen::Vector4d(1.0, 0.0, -2.0, 1.0), unused); // x1 y1 x2 y2
    CHECK(v[0] == std::vector<double>{1.0, -2.0});
    CHECK(v[1][0] == Approx(0.6).epsilon(1e-13));
    CHECK(v[1][1] == Approx(0.6 * -2.0 + 0.8).epsilon(1e-13));
}
