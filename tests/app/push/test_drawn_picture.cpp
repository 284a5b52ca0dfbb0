/// The picture of the values drawn for each joint and crack.

#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/push/drawn_picture.hpp"
#include "scenes/count_text.hpp"
#include "tests/app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using scenes::count;

app::Study spatial_study()
{
    return app::read_study(app::with_overrides(
        app::parse_study_text("study.ini", study_texts::kSmallWall),
        std::vector<std::string>{"uq.spatial=independent", "wall.unit_cracks=yes",
                                 "unit.tensile_strength=normal(mean 3.7 MPa, cov 0.1)"}));
}

} // namespace

TEST_CASE(
    "drawn picture: each joint and crack has the colour of its value, in a panel for each "
    "input",
    "[app][push][drawn_picture]")
{
    const app::Study study = spatial_study();
    const dem::Layout layout = app::layout_of(study, study.source);
    app::WallDraw draw;
    draw.values.emplace_back(static_cast<std::size_t>(layout.n_joints), 0.5);
    draw.values.emplace_back(static_cast<std::size_t>(layout.n_cracks), 3.7e6);
    draw.values[0][0] = 0.25;
    REQUIRE(layout.n_joints > layout.n_cracks);
    draw.values[0].back() = 0.75;
    draw.values[1][0] = 3.0e6;
    const std::string picture = app::drawn_picture(study.random, layout, draw);
    for (const char* const words : {"joint.friction_angle [deg]", "unit.tensile_strength [MPa]",
                                    "14.3", "43", "mean 3.6"})
        CHECK(picture.find(words) != std::string::npos);
    const auto faces = [&](int id, bool crack) {
        return static_cast<std::size_t>(
            std::ranges::count_if(layout.faces, [&](const dem::Face& f) {
                return f.id == id && (f.kind == dem::FaceKind::unit_crack) == crack;
            }));
    };
    // Smallest and largest are the ends of the scale, the others lie between.
    CHECK(count(picture, "stroke=\"#0d0887\"") == faces(1, false) + faces(1, true));
    CHECK(count(picture, "stroke=\"#f89540\"") ==
          faces(layout.n_joints, false) + static_cast<std::size_t>(layout.n_cracks) - 1);
    CHECK(count(picture, "<line ") >=
          static_cast<std::size_t>(layout.n_joints + layout.n_cracks));
}

TEST_CASE("drawn picture: a wall with one value for each input has none",
          "[app][push][drawn_picture]")
{
    const app::Study study = spatial_study();
    CHECK(app::drawn_picture(study.random, app::layout_of(study, study.source),
                             {{{0.5}, {3.7e6}}})
              .empty());
}
