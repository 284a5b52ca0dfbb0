#include "uq/reliability/limit_state/kept_evaluations.hpp"

#include "tests/scenes/temporary_folder.hpp"
#include "uq/reliability/limit_state/evaluate.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace {

/// Not a std::exception, which would be a failed sample.
struct Interrupted {};

} // namespace

TEST_CASE("kept evaluations: an interrupted analysis continues with those that it has made",
          "[uq][kept_evaluations]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "unfinished.jsonl";
    std::size_t asked = 0, stop_at = 100;
    const uq::BlackBox model = [&](const uq::Samples& s) {
        if (asked >= stop_at) throw Interrupted();
        asked += s.id.size();
        uq::Responses r{Eigen::MatrixXd(s.x.rows(), 2), std::vector<std::string>(s.id.size())};
        for (Eigen::Index i = 0; i < s.x.rows(); ++i) {
            r.y.row(i) << 0.0, std::sqrt(s.x(i, 0)); // not a number below zero: failed
        }
        return r;
    };
    uq::Samples samples{Eigen::VectorXd::LinSpaced(200, -0.3, 2.1), {}};
    for (std::uint64_t i = 0; i < 200; ++i) samples.id.push_back(i);
    const uq::Responses whole = uq::evaluate(
        [&](const uq::Samples& s) {
            stop_at = 1000;
            return model(s);
        },
        samples, 2);
    asked = 0;
    stop_at = 100;
    {
        uq::KeptEvaluations kept(file, "model 1");
        CHECK_THROWS_AS(kept.around(model, 1)(samples), Interrupted);
        CHECK(kept.found() == 0);
    }
    const std::size_t made = asked;
    CHECK(made >= 100);
    std::ofstream(file, std::ios::app) << R"({"x":[1.0],"y":)"; // cut off by a kill
    stop_at = 1000;
    uq::KeptEvaluations kept(file, "model 1");
    CHECK(kept.found() == made);
    const uq::Responses r = kept.around(model, 1)(samples);
    CHECK(asked == 200);
    REQUIRE(r.y.cols() == 1);
    for (Eigen::Index i = 0; i < 200; ++i) {
        const auto at = static_cast<std::size_t>(i);
        CHECK(r.failure[at] == whole.failure[at]);
        if (r.failure[at].empty()) CHECK(r.y(i, 0) == whole.y(i, 1));
    }
    CHECK_THROWS_WITH(uq::KeptEvaluations(file, "model 2"),
                      Catch::Contains("unfinished.jsonl") &&
                          Catch::Contains("of another model"));
    try {
        const uq::KeptEvaluations other(file, "model 2");
    } catch (const uq::KeptEvaluations::OtherModel& kept_model) {
        CHECK(kept_model.model == "model 1");
    }
    kept.remove();
    CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("kept evaluations: a file that is damaged is refused", "[uq][kept_evaluations]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "unfinished.jsonl";
    {
        const uq::KeptEvaluations made(file, "model");
    }
    std::ofstream(file, std::ios::app) << "{\"x\":[1.0]}\n";
    CHECK_THROWS_WITH(uq::KeptEvaluations(file, "model"), Catch::Contains("is damaged"));
}
