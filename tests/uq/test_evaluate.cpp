#include "uq/reliability/evaluate.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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
VectorXd sum(const VectorXd& x)
{
    if (x(0) == 3.0) throw std::runtime_error("no equilibrium");
    if (x(0) == 5.0) return VectorXd::Constant(1, std::nan(""));
    if (x(0) == 6.0) return VectorXd::Constant(1, std::numeric_limits<double>::infinity());
    return VectorXd::Constant(1, x.sum());
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

TEST_CASE("evaluate: a sample that throws or is not finite fails alone, with its reason",
          "[uq][evaluate]")
{
    check_eight(by_rows(sum, 1)(samples(8)));
}

TEST_CASE("evaluate: a batch that throws is asked sample by sample", "[uq][evaluate]")
{
    int calls = 0;
    const Model batch = [&](const Samples& s) {
        ++calls;
        Responses r{MatrixXd(s.x.rows(), 1), std::vector<std::string>(s.id.size())};
        for (Eigen::Index i = 0; i < s.x.rows(); ++i) r.y.row(i) = sum(s.x.row(i)).transpose();
        return r;
    };
    check_eight(evaluate(batch, samples(8)));
    CHECK(calls == 9);
}

TEST_CASE("evaluate: batches of any size give the same answers, none larger than asked",
          "[uq][evaluate]")
{
    const Eigen::Index size = GENERATE(1, 3, 8, 100);
    Eigen::Index largest = 0;
    std::vector<std::uint64_t> seen;
    const Model inner = by_rows(sum, 1);
    const Model watched = [&](const Samples& s) {
        largest = std::max(largest, s.x.rows());
        seen.insert(seen.end(), s.id.begin(), s.id.end());
        return inner(s);
    };
    check_eight(in_batches(watched, size)(samples(8)));
    CHECK(largest == std::min<Eigen::Index>(size, 8));
    CHECK(seen == samples(8).id);
}

TEST_CASE("evaluate: an answer of the wrong shape is a failure that names both shapes",
          "[uq][evaluate]")
{
    const Model short_answer = [](const Samples&) { return Responses{MatrixXd(0, 1), {}}; };
    const Responses r = evaluate(short_answer, samples(2));
    CHECK(count_failed(r) == 2);
    CHECK(r.failure[0].find("1 samples with 0 rows") != std::string::npos);
    CHECK(evaluate(by_rows(sum, 1), samples(2), 2).failure[0].find("2 columns are needed") !=
          std::string::npos);
    const auto two = [](const VectorXd&) { return VectorXd::Zero(2); };
    CHECK(by_rows(two, 1)(samples(1)).failure[0] == "the model gives 2 values instead of 1");
}

TEST_CASE("evaluate: values of a row that the model itself calls failed are not handed on",
          "[uq][evaluate]")
{
    const Model own = [](const Samples& s) {
        return Responses{MatrixXd::Ones(s.x.rows(), 2), {"too dynamic", ""}};
    };
    const Responses r = evaluate(own, samples(2));
    CHECK(r.y.row(0).hasNaN());
    CHECK(r.y(1, 1) == 1.0);
    CHECK(r.failure[0] == "too dynamic");
}

TEST_CASE("evaluate: what cannot be asked is refused", "[uq][evaluate]")
{
    CHECK_THROWS_AS(by_rows({}, 1), std::invalid_argument);
    CHECK_THROWS_AS(by_rows(sum, 0), std::invalid_argument);
    CHECK_THROWS_AS(in_batches({}, 1), std::invalid_argument);
    CHECK_THROWS_AS(in_batches(by_rows(sum, 1), 0), std::invalid_argument);
    CHECK_THROWS_AS(evaluate({}, samples(1)), std::invalid_argument);
    CHECK_THROWS_AS(evaluate(by_rows(sum, 1), Samples{MatrixXd(2, 1), {1}}),
                    std::invalid_argument);
    CHECK(evaluate(by_rows(sum, 1), samples(0)).y.rows() == 0);
}
