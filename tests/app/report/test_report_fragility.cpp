#include "app/report/report_parts.hpp"
#include "app/wall_scenes.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace {

/// 50 walls under each stress, so many of them rocking.
app::StudyWalls study_of(const std::vector<double>& stress_MPa, const std::vector<int>& rocking)
{
    app::StudyWalls study;
    for (std::size_t l = 0; l < stress_MPa.size(); ++l) {
        study.levels.push_back(scenes::level(1e6 * stress_MPa[l]));
        for (int i = 0; i < 50; ++i)
            study.levels[l].walls.push_back(scenes::read_wall(
                {static_cast<std::uint32_t>(l), static_cast<std::uint32_t>(i)}, 1e3, 0.01, true,
                i < rocking[l] ? dem::FailureMode::rocking : dem::FailureMode::mixed));
    }
    return study;
}

const std::vector<double> kStress = {0.15, 0.50, 0.75, 1.00, 1.25};

std::string note_of(const nlohmann::ordered_json& modes)
{
    return modes["note"].get<std::string>();
}

} // namespace

TEST_CASE("report fragility: a line over the stress that fits the shares says how well",
          "[app][report_fragility]")
{
    const auto modes = app::modes_json(study_of(kStress, {45, 30, 24, 12, 8}));
    CHECK(modes["levels"].size() == 5);
    CHECK(modes.contains("model"));
    CHECK(note_of(modes).starts_with("Line: logistic regression on the stress; lack of fit: "
                                     "deviance 2.0 on 3 degrees of freedom, p = 0.581. "
                                     "Both modes are equally likely at 0.70 MPa [0.61, "));
}

TEST_CASE("report fragility: a line that does not fit the shares is not drawn",
          "[app][report_fragility]")
{
    const auto modes = app::modes_json(study_of(kStress, {50, 18, 17, 12, 12}));
    CHECK(modes["levels"].size() == 5);
    CHECK_FALSE(modes.contains("model"));
    CHECK(note_of(modes) == "No line: logistic regression on the stress does not fit these "
                            "shares (deviance 37.6 on 3 degrees of freedom, p < 0.001).");
}

TEST_CASE("report fragility: two shares are no test of the line through them",
          "[app][report_fragility]")
{
    const auto modes = app::modes_json(study_of({0.50, 1.00}, {40, 10}));
    CHECK(modes.contains("model"));
    CHECK(note_of(modes).starts_with("Line: logistic regression on the stress. Both modes"));
}

TEST_CASE("report fragility: a drift limit of the code is said in words and has no curve",
          "[app][report_fragility]")
{
    app::DriftData data;
    data.states = {{"ntc", "SLC", "whichever comes first"}};
    data.groups.push_back({"0.50 MPa", 0.5, {}, 0, 0, {}});
    for (int i = 0; i < 20; ++i)
        data.groups[0].walls.push_back({-1, {fragility::Observation{1.0, 1.0, 1.0, true}}});
    const auto curve = app::fragility_json(data)[0]["curves"][0];
    CHECK(curve["limit"] == "cap of the code (1.00 %): 100 % of walls");
    CHECK(curve["steps"].empty());
    CHECK_FALSE(curve.contains("least"));
    CHECK(curve["fitted"] == false);
    data.groups[0].walls.push_back({-1, {fragility::observed(0.7)}});
    CHECK_FALSE(app::fragility_json(data)[0]["curves"][0].contains("limit"));
}
