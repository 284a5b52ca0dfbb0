#include "app/input/keys/limit_state_text.hpp"

#include "app/input/study/units.hpp"
#include "app/study/pushed/pier_remark.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

app::ReadingRules wanted(const std::string& section)
{
    return app::reading_rules(
        study_scenes::study("samples = 1\n[fragility]\n" + section + "\n"));
}

std::vector<std::string> names(const app::ReadingRules& w)
{
    std::vector<std::string> all;
    for (const app::StateName& s : app::state_names(w)) all.push_back(s.set + " " + s.name);
    return all;
}

} // namespace

TEST_CASE("fragility states: sets are read in the order asked for, the user's last",
          "[app][fragility_states]")
{
    CHECK(
        names(wanted("limit_states = ec8, paper, user\nuser_states = mine: 0.7 yield")) ==
        std::vector<std::string>{"ec8 DL", "ec8 SD", "ec8 NC", "paper ultimate", "user mine"});
    CHECK(names(wanted("")) == std::vector<std::string>{"paper ultimate", "ntc SLO", "ntc SLD",
                                                        "ntc SLV", "ntc SLC"});
}

TEST_CASE("fragility states: rules say the numbers that were used", "[app][fragility_states]")
{
    const auto w = wanted("limit_states = paper, user\nultimate_share = 0.7\ncrossing = last\n"
                          "user_states = a: 0.5 yield + 0.5 ultimate; b: ultimate or 1.5 %");
    const auto states = app::state_names(w);
    REQUIRE(states.size() == 3);
    CHECK(states[0].rule == "last drop to 70 % of the peak");
    CHECK(states[1].rule == "0.5 d_y + 0.5 d_u");
    CHECK(states[2].rule == "1 d_u, at most 1.5 % drift");
}

TEST_CASE("fragility states: a cap in percent is a displacement at the height of the load",
          "[app][fragility_states]")
{
    app::ReadingRules rules = wanted("limit_states = user\nuser_states = cap: 2 %");
    rules.height = 1.10;
    const std::vector<double> x = {0.0, 0.01, 0.03}, f = {0.0, 5.0, 5.0};
    const auto limits = app::read({x, f}, {}, rules).limits;
    REQUIRE(limits.size() == 1);
    CHECK(limits[0].displacement == Approx(0.022).epsilon(1e-14));
}

TEST_CASE("fragility states: what is not a rule is refused with what is",
          "[app][fragility_states]")
{
    const struct {
        const char* text;
        const char* message;
    } cases[] = {{"0.7 yield", "is not a limit state"},
                 {"a: 0.7 yeld", "did you mean \"yield\"?"},
                 {"a: -1 yield", "positive factor"},
                 {"a: drop", "has no share"},
                 {"a: drop 1.5", "must be in (0, 1)"},
                 {"a: ultimate or peak", "only a drift may follow"},
                 {"a: ultimate or 0 %", "out of range"},
                 {"a: 1 yield; a: 2 yield", "given twice"},
                 {"a: drop 0.5 + 1 yield", "more than one rule"},
                 {"a:", "is not read off curves"}};
    for (const auto& c : cases)
        CHECK_THROWS_WITH(app::parse_user_states(c.text), Catch::Contains(c.message));
    CHECK_THROWS_WITH(wanted("limit_states = papr"),
                      Catch::Contains("study.ini:") &&
                          Catch::Contains("did you mean \"paper\""));
    CHECK_THROWS_AS(wanted("limit_states = user"), app::ConfigError);
    // found when the study is read, before any wall is run, and where no set asks for it, too
    CHECK_THROWS_WITH(study_scenes::study("samples = 1\n[fragility]\nlimit_states = NTC"),
                      Catch::Contains("study.ini:") && Catch::Contains("\"NTC\" is not a set"));
    CHECK_THROWS_WITH(
        study_scenes::study("samples = 1\n[fragility]\nuser_states = slight"),
        Catch::Contains("fragility.user_states: \"slight\" is not a limit state"));
}

TEST_CASE(
    "fragility states: ec8 has the drift limits of EN 1998-3 by mode and shear span, and is "
    "called so",
    "[app][fragility_states]")
{
    const std::vector<double> x = {0.0, 0.01, 1.0}, f = {0.0, 5.0, 5.0}; // never falls
    const auto nc = [&](const app::ReadingRules& rules, double rotation) {
        const dem::Mechanism m{.rotation_share = rotation, .turning_share = rotation};
        const auto limit = app::read({x, f}, m, rules).limits.back();
        CHECK(limit.reason == "governed by the drift limit of EN 1998-3, Annex C; compare with "
                              "your copy of the code");
        return limit.displacement / rules.height;
    };
    const app::ReadingRules free = wanted("limit_states = ec8");
    const double slenderness = 0.5 / 0.6; // height of the load over the length of the wall
    CHECK(free.height == Approx(0.5));
    CHECK(nc(free, 0.9) == Approx(4.0 / 3.0 * 0.008 * slenderness).epsilon(1e-12));
    CHECK(nc(free, 0.1) == Approx(4.0 / 3.0 * 0.004).epsilon(1e-12));
    const app::ReadingRules fixed =
        wanted("limit_states = ec8\n[beam]\nrotation = fixed"); // bends in double curvature
    CHECK(nc(fixed, 0.9) == Approx(4.0 / 3.0 * 0.008 * 0.5 * slenderness).epsilon(1e-12));
    CHECK(app::state_names(free).back().rule.find("compare with your copy of the code") !=
          std::string::npos);
}

TEST_CASE(
    "fragility states: the code's limits of a pier are remarked upon where a wall has several",
    "[app][fragility_states]")
{
    const auto remark = [](const std::string& wall, const std::string& states) {
        const app::Study study = study_scenes::study(
            "samples = 1\n[fragility]\nlimit_states = " + states + "\n[wall]\n" + wall);
        return app::pier_remark(app::reading_rules(study), study);
    };
    const std::string window = "openings = 0.2 m, 0.1 m, 0.2 m, 0.1 m";
    CHECK(remark("", "paper, ntc").empty());
    CHECK(remark(window, "paper").empty());
    CHECK(remark(window, "paper, ntc")
              .starts_with(
                  "the drift limits of ntc are those of one pier; this wall has several"));
    CHECK(remark(window, "ntc, ec8").find("ntc and ec8") != std::string::npos);
}

TEST_CASE("fragility states: a drawn wall has several piers where its stones leave an opening",
          "[app][fragility_states]")
{
    const auto box = [](double x0, double z0, double x1, double z1) {
        dem::DrawnUnit u;
        u.outline = {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}};
        return u;
    };
    app::Study study;
    study.geometry.units = {box(0.0, 0.0, 0.2, 0.3), box(0.4, 0.0, 0.6, 0.3),
                            box(0.0, 0.3, 0.6, 0.4)};
    CHECK(app::has_piers(study));
    study.geometry.units[1] = box(0.2, 0.0, 0.6, 0.3);
    CHECK_FALSE(app::has_piers(study));
    study.geometry.units[1] = box(0.21, 0.0, 0.6, 0.3); // a joint of mortar
    CHECK_FALSE(app::has_piers(study));
    study.geometry.units = {box(0.0, 0.0, 0.6, 0.3), box(0.0, 0.3, 0.3, 0.4)}; // a step
    CHECK_FALSE(app::has_piers(study));
}

TEST_CASE("fragility states: an arch has piers where it stands on some",
          "[app][fragility_states]")
{
    /// A half circle of mean radius 1 m between radial joints, its springing at height z.
    const auto arch = [](int stones, double thickness, double z) {
        std::vector<dem::DrawnUnit> units(static_cast<std::size_t>(stones));
        const auto at = [z](double r, double angle) {
            return dem::Point{1.3 - r * std::cos(angle), z + r * std::sin(angle)};
        };
        const double in = 1.0 - 0.5 * thickness, out = 1.0 + 0.5 * thickness;
        for (std::size_t i = 0; i < units.size(); ++i) {
            const double a = std::numbers::pi * static_cast<double>(i) / stones,
                         b = std::numbers::pi * static_cast<double>(i + 1) / stones;
            units[i].outline = {at(in, a), at(in, b), at(out, b), at(out, a)};
        }
        return units;
    };
    const int stones = GENERATE(5, 7, 8, 24);
    const double thickness = GENERATE(0.12, 0.4);
    app::Study study;
    study.geometry.units = arch(stones, thickness, 0.0);
    CHECK_FALSE(app::has_piers(study));

    study.geometry.units = arch(stones, thickness, 0.8);
    for (const double x : {0.3, 2.3}) {
        dem::DrawnUnit pier;
        const double half = 0.5 * thickness;
        pier.outline = {{x - half, 0.0}, {x + half, 0.0}, {x + half, 0.8}, {x - half, 0.8}};
        study.geometry.units.push_back(pier);
    }
    CHECK(app::has_piers(study));
}
