/// Protocols that go as far as the wall can be pushed one way.

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/study_texts.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/push.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace app;

TEST_CASE(
    "protocol scale: scaled by a push one way, it goes to the ultimate displacement of the "
    "mean wall, which the study then says",
    "[app][protocol_scale]")
{
    // Rigid blocks of stone that cracks early.
    const std::vector<std::string> wall = {
        "solver.fidelity=rigid",         "unit.tensile_strength=0.5 MPa",
        "unit.cohesion=0.5 MPa",         "solver.steps_per_mm=300",
        "load.vertical_stress=1.00 MPa", "joint.wall_modulus=900 MPa",
    };
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), wall.begin(), wall.end());
        return study_texts::read_good(more);
    };
    const Study one_way = with({});
    const dem::Model model = model_of(prepare(one_way));
    const dem::PushResult r = dem::push(model, study_texts::materials(one_way, 0),
                                        push_plan(one_way), one_way.solver);
    std::vector<double> x, f;
    for (const dem::CurvePoint& p : r.curve) {
        x.push_back(p.displacement);
        f.push_back(p.force);
    }
    const auto ultimate = read({x, f, false}, {}, reading_rules(one_way)).ultimate;
    REQUIRE(is_observed(ultimate));
    REQUIRE(ultimate.displacement < 0.029);

    const Study scaled = with({"load.protocol=iso16670", "load.protocol_scale=one_way"});
    CHECK(scaled.load.max_displacement == Approx(ultimate.displacement).margin(0.51e-5));
    const auto targets = push_plan(scaled).targets;
    CHECK(*std::max_element(targets.begin(), targets.end()) == scaled.load.max_displacement);
    const std::string said = effective_configuration(scaled);
    CHECK(said.find("ultimate displacement of the mean wall pushed one way: ") !=
          std::string::npos);
    // Read again, it is the same push without another one to find it.
    const Study again = study_texts::read(said);
    CHECK(again.load.scaled.empty());
    CHECK(push_plan(again).targets == targets);

    const Study given = with({"load.protocol=iso16670"});
    CHECK(given.load.max_displacement == 0.03);
    const Study far = with(
        {"load.protocol=fema461", "load.protocol_scale=one_way", "load.max_displacement=1 mm"});
    CHECK(far.load.max_displacement == 0.001); // the force does not fall before
    CHECK(far.load.scaled == "> 1.00 mm under 1 MPa");
}
