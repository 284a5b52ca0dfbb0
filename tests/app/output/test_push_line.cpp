#include "app/output/push_line.hpp"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>

using app::PushLine;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

constexpr double kAccuracy = 0.01;
const app::ProgressOptions kPlain{.terminal = false, .quiet = false, .width = 80};
const app::ProgressOptions kTerminal{.terminal = true, .quiet = false, .width = 120};

/// A clock that a test winds, and what is written by it.
struct Written {
    double now = 0.0; // [s]
    std::ostringstream out;
    PushLine line;

    explicit Written(std::vector<std::string> walls, app::ProgressOptions options = kPlain)
        : line(std::move(walls), kAccuracy, out, options, [this] { return now; })
    {
    }
    /// A push from nothing to its end in equal looks.
    void push(dem::PushProgress p, double seconds)
    {
        constexpr int kLooks = 1000;
        const double begin = now;
        for (int i = 1; i <= kLooks; ++i) {
            now = begin + seconds * i / kLooks;
            p.done = double{1} * i / kLooks;
            line.update(p);
        }
    }
    /// The lines so far.
    [[nodiscard]] std::vector<std::string> lines() const
    {
        std::vector<std::string> all;
        std::istringstream in(out.str());
        for (std::string one; std::getline(in, one);) all.push_back(one);
        return all;
    }
};

const dem::PushProgress kFirst{.wall = 0, .displacement = 0.01, .force = 5e4};
const dem::PushProgress kSlower{
    .wall = 0, .displacement = 0.01, .force = 5e4, .slowdowns = 1, .error_before = 0.018};

} // namespace

TEST_CASE("push line: a slower push says that it is one, and why", "[app][push_line]")
{
    Written w({"0.50 MPa"});
    w.push(kFirst, 35.0);
    CHECK_THAT(w.out.str(), !Contains("again"));
    w.push(kSlower, 70.0);
    w.line.finish();
    const std::vector<std::string> lines = w.lines();
    REQUIRE(lines.size() == 12); // 3 of the first push, the reason, 7 of the second, the end
    CHECK(lines[3] == "pushed again, twice as slowly: the error of the peak force was 1.8 %, "
                      "asked for: 1 %");
    CHECK_THAT(lines[2], EndsWith("  50.0 kN at 10.0 mm"));
    CHECK_THAT(lines[4], EndsWith("  push 2: 50.0 kN at 10.0 mm"));
    CHECK_THAT(lines.back(), StartsWith("100 % 1:45 taken"));
}

TEST_CASE("push line: the second push counts as work to do, and its time left is right",
          "[app][push_line]")
{
    Written w({"0.50 MPa"});
    w.push(kFirst, 35.0);
    w.push(kSlower, 70.0);
    const std::vector<std::string> lines = w.lines();
    CHECK_THAT(lines[0], StartsWith(" 28 % at most 0:25 left"));
    CHECK_THAT(lines[4], StartsWith(" 38 % at most 1:05 left")); // at 40 s of 105 s
    CHECK_THAT(lines[10], StartsWith(" 95 % at most 0:05 left"));
}

TEST_CASE("push line: a smaller step and a slow start say why", "[app][push_line]")
{
    Written w({"0.50 MPa"});
    dem::PushProgress p = kFirst;
    w.push(p, 5.0);
    p.slow_starts = 1;
    w.push(p, 5.0);
    p.step_reductions = 1;
    w.push(p, 10.0);
    CHECK_THAT(w.out.str(), Contains("loaded again, slowly: the wall seemed to come down"));
    CHECK_THAT(w.out.str(), Contains("pushed again with half the time step"));
    CHECK_THAT(w.out.str(), Contains("push 3: 50.0 kN"));
}

TEST_CASE("push line: the walls of two threads add up, and a reason names its wall",
          "[app][push_line]")
{
    Written w({"0.50 MPa", "1.00 MPa"});
    for (int i = 1; i <= 100; ++i) {
        w.now = 0.2 * i;
        for (const std::size_t wall : {0, 1}) {
            dem::PushProgress p = kFirst;
            p.wall = wall;
            p.done = 0.01 * i;
            w.line.update(p);
        }
    }
    CHECK_THAT(w.lines().front(), StartsWith(" 49 % at most 0:10 left"));
    w.line.end(0);
    dem::PushProgress slower = kSlower;
    slower.wall = 1;
    w.push(slower, 40.0);
    CHECK_THAT(w.out.str(), Contains("\n1.00 MPa: pushed again, twice as slowly"));
    CHECK_THAT(w.lines().back(), StartsWith("100 % at most 0:00 left"));
}

TEST_CASE("push line: in a terminal the reason stands above the line that is redrawn",
          "[app][push_line]")
{
    Written w({"0.50 MPa"}, kTerminal);
    w.push(kFirst, 5.0);
    w.push(kSlower, 10.0);
    CHECK_THAT(w.out.str(), Contains("\r\033[Kpushed again, twice as slowly: the error of the "
                                     "peak force was 1.8 %, asked for: 1 %\n\r 33 % ["));
}

TEST_CASE("push line: a short run says nothing, even where it began again", "[app][push_line]")
{
    Written w({"0.50 MPa"}, kTerminal);
    w.push(kFirst, 0.5);
    w.push(kSlower, 1.0);
    w.line.finish();
    CHECK(w.out.str().empty());
}
