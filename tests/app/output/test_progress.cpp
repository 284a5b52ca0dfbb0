#include "app/output/progress.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

using app::clock_text;
using app::Progress;
using app::ProgressOptions;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

/// A run of `seconds` at an even pace, reported every `every` seconds; the text written.
std::string run(ProgressOptions options, double seconds, double every, bool finish = true)
{
    std::ostringstream out;
    double now = 100.0; // [s] clocks do not start at 0
    Progress progress(out, options, [&] { return now; });
    const int reports = static_cast<int>(seconds / every + 0.5);
    for (int i = 0; i <= reports; ++i) {
        now = 100.0 + i * every;
        progress.update(i * every / seconds, "49.7 kN at 9.8 mm");
    }
    if (finish) progress.finish("49.7 kN at 30.0 mm");
    return out.str();
}

auto count(const std::string& text, char c) { return std::count(text.begin(), text.end(), c); }

const ProgressOptions kTerminal{.terminal = true, .quiet = false, .width = 80};
const ProgressOptions kPlain{.terminal = false, .quiet = false, .width = 80};

} // namespace

TEST_CASE("progress: a run of less than two seconds says nothing", "[app][progress]")
{
    CHECK(run(kTerminal, 1.9, 0.1).empty());
    CHECK(run(kPlain, 1.9, 0.1).empty());
}

TEST_CASE("progress: quiet says nothing", "[app][progress]")
{
    CHECK(run({.terminal = true, .quiet = true, .width = 80}, 60.0, 1.0).empty());
}

TEST_CASE("progress: a terminal line is redrawn at most ten times a second", "[app][progress]")
{
    const std::string text = run(kTerminal, 12.0, 0.001);
    CHECK(count(text, '\r') <= 102); // 10 s after the silence, first and last included
    CHECK(count(text, '\r') >= 90);
}

TEST_CASE("progress: a terminal shows one line, ended once", "[app][progress]")
{
    const std::string text = run(kTerminal, 30.0, 0.25);
    CHECK(count(text, '\n') == 1);
    CHECK_THAT(text, EndsWith("30.0 mm\033[K\n"));
    CHECK_THAT(text, Contains(" 50 % [============>           ] 0:15 left  49.7 kN at 9.8 mm"));
    CHECK_THAT(text,
               Contains("100 % [========================] 0:30 taken  49.7 kN at 30.0 mm"));
}

TEST_CASE("progress: a line that was drawn is ended when the run breaks off", "[app][progress]")
{
    std::ostringstream out;
    {
        double now = 0.0;
        Progress progress(out, kTerminal, [&] { return now; });
        now = 5.0;
        progress.update(0.5, "");
        CHECK(count(out.str(), '\n') == 0);
    }
    CHECK(count(out.str(), '\n') == 1);
}

TEST_CASE("progress: what was done before the run took it no time", "[app][progress]")
{
    std::ostringstream out;
    double now = 0.0;
    Progress progress(
        out, kPlain, [&] { return now; }, 0.8);
    for (; now < 10.5; now += 0.5) progress.update(0.8 + 0.005 * now, "");
    CHECK_THAT(out.str(), StartsWith(" 85 % 0:30 left"));
}

TEST_CASE("progress: without a terminal there is a line every 10 s and one at the end",
          "[app][progress]")
{
    const std::string text = run(kPlain, 35.0, 0.05);
    CHECK(count(text, '\n') == 4);
    CHECK(count(text, '\r') == 0);
    CHECK(count(text, '\033') == 0);
}

TEST_CASE("progress: no line is wider than the terminal", "[app][progress]")
{
    const std::string text =
        run({.terminal = true, .quiet = false, .width = 40}, 10.0, 0.25, false);
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line, '\r');
    int seen = 0;
    while (std::getline(lines, line, '\r')) {
        CHECK(line.find("\033[K") <= 39);
        ++seen;
    }
    CHECK(seen > 30);
}

TEST_CASE("progress: the time left follows a change of pace", "[app][progress]")
{
    std::ostringstream out;
    double now = 0.0, done = 0.0;
    Progress progress(out, kTerminal, [&] { return now; });
    for (; now < 30.0; now += 0.1) progress.update(done += 0.001, "");   // 100 s for all
    for (; now < 130.0; now += 0.1) progress.update(done += 0.0001, ""); // then 1000 s
    // 0.6 left: 600 s at the pace of now, some 195 s at the mean pace
    const std::string text = out.str();
    const std::string last = text.substr(text.rfind('\r') + 1);
    INFO(last);
    const auto at = last.find("] ");
    const int minutes = std::stoi(last.substr(at + 2));
    CHECK(minutes >= 9);
    CHECK(minutes <= 10);
}

TEST_CASE("progress: shares outside 0 to 1 and NaN are drawn as the nearest end",
          "[app][progress]")
{
    for (const double done : {-1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
        std::ostringstream out;
        double now = 0.0;
        Progress progress(out, kTerminal, [&] { return now; });
        now = 3.0;
        progress.update(done, "");
        CHECK_THAT(out.str(), Contains(done > 1.0 ? "100 % [====" : "  0 % [>"));
        CHECK(out.str().find("nan") == std::string::npos);
    }
}

TEST_CASE("progress: times are read as on a clock", "[app][progress]")
{
    CHECK(clock_text(0.0) == "0:00");
    CHECK(clock_text(65.4) == "1:05");
    CHECK(clock_text(3599.6) == "1:00:00");
    CHECK(clock_text(3700.0) == "1:01:40");
    CHECK(clock_text(-1.0) == "-:--");
    CHECK(clock_text(std::numeric_limits<double>::infinity()) == "-:--");
}
