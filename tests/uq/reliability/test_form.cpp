#include "uq/reliability/design_point/form.hpp"

#include "tests/uq/reliability/reliability_problems.hpp"

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <vector>

using namespace uq;
using Eigen::VectorXd;
using std::numbers::sqrt2;

namespace {

FormOptions starts(int n)
{
    FormOptions o;
    o.starts = n;
    return o;
}

} // namespace

TEST_CASE("form: two searches agree on the published reliability index", "[uq][form]")
{
    for (const problems::Problem& p : problems::all()) {
        INFO(p.name);
        const SearchMethod second = GENERATE(SearchMethod::slsqp, SearchMethod::cobyla);
        FormOptions o = starts(11);
        o.check = second;
        const FormResult r = form(p.limit, o);
        CHECK(r.outcome == FormOutcome::agreed);
        CHECK(r.reason.empty());
        REQUIRE_FALSE(r.points.empty());
        CHECK(r.points[0].beta == Approx(p.beta).margin(1e-6));
    }
}

TEST_CASE("form: linear limit states are exact", "[uq][form]")
{
    const auto exact = [](const problems::Problem& p) {
        CHECK(probability(form(p.limit, starts(1)).points.at(0)) ==
              Approx(p.exact).epsilon(1e-9));
    };
    exact(problems::difference_4_2());
    exact(problems::difference_7_2());
}

TEST_CASE("form: levels of the log ratio of the Dakota manual", "[uq][form]")
{
    struct Level {
        double z, probability, beta;
    };
    for (const Level& l : {Level{0.4, 4.7624085962e-02, 1.6683404020},
                           Level{0.5, 1.0346525475e-01, 1.2620507942},
                           Level{1.5, 7.6981945355e-01, 0.0}, // the index is not printed
                           Level{1.75, 8.4588021938e-01, -1.0189229206}}) {
        INFO("z = " << l.z);
        FormOptions o = starts(1);
        o.search.step = 1e-4;
        const FormResult r = form(problems::log_ratio(l.z).limit, o);
        REQUIRE(r.outcome == FormOutcome::agreed);
        CHECK(probability(r.points[0]) == Approx(l.probability).epsilon(5e-11 / l.probability));
        if (l.beta != 0.0) CHECK(r.points[0].beta == Approx(l.beta).epsilon(0.0).margin(6e-11));
    }
}

TEST_CASE("form: published first-order probabilities of Dakota", "[uq][form]")
{
    CHECK(probability(form(problems::portal_frame().limit).points.at(0)) ==
          Approx(9.4330621958e-3).epsilon(1e-9));
    CHECK(probability(form(problems::steel_section().limit).points.at(0)) ==
          Approx(1.2969918890e-7).epsilon(1e-9));
}

TEST_CASE("form: all four branches are found and listed, nearest first", "[uq][form]")
{
    const FormResult r = form(problems::four_branch().limit, starts(21));
    REQUIRE(r.points.size() == 4);
    CHECK(r.points[0].beta == Approx(3.0).margin(1e-6));
    CHECK(r.points[1].beta == Approx(3.0).margin(1e-6));
    CHECK(r.points[2].beta == Approx(3.5).margin(1e-6));
    CHECK(r.points[3].beta == Approx(3.5).margin(1e-6));
}

TEST_CASE("form: the origin between two branches is flat, which is said and no answer",
          "[uq][form]")
{
    const FormResult r = form(problems::four_branch().limit, starts(1));
    CHECK(r.outcome == FormOutcome::none);
    CHECK(r.points.empty());
    CHECK(r.searches[0].outcome == SearchOutcome::flat);
    CHECK(r.reason.find("gradient is zero") != std::string::npos);
}

TEST_CASE("form: importance factors of R - S are the shares of variance", "[uq][form]")
{
    const LimitState s = problems::limit_state(
        2, [](const VectorXd& x) { return 5.0 + 3.0 * x(0) - 4.0 * x(1); });
    const DesignPoint p = form(s).points.at(0);
    CHECK(p.beta == Approx(1.0).epsilon(1e-10));
    CHECK(importance_factors(p)(0) == Approx(0.36).epsilon(1e-10));
    CHECK(importance_factors(p)(1) == Approx(0.64).epsilon(1e-10));
    CHECK(p.alpha(0) == Approx(-0.6).epsilon(1e-10));
}

TEST_CASE("form: a limit state that is never reached is no answer, with the reason",
          "[uq][form]")
{
    const auto never = GENERATE(0, 1);
    const LimitState s = problems::limit_state(2, [=](const VectorXd& x) {
        return never == 0 ? 1.0 + x.squaredNorm() : 1.0 + std::exp(-x(0));
    });
    const FormResult r = form(s);
    CHECK(r.outcome == FormOutcome::none);
    CHECK(r.points.empty());
    CHECK(r.reason.find("improved HL-RF: ") != std::string::npos);
    CHECK(r.reason.find("SLSQP: ") != std::string::npos);
    for (const Search& search : r.searches) {
        CHECK_FALSE(search.point);
        CHECK(search.outcome != SearchOutcome::converged);
        CHECK_FALSE(search.reason.empty());
    }
}

TEST_CASE("form: a failed evaluation ends a search, not the analysis", "[uq][form]")
{
    const auto beyond = [](double limit) {
        return problems::failing(problems::rp22().limit,
                                 [=](const VectorXd& x) { return x.sum() > limit; });
    };
    const FormResult r = form(beyond(2.0));
    CHECK(r.outcome == FormOutcome::none);
    CHECK(r.reason.find("failed") != std::string::npos);
    CHECK_FALSE(r.ledger.failed.empty());
    CHECK(form(beyond(5.0)).points.at(0).beta == Approx(2.5).margin(1e-6));
}

TEST_CASE("form: a rough limit state needs wide differences, and without them has no answer",
          "[uq][form]")
{
    const LimitState s = problems::limit_state(2, [](const VectorXd& x) {
        return 3.0 - x.sum() / sqrt2 + 1e-3 * std::sin(1e4 * x(0)) * std::cos(7e3 * x(1));
    });
    CHECK(form(s).outcome == FormOutcome::none);
    FormOptions wide;
    wide.search = {.step = 0.3, .on_surface = 1e-2, .on_axis = 5e-2, .max_iterations = 100};
    wide.check = GENERATE(SearchMethod::slsqp, SearchMethod::cobyla);
    wide.same_point = 0.1;
    const FormResult r = form(s, wide);
    CHECK(r.outcome == FormOutcome::agreed);
    REQUIRE_FALSE(r.points.empty());
    CHECK(r.points[0].beta == Approx(3.0).margin(2e-3));
}

TEST_CASE("form: counts every evaluation, 2 d + 1 to a gradient", "[uq][form]")
{
    std::size_t asked = 0;
    LimitState s = problems::rp8().limit;
    const BlackBox inner = s.model;
    s.model = [&](const Samples& batch) {
        asked += batch.id.size();
        return inner(batch);
    };
    const FormResult r = form(s, starts(1));
    CHECK(r.ledger.evaluations == asked);
    CHECK(r.searches[0].evaluations + r.searches[1].evaluations == asked);
    CHECK(r.searches[0].evaluations ==
          13u * static_cast<std::size_t>(r.searches[0].iterations));
    CHECK(asked < 240); // 234; 273 with the points that both searches want
}

TEST_CASE("form: no point is asked for twice", "[uq][form]")
{
    std::size_t asked = 0;
    std::set<std::vector<double>> points;
    LimitState s;
    s.dimension = 2;
    s.model = [&](const Samples& batch) {
        asked += batch.id.size();
        Responses r{Eigen::MatrixXd(batch.x.rows(), 1),
                    std::vector<std::string>(batch.id.size())};
        for (Eigen::Index i = 0; i < batch.x.rows(); ++i) {
            const double x = batch.x(i, 0), y = batch.x(i, 1);
            points.insert({x, y});
            r.y(i, 0) = 3.0 + 0.1 * x * x - x - y;
        }
        return r;
    };
    const FormResult r = form(s);
    CHECK(r.outcome == FormOutcome::agreed);
    CHECK(points.size() == asked);
    CHECK(r.ledger.evaluations == asked);
}

TEST_CASE("form: a point on the limit state that is not nearest to the origin is refused",
          "[uq][form]")
{
    Search search;
    judge({Eigen::Vector2d(3.0, 1.0), 0.0, Eigen::Vector2d(-1.0, 0.0)}, {}, search);
    CHECK(search.outcome == SearchOutcome::off_axis);
    CHECK_FALSE(search.point);
    CHECK(search.reason.find("1 off the axis") != std::string::npos);
}

TEST_CASE("form: ends at the number of evaluations allowed, with what it has found",
          "[uq][form]")
{
    const LimitState s = problems::rp8().limit;
    const std::size_t all = form(s).ledger.evaluations;
    for (const std::size_t allowed : {std::size_t{20}, all / 2, all - 1}) {
        FormOptions o;
        o.max_evaluations = allowed;
        const FormResult r = form(s, o);
        CHECK(r.ledger.evaluations <= allowed);
        CHECK(r.ledger.failed.empty());
        const std::size_t left = allowed - r.ledger.evaluations;
        CHECK_THAT(r.reason,
                   Catch::StartsWith(
                       "the searches did not end within " + std::to_string(allowed) +
                       " evaluations: " +
                       (left == 0 ? "all were made"
                                  : std::to_string(r.ledger.evaluations) +
                                        " were made, and the next step needs more than the " +
                                        std::to_string(left) + " left")));
        for (const Search& search : r.searches)
            CHECK(search.reason.find("the model failed") == std::string::npos);
    }
}

TEST_CASE("form: options out of range are refused", "[uq][form]")
{
    const LimitState s = problems::rp22().limit;
    FormOptions o;
    o.starts = 0;
    CHECK_THROWS_AS(form(s, o), std::invalid_argument);
    o = {};
    o.check = SearchMethod::improved_hl_rf;
    CHECK_THROWS_AS(form(s, o), std::invalid_argument);
    o = {};
    o.search.step = 0.0;
    CHECK_THROWS_AS(form(s, o), std::invalid_argument);
    o = {};
    o.search.on_surface = -1.0;
    CHECK_THROWS_AS(form(s, o), std::invalid_argument);
    o = {};
    o.start_radius = 0.0;
    CHECK_THROWS_AS(form(s, o), std::invalid_argument);
}

namespace {

/// Normal variables with these standard deviations and this correlation.
Map correlated(const VectorXd& sd, const Eigen::MatrixXd& r)
{
    const Eigen::MatrixXd factor = sd.asDiagonal() * Eigen::MatrixXd(r.llt().matrixL());
    return [factor](const Eigen::MatrixXd& u) -> Eigen::MatrixXd {
        return u * factor.transpose();
    };
}

DesignPoint point_of(const VectorXd& a, const Map& map)
{
    const LimitState s = problems::limit_state(
        a.size(), [a](const VectorXd& x) { return 3.0 + a.dot(x); }, map);
    return form(s, starts(1)).points.at(0);
}

} // namespace

TEST_CASE("form: importance of correlated inputs is (a sd)^2 whatever their order",
          "[uq][form]")
{
    // g = 3 + a x: gamma_i is proportional to a_i sd_i, alpha to nothing that belongs to one
    // input
    const VectorXd a{{1.0, 2.0, -1.0}}, sd{{1.0, 2.0, 3.0}};
    const Eigen::MatrixXd r{{1.0, 0.5, -0.3}, {0.5, 1.0, 0.2}, {-0.3, 0.2, 1.0}};
    const VectorXd share{{1.0 / 26.0, 16.0 / 26.0, 9.0 / 26.0}};
    const Map map = correlated(sd, r);
    const auto gamma = dependent_importance(point_of(a, map), map);
    REQUIRE(gamma);
    for (Eigen::Index i = 0; i < 3; ++i) CHECK((*gamma)(i) == Approx(share(i)).margin(1e-6));
    const std::vector<Eigen::Index> turned{2, 0, 1};
    const Map other = correlated(sd(turned), r(turned, turned));
    const auto again = dependent_importance(point_of(a(turned), other), other);
    REQUIRE(again);
    for (Eigen::Index i = 0; i < 3; ++i)
        CHECK((*again)(i) == Approx(share(turned[static_cast<std::size_t>(i)])).margin(1e-6));
}

TEST_CASE("form: of the correlated log ratio of the Dakota manual both inputs have one half",
          "[uq][form]")
{
    const problems::Problem p = problems::log_ratio(0.4);
    const DesignPoint point = form(p.limit, starts(1)).points.at(0);
    const auto gamma = dependent_importance(point, p.limit.to_physical);
    REQUIRE(gamma);
    CHECK((*gamma)(0) == Approx(0.5).margin(1e-5));
    CHECK((*gamma)(1) == Approx(0.5).margin(1e-5));
    CHECK(std::abs(importance_factors(point)(0) - 0.5) > 0.05); // of the coordinates: not so
}

TEST_CASE(
    "form: inputs with coordinates of their own, or with fewer than inputs, have no gamma",
    "[uq][form]")
{
    const problems::Problem p = problems::difference_4_2();
    const DesignPoint point = form(p.limit, starts(1)).points.at(0);
    CHECK_FALSE(dependent_importance(point, p.limit.to_physical));
    CHECK_FALSE(dependent_importance(point, {}));
    const Map one = [](const Eigen::MatrixXd& u) -> Eigen::MatrixXd {
        return u.col(0).replicate(1, 2); // two inputs that are the same
    };
    CHECK_FALSE(dependent_importance(point, one));
}
