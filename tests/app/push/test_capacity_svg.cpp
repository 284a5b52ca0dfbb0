#include "app/push/capacity_svg.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/study_scenes.hpp"
#include "tests/scenes/xml_tree.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using Catch::Matchers::VectorContains;

namespace {

/// The small study, pushed along these targets.
app::Study study(const std::string& load, const std::string& fragility = "")
{
    std::string text = study_scenes::kSmall;
    const std::string most = "max_displacement = 4 mm";
    text.replace(text.find(most), most.size(), load);
    return study_scenes::study("samples = 1\n" + fragility, text);
}

app::PushedWall wall(const app::Study& s, std::vector<double> mm, std::vector<double> kn)
{
    app::PushedWall w;
    w.vertical_stress = 5e5;
    w.loads.height = 0.5;
    for (double& x : mm) x *= 1e-3;
    for (double& f : kn) f *= 1e3;
    w.displacement = std::move(mm);
    w.force = std::move(kn);
    app::ReadingRules rules = app::reading_rules(s);
    rules.height = w.loads.height;
    w.reading = app::read({w.displacement, w.force}, {}, rules);
    return w;
}

std::vector<std::string> texts(const app::Study& s, const app::PushedWall& w)
{
    return scenes::texts(scenes::parse_xml(app::capacity_svg(app::reading_rules(s), w)));
}

bool any(const std::vector<std::string>& all, const std::string& part)
{
    return std::ranges::any_of(all,
                               [&](const std::string& t) { return t.find(part) != t.npos; });
}

} // namespace

TEST_CASE("capacity picture: limit states are drawn where the table has them",
          "[app][capacity_svg]")
{
    const app::Study s = study("max_displacement = 4 mm");
    const auto found = texts(s, wall(s, {0, 1, 2, 4}, {0, 10, 10, 0}));
    CHECK_THAT(found, VectorContains(std::string("peak 10.0 kN")));
    CHECK_THAT(found,
               VectorContains(std::string("80 % of the peak, paper ultimate, ntc SLC 2.4 mm")));
    CHECK_THAT(found, VectorContains(std::string("ntc SLV 1.8 mm")));
}

TEST_CASE("capacity picture: a force that has not fallen is no peak", "[app][capacity_svg]")
{
    const app::Study s = study("max_displacement = 4 mm");
    const auto found = texts(s, wall(s, {0, 2, 4}, {0, 8, 10}));
    CHECK_THAT(found,
               VectorContains(std::string("largest force 10.0 kN, where the push ends")));
    CHECK_FALSE(any(found, "peak 10"));
    CHECK_FALSE(any(texts(s, wall(s, {0, 2, 3.98, 4}, {0, 8, 10, 9.99})), "peak 10"));
}

TEST_CASE("capacity picture: the force before the push is explained", "[app][capacity_svg]")
{
    const app::Study s = study("max_displacement = 4 mm");
    CHECK(any(texts(s, wall(s, {0, 1, 4}, {3, 10, 8})),
              "3.0 kN hold the loaded wall upright before the push"));
    CHECK_FALSE(any(texts(s, wall(s, {0, 1, 4}, {0.05, 10, 8})), "before the push"));
}

TEST_CASE("capacity picture: a cyclic push has one peak, that of its table",
          "[app][capacity_svg]")
{
    const std::vector<double> mm = {0, 2, 0, -2, 0, 3, 0, -3, 0},
                              kn = {0, 10, 0, -6, 0, 9, 0, -5, 0};
    const app::Study s = study("targets = 2, -2, 3, -3, 0 mm");
    const auto found = texts(s, wall(s, mm, kn));
    std::set<std::string> peaks; // each text is drawn twice: its white rim first
    for (const std::string& t : found)
        if (t.starts_with("peak ") || t.starts_with("largest force")) peaks.insert(t);
    CHECK(peaks.size() == 1);
    CHECK_THAT(found, VectorContains(std::string("peak 8.0 kN"))); // the mean of 10 and 6
    for (const char* const name : {"path of the push", "backbones of both directions",
                                   "their mean: the peak and the limits of the table"})
        CHECK_THAT(found, VectorContains(std::string(name)));
    const app::Study left =
        study("targets = 2, -2, 3, -3, 0 mm", "[fragility]\nbackbone = left\n");
    CHECK_THAT(texts(left, wall(left, mm, kn)), VectorContains(std::string("peak 6.0 kN")));
}
