#include "app/store/continued_head.hpp"
#include "app/study/stored/study_identity.hpp"

#include "app/reliability/evaluation_identity.hpp"
#include "app/store/store_head.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study_scenes.hpp"
#include "app/version.hpp"
#include "dem/solver/solver_revision.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace {

using Catch::Matchers::Contains;

/// The identity of the small study with a line in place of another.
std::string identity_with(const std::string& from, const std::string& to)
{
    std::string text = study_scenes::kSmall;
    text.replace(text.find(from), from.size(), to);
    return identity_text(study_scenes::study("samples = 2", text));
}

/// Wall that is stronger to the right, pushed to and fro and read on one side.
app::PushedWall pushed_to_and_fro(fragility::Side side)
{
    app::PushedWall w;
    w.displacement = {0.0, 1e-3, 2e-3, 0.0, -1e-3, -2e-3, 0.0};
    w.force = {0.0, 8e3, 10e3, 1e3, -5e3, -6e3, -1e3};
    app::ReadingRules rules;
    rules.direction = 0;
    rules.backbone = side;
    w.reading = app::read({w.displacement, w.force}, w.mechanism, rules);
    return w;
}

} // namespace

TEST_CASE("study identity: how the numbers of a distribution are written makes no difference",
          "[app][study_identity]")
{
    const std::string before = identity_text(study_scenes::study("samples = 2"));
    const std::string friction = "friction_angle = normal(mean 31.8 deg, cov 0.20)",
                      strength = "lognormal(mean 3.7 MPa, cov 0.30)";
    CHECK(identity_with(friction, "friction_angle = normal(mean 31.80 deg, cov 0.2)") ==
          before);
    CHECK(identity_with(friction, "friction_angle = normal( cov 2e-1, mean 31.8deg )") ==
          before);
    CHECK(identity_with(strength, "lognormal(mean 3700 kPa, cov 0.3)") == before);
    CHECK(identity_with(friction, "friction_angle = normal(mean 31.8 deg, cov 0.21)") !=
          before);
    CHECK(
        identity_with(friction, "friction_angle = normal(mean 31.8 deg, cov 0.20, to 1 rad)") !=
        before);
    CHECK_THAT(before, Contains("joint.friction_angle = normal(mean 31.8 deg, cov 0.2)\n"));
}

TEST_CASE("study identity: numbers inside texts may be written otherwise too",
          "[app][study_identity]")
{
    const auto text = [](const std::string& uq, const std::string& strength) {
        std::string all = study_scenes::kSmall;
        const std::string law = "lognormal(mean 3.7 MPa, cov 0.30)";
        all.replace(all.find(law), law.size(), strength);
        return identity_text(study_scenes::study(uq, all));
    };
    const std::string friction = "pearson = joint.friction_angle joint.stiffness_factor ";
    CHECK(text(friction + "0.30", "empirical(3.1, 4.0 MPa)") ==
          text(friction + " 0.3", "empirical(4000, 3100 kPa)"));
    CHECK(text(friction + "0.3", "3.7 MPa") != text(friction + "-0.3", "3.7 MPa"));
    const std::string cracks = "samples = 2\n[unit]\ncracks = grid";
    CHECK(text(cracks + "(2, 3)", "3.7 MPa") == text(cracks + "( 2,3 )", "3.7 MPa"));
    CHECK(text(cracks + "(2, 3)", "3.7 MPa") != text(cracks + "(3, 2)", "3.7 MPa"));
}

TEST_CASE("study identity: it states the revision of the solver, and no version",
          "[app][study_identity]")
{
    const std::string text = identity_text(study_scenes::study("samples = 2"));
    CHECK(app::solver_revision(text) == std::to_string(dem::kSolverRevision));
    CHECK_THAT(text, !Contains(app::kVersion));
}

TEST_CASE("study identity: what is read from walls of another revision says so",
          "[app][study_identity]")
{
    app::StoreHead head;
    head.identity = identity_text(study_scenes::study("samples = 2"));
    CHECK(other_revision_text(head).empty());
    head.identity = "solver_revision = 1\nwall.length = 1 m\n";
    CHECK_THAT(other_revision_text(head),
               Contains("pushed by revision 1 of the solver. This program has revision " +
                        std::to_string(dem::kSolverRevision)));
    head.identity = "drystone = 0.1.0\nwall.length = 1 m\n";
    CHECK_THAT(other_revision_text(head), Contains("by an earlier revision of the solver"));
}

TEST_CASE("study identity: evaluations of a wall belong to its stress, however it is written",
          "[app][study_identity]")
{
    const app::Study study = study_scenes::study("samples = 2");
    const auto at = [&](const std::string& level) { return wall_evaluations(study, level); };
    CHECK(at("0.5") == at("0.50 MPa"));
    CHECK(at("0.5") == at("500 kPa"));
    CHECK(at("0.5") != at("1"));
}

TEST_CASE("study identity: evaluations of a wall follow the rules by which it is read",
          "[app][study_identity]")
{
    const auto text = [&](const std::string& rules) {
        return wall_evaluations(study_scenes::study("samples = 2\n[fragility]\n" + rules),
                                "0.5");
    };
    CHECK(text("ultimate_share = 0.7") != text("ultimate_share = 0.8"));
    CHECK(text("ultimate_share = 0.70") == text("ultimate_share = 0.7"));
}

TEST_CASE("study columns: the facts of a push to and fro do not follow fragility.backbone",
          "[app][study_columns]")
{
    const app::WallRow mean = app::row_of({}, {}, pushed_to_and_fro(fragility::Side::mean));
    const auto fact = [](const app::WallRow& row, const char* name) {
        return row.responses[app::column_of(app::response_columns(), name)];
    };
    CHECK(fact(mean, "peak_force") == 8e3);
    for (const auto side :
         {fragility::Side::worse, fragility::Side::right, fragility::Side::left}) {
        CHECK(peak_force(pushed_to_and_fro(side).reading) != 8e3);
        const app::WallRow row = app::row_of({}, {}, pushed_to_and_fro(side));
        for (const char* const name : {"peak_force", "peak_displacement", "secant_stiffness"})
            CHECK(fact(row, name) == fact(mean, name));
    }
}
