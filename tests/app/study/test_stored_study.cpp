#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/study/stored/stored_study.hpp"

#include "app/store/hdf5/store_error.hpp"
#include "app/study/stored/study_identity.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using Catch::Matchers::Contains;

namespace {

app::Study shipped(const std::string& name, const std::vector<std::string>& set = {})
{
    return app::prepare(app::read_study(DRYSTONE_SOURCE_DIR "/configs/" + name, set)).study;
}

app::StoreHead head_of_study(const app::Study& study)
{
    app::StoreHead head;
    head.configuration = app::effective_configuration(study);
    head.identity = app::identity_text(study);
    head.seed = study.uq.seed;
    for (const double stress : study.load.vertical_stress) head.levels.push_back({stress, 1});
    return head;
}

void replace(std::string& text, const std::string& old, const std::string& by)
{
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    text.replace(at, old.size(), by);
}

} // namespace

TEST_CASE("stored study: the configuration that is stored is the one of the identity, whatever "
          "the study",
          "[app][stored_study]")
{
    const auto [name, set] = GENERATE(table<std::string, std::vector<std::string>>(
        {{"wall.ini", {}},
         {"wall.ini", {"load.targets=0.5, -0.5, 1 mm"}},
         {"wall.ini", {"load.vertical_stress=0.1, 0.30000000000000004 MPa"}},
         {"levels.ini", {}},
         {"quick.ini", {}},
         {"../tests/study/small.ini", {"wall.bond=rubble", "wall.layouts=3"}},
         {"../tests/study/small.ini",
          {"unit.cracks=grid(2, 2)", "unit.cracks_where=needed", "joint.friction_angle=30 deg",
           "joint.stiffness_factor=1", "unit.tensile_strength=0.5 MPa"}},
         {"../tests/study/small.ini",
          {"load.protocol=fema461", "load.protocol_scale=one_way",
           "load.vertical_stress=0.5 MPa", "joint.wall_modulus=768 MPa"}},
         {"quick.ini", {"joint.friction_angle=normal( mean 31.80 deg, cov 0.20 )"}},
         {"paper.ini", {}},
         {"paper_spatial.ini", {}},
         {"correlated.ini", {}},
         {"collapse.ini", {}},
         {"facade.ini", {}},
         {"drawing.ini", {}},
         {"rubble.ini", {}},
         {"uncoupled.ini", {}}}));
    INFO(name);
    const app::Study study = shipped(name, set);
    const app::StoreHead head = head_of_study(study);
    INFO(head.configuration);
    CHECK_NOTHROW(app::stored_study("a.h5", head));
}

TEST_CASE(
    "stored study: a configuration that is not the one of the walls is refused with the line",
    "[app][stored_study]")
{
    const app::Study study = shipped("quick.ini", {"uq.samples=6"});
    app::StoreHead head = head_of_study(study);
    const auto refused = [&](const std::string& words) {
        CHECK_THROWS_AS(app::stored_study("stranger.h5", head), app::BadStoredStudy);
        CHECK_THROWS_WITH(app::stored_study("stranger.h5", head),
                          Contains("'stranger.h5' is damaged: its configuration is not that "
                                   "of its walls") &&
                              Contains(words));
    };
    SECTION("a value")
    {
        replace(head.configuration, "kinematics              = finite",
                "kinematics              = small");
        refused("+ solver.kinematics = small");
        // another version may have had other keys: its configuration counts
        const std::string own = head.identity;
        replace(head.identity, "solver_revision = ", "solver_revision = 1");
        CHECK_NOTHROW(app::stored_study("stranger.h5", head));
        head.identity = own + "solver_revision = 99\n"; // the first is this program's
        refused("- solver_revision = 99");
    }
    SECTION("seed") { head.seed = 7, refused("another seed or other stresses"); }
    SECTION("stress")
    {
        head.levels.front().vertical_stress *= 1.001;
        refused("another seed or other stresses");
    }
    SECTION("levels") { head.levels.pop_back(), refused("another seed or other stresses"); }
    SECTION("what is set now is no damage")
    {
        const std::vector<std::string> set = {"load.max_displacement=0.2 mm"};
        const app::Study now = app::stored_study("stranger.h5", head, set);
        CHECK(app::identity_text(now) != head.identity);
    }
}
