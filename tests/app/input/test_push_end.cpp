/// Where a push ends unless the study says it.

#include "app/input/study_reading.hpp"
#include "app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace {

using app::Study;
using study_texts::read_good;

Study good(std::vector<std::string> keys) { return read_good(keys); }

} // namespace

TEST_CASE("push end: a study follows its walls until the limits that it asks for are known",
          "[app][push_end]")
{
    const Study s = good({});
    CHECK(s.solver.kinematics == dem::Kinematics::finite);
    CHECK(s.load.max_displacement == 0.22); // a fifth of 1.10 m
    CHECK(s.load.stop_below == 0.78);       // below 80 % of the peak
    CHECK(app::push_plan(s).decided);
    CHECK(s.output.snapshot_every == Approx(2.5e-3));
    CHECK(good({"load.height=1.05 m"}).load.max_displacement == 0.21);
    CHECK(good({"fragility.ultimate_share=0.6"}).load.stop_below == 0.58);
}

TEST_CASE("push end: what a limit state asks for is pushed to", "[app][push_end]")
{
    const auto stop = [](const std::string& states, const std::string& user = "") {
        std::vector<std::string> keys = {"fragility.limit_states=" + states};
        if (!user.empty()) keys.push_back("fragility.user_states=" + user);
        return good(keys).load;
    };
    CHECK(stop("paper, ec8").stop_below == 0.78);
    CHECK(stop("paper, collapse").stop_below == 0.0); // no force is left
    CHECK(stop("user", "half: drop 0.5").stop_below == 0.48);
    CHECK(stop("user", "slight: 0.7 yield").stop_below == 0.78);
    CHECK(stop("user", "early: yield or 1 %").stop_below == 0.78);
    const app::LoadInput far = stop("user", "far: 30 %");
    CHECK(far.stop_below == 0.0); // by the drift alone, whatever the force
    CHECK(far.max_displacement == Approx(0.33));
    CHECK(good({"fragility.crossing=last"}).load.stop_below == 0.0);
}

TEST_CASE("push end: small displacements, cycles and what is given stay as they are",
          "[app][push_end]")
{
    const Study small = good({"solver.kinematics=small"});
    CHECK(small.load.max_displacement == 0.03);
    CHECK(small.load.stop_below == 0.0);
    CHECK(small.output.snapshot_every == 5e-4);
    CHECK(good({"load.targets=-200 mm"}).load.stop_below == 0.78); // to the left, one way
    const Study cycles = good({"load.amplitudes=1, 2 mm"});
    CHECK(cycles.load.stop_below == 0.0);
    CHECK(good({"load.protocol=fema461"}).load.max_displacement == 0.03);
    const Study given = good({"load.max_displacement=40 mm", "load.stop_below=0.3"});
    CHECK(given.load.max_displacement == 0.04);
    CHECK(given.load.stop_below == 0.3);
}

TEST_CASE("push end: a study that is written in full reads back to the same push",
          "[app][push_end]")
{
    const Study s = good({"joint.friction_angle=normal(mean 31.8 deg, cov 0.2)"});
    const Study again = study_texts::read(app::effective_configuration(s),
                                          {"fragility.limit_states=paper, collapse"});
    CHECK(s.load.stop_below == 0.78);
    CHECK(again.load.stop_below == 0.78); // its walls went no further
    CHECK(again.load.max_displacement == s.load.max_displacement);
}
