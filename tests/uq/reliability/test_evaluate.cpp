#include "uq/reliability/limit_state/evaluate.hpp"

#include "tests/uq/reliability/reliability_problems.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using problems::by_rows;
using problems::count_failed;

namespace {

Samples samples(Eigen::Index n)
{
    Samples s{MatrixXd(n, 2), {}};
    for (Eigen::Index i = 0; i < n; ++i) {
        s.x.row(i) << static_cast<double>(i), 1.0;
        s.id.push_back(static_cast<std::uint64_t>(100 + i));
    }
    return s;
}

/// The sum; sample 3 throws, sample 5 is not a number, sample 6 infinite.
double sum(const VectorXd& x)
{
    if (x(0) == 3.0) throw std::runtime_error("no equilibrium");
    if (x(0) == 5.0) return std::nan("");
    if (x(0) == 6.0) return std::numeric_limits<double>::infinity();
    return x.sum();
}

void check_eight(const Responses& r)
{
    REQUIRE(r.y.rows() == 8);
    REQUIRE(r.failure.size() == 8);
    for (const Eigen::Index i : {0, 1, 2, 4, 7}) {
        CHECK(r.y(i, 0) == static_cast<double>(i) + 1.0);
        CHECK(r.failure[static_cast<std::size_t>(i)].empty());
    }
    for (const Eigen::Index i : {3, 5, 6}) CHECK(std::isnan(r.y(i, 0)));
    CHECK(r.failure[3] == "exception: no equilibrium");
    CHECK(r.failure[5] == "response 0 is not a number");
    CHECK(r.failure[6] == "response 0 is infinite");
    CHECK(count_failed(r) == 3);
}

} // namespace

TEST_CASE("evaluate: a batch that throws is asked sample by sample", "[uq][evaluate]")
{
    int calls = 0;
    const BlackBox batch = [&, inner = by_rows(sum)](const Samples& s) {
        ++calls;
        return inner(s);
    };
    check_eight(evaluate(batch, samples(8)));
    CHECK(calls == 9);
}

TEST_CASE("evaluate: an answer of the wrong shape is a failure that names both shapes",
          "[uq][evaluate]")
{
    const BlackBox short_answer = [](const Samples&) { return Responses{MatrixXd(0, 1), {}}; };
    const Responses r = evaluate(short_answer, samples(2));
    CHECK(count_failed(r) == 2);
    CHECK(r.failure[0].find("1 samples with 0 rows") != std::string::npos);
    CHECK(evaluate(by_rows(sum), samples(2), 2).failure[0].find("2 columns are needed") !=
          std::string::npos);
}

TEST_CASE("evaluate: values of a row that the model itself calls failed are not handed on",
          "[uq][evaluate]")
{
    const BlackBox own = [](const Samples& s) {
        return Responses{MatrixXd::Ones(s.x.rows(), 2), {"too dynamic", ""}};
    };
    const Responses r = evaluate(own, samples(2));
    CHECK(r.y.row(0).hasNaN());
    CHECK(r.y(1, 1) == 1.0);
    CHECK(r.failure[0] == "too dynamic");
}

TEST_CASE("evaluate: what cannot be asked is refused", "[uq][evaluate]")
{
    CHECK_THROWS_AS(evaluate({}, samples(1)), std::invalid_argument);
    CHECK_THROWS_AS(evaluate(by_rows(sum), Samples{MatrixXd(2, 1), {1}}),
                    std::invalid_argument);
    CHECK(evaluate(by_rows(sum), samples(0)).y.rows() == 0);
}
