#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using scenes::area;
using scenes::drawing_of;
using scenes::json_text;
using scenes::Outline;
using scenes::rectangle;
using scenes::running_bond;

namespace {

/// Each corner moved by up to `most`, the same way in every run.
void disturb(std::vector<Outline>& blocks, double most)
{
    unsigned state = 1;
    for (Outline& outline : blocks)
        for (double& x : outline) {
            state = state * 1664525U + 1013904223U;
            x += most * (static_cast<double>(state >> 8) / 8388608.0 - 1.0);
        }
}

constexpr app::DrawingOptions kMillimetres{.unit = 1e-3, .snap = 5e-4};

/// Two stones side by side on one with a sloping top, 0.1 m from the left; the corner between
/// them lies off it.
std::vector<app::DrawnBlock> on_a_slope(double off)
{
    const auto top = [](double x) { return 0.1 + 0.07 * x; };
    const dem::Point corner{0.1 + 0.2 / 3, top(0.2 / 3) + off};
    return {{{{0.1, 0}, {0.5, 0}, {0.5, top(0.4)}, {0.1, top(0)}}, ""},
            {{{0.1, top(0)}, corner, {corner.x, 0.3}, {0.1, 0.3}}, ""},
            {{corner, {0.5, top(0.4)}, {0.5, 0.3}, {corner.x, 0.3}}, ""}};
}

bool same_bits(const std::vector<dem::Point>& a, const std::vector<dem::Point>& b)
{
    return std::ranges::equal(
        a, b, [](dem::Point p, dem::Point q) { return p.x == q.x && p.z == q.z; });
}

} // namespace

TEST_CASE("drawing fit: what is drawn exactly stays as it is", "[app][drawing_fit]")
{
    const app::Drawing wall = drawing_of("w.json", json_text(running_bond(5, 6)), kMillimetres);
    CHECK(wall.notes.empty());
    CHECK(wall.blocks.size() == 33);
    CHECK(area(wall) == Approx(0.6).epsilon(1e-14));
    CHECK(scenes::common_sides(wall) ==
          4 * 3 + 5 * 3 + 5 * 10); // head joints; halves of bed joints
    for (const app::DrawnBlock& block : wall.blocks)
        for (const dem::Point& p : block.outline)
            CHECK(p.x * 10.0 == Approx(std::round(p.x * 10.0)).epsilon(1e-15));
}

TEST_CASE(
    "drawing fit: gaps and overlaps of 0.3 mm vanish, and common faces are common to the bit",
    "[app][drawing_fit]")
{
    std::vector<Outline> blocks = running_bond(5, 6);
    disturb(blocks, 0.1); // corners that coincide are up to 0.28 mm apart
    const app::Drawing wall = drawing_of("w.json", json_text(blocks), kMillimetres);
    CHECK(wall.blocks.size() == 33);
    CHECK(scenes::common_sides(wall) == 77);
    CHECK(scenes::notes(wall, "joined to others"));
    // Sides are straight where others end on them: a corner either turns by much or not at all.
    for (const app::DrawnBlock& block : wall.blocks)
        for (std::size_t k = 0; k < block.outline.size(); ++k) {
            const std::size_t n = block.outline.size();
            const dem::Point a = block.outline[k], p = block.outline[(k + 1) % n],
                             b = block.outline[(k + 2) % n];
            const double off = std::abs((b.x - a.x) * (p.z - a.z) - (b.z - a.z) * (p.x - a.x)) /
                               std::hypot(b.x - a.x, b.z - a.z);
            CHECK((off <= 1e-7 || off > 1e-2));
        }
    // No gap is left inside: the blocks cover what the outline around all of them encloses.
    double around = 0.0;
    for (std::size_t i = 0; i < wall.blocks.size(); ++i)
        for (std::size_t k = 0; k < wall.blocks[i].outline.size(); ++k) {
            const std::vector<dem::Point>& o = wall.blocks[i].outline;
            const dem::Point a = o[k], b = o[(k + 1) % o.size()];
            const bool outside = (a.z == 0.0 && b.z == 0.0) || (a.z > 0.599 && b.z > 0.599) ||
                                 (a.x < 0.001 && b.x < 0.001) || (a.x > 0.999 && b.x > 0.999);
            if (outside) around += (a.x * b.z - a.z * b.x) / 2.0;
        }
    CHECK(area(wall) == Approx(around).epsilon(1e-12));
    CHECK(area(wall) == Approx(0.6).epsilon(1e-3));
}

TEST_CASE("drawing fit: a gap of 0.3 mm between two blocks closes exactly",
          "[app][drawing_fit]")
{
    const app::Drawing two = drawing_of(
        "w.json", json_text({rectangle(0, 0, 100, 100), rectangle(100.3, 0, 200, 100)}),
        kMillimetres);
    CHECK(area(two) == Approx(0.02).epsilon(1e-14));
    CHECK(scenes::common_sides(two) == 1);
    const app::Drawing overlapping = drawing_of(
        "w.json", json_text({rectangle(0, 0, 100.3, 100), rectangle(100, 0, 200, 100)}),
        kMillimetres);
    CHECK(area(overlapping) == Approx(0.02).epsilon(1e-14));
    CHECK(scenes::common_sides(overlapping) == 1);
}

TEST_CASE("drawing fit: a corner near the middle of a side is put onto it, and the side stays "
          "straight",
          "[app][drawing_fit]")
{
    const app::Drawing wall =
        drawing_of("w.json",
                   json_text({rectangle(0, 0, 300, 100), rectangle(0, 100, 100, 200),
                              rectangle(100, 100.3, 300, 200)}),
                   kMillimetres);
    CHECK(area(wall) == Approx(0.06).epsilon(1e-12));
    REQUIRE(wall.blocks[0].outline.size() == 5);
    CHECK(scenes::common_sides(wall) == 3);

    const app::Drawing off =
        drawing_of("w.json",
                   json_text({rectangle(0, 0, 300, 100), rectangle(50, 100.2, 150, 200),
                              rectangle(150, 99.7, 250, 200)}),
                   kMillimetres);
    CHECK(scenes::common_sides(off) == 3);
    for (const dem::Point& p : off.blocks[0].outline)
        CHECK((p.z == 0.0 || std::abs(p.z - 0.1) <= 1e-7));
}

TEST_CASE("drawing fit: corners on straight lines go unless another block has a corner there",
          "[app][drawing_fit]")
{
    const app::Drawing wall = drawing_of(
        "w.json",
        json_text({{0, 0, 50, 0.3, 100, 0, 200, 0, 200, 50, 200, 100, 100, 100, 0, 100},
                   rectangle(100, 100, 200, 200),
                   {0, 100, 100, 100, 100, 200, 50, 201, 0, 200}}),
        kMillimetres);
    CHECK(wall.blocks[0].outline.size() == 5);
    CHECK(wall.blocks[2].outline.size() == 5); // 1 mm is a corner
    CHECK(scenes::notes(wall, "3 corners on straight sides were removed."));
}

TEST_CASE("drawing fit: the same drawing gives the same bits, and a fitted one stays as it is",
          "[app][drawing_fit]")
{
    std::vector<Outline> blocks = running_bond(4, 4);
    disturb(blocks, 0.15);
    const auto outlines = [](const app::Drawing& drawing) {
        std::vector<Outline> all;
        for (const app::DrawnBlock& block : drawing.blocks) {
            all.emplace_back();
            for (const dem::Point& p : block.outline)
                all.back().insert(all.back().end(), {p.x, p.z});
        }
        return all;
    };
    const std::vector<Outline> once =
        outlines(drawing_of("w.json", json_text(blocks), kMillimetres));
    CHECK(once == outlines(drawing_of("w.json", json_text(blocks), kMillimetres)));
    CHECK(once == outlines(drawing_of("w.json", json_text(once), {.unit = 1.0, .snap = 5e-4})));
}

TEST_CASE("drawing fit: gaps a little wider than snap are told", "[app][drawing_fit]")
{
    const app::Drawing wall = drawing_of(
        "w.json", json_text({rectangle(0, 0, 100, 100), rectangle(101, 0, 200, 100)}),
        kMillimetres);
    CHECK(scenes::notes(wall, "up to 1 mm away, and do not touch it"));
    const app::Drawing one = drawing_of(
        "w.json", json_text({rectangle(0, 0, 100, 100), {100, 0, 200, 0, 200, 120, 101, 50}}),
        kMillimetres);
    CHECK(scenes::notes(one, "1 corner lies near a side of another block, up to 1 mm away, and "
                             "does not touch it"));
    CHECK(scenes::common_sides(wall) == 0);
}

TEST_CASE("drawing fit: feet and tops that scatter by less than snap are level, others stay",
          "[app][drawing_fit]")
{
    const auto stones = [](const std::vector<double>& feet, const std::vector<double>& tops) {
        std::vector<Outline> blocks; // side by side
        for (std::size_t i = 0; i < 5; ++i) {
            const double left = 400.0 * static_cast<double>(i);
            blocks.push_back(rectangle(left, feet[i], left + 400.0, tops[i]));
        }
        return drawing_of("w.json", json_text(blocks), kMillimetres);
    };
    const auto level = [](const app::Drawing& wall, bool top) {
        int n = 0;
        double highest = 0.0;
        for (const app::DrawnBlock& block : wall.blocks)
            for (const dem::Point& p : block.outline) highest = std::max(highest, p.z);
        for (const app::DrawnBlock& block : wall.blocks)
            for (std::size_t i = 0; i < block.outline.size(); ++i) {
                const dem::Point a = block.outline[i],
                                 b = block.outline[(i + 1) % block.outline.size()];
                const double z = top ? highest : 0.0;
                n += a.z == z && b.z == z ? 1 : 0;
            }
        return n;
    };
    const app::Drawing even =
        stones({0.3, -0.3, 0.1, -0.1, 0.2}, {600, 599.7, 600.3, 599.8, 600});
    CHECK(level(even, false) == 5);
    CHECK(level(even, true) == 5);
    CHECK(scenes::common_sides(even) == 4);
    CHECK(scenes::notes(even, "put on the level of the lowest or the highest one, at most"));
    const app::Drawing steps = stones({0.0, 0.4, 0.8, 0.0, 0.4}, {600, 600, 600, 600, 600});
    CHECK(level(steps, false) == 5);
    CHECK(scenes::notes(steps, "(more than wall.snap (0.5 mm), because corners follow each "
                               "other in steps up to that)"));
    const app::Drawing uneven = stones({0, 0, 0, 0, 0}, {600, 602, 600, 602, 600});
    CHECK_FALSE(scenes::notes(uneven, "more than"));
    CHECK(level(uneven, false) == 5);
    CHECK(level(uneven, true) == 2);
}

TEST_CASE("drawing fit: outlines of a study that fit stay as they are written, to the bit",
          "[app][drawing_fit]")
{
    const std::vector<app::DrawnBlock> written = on_a_slope(0.0);
    const app::Drawing fitted = app::fit_blocks("study.ini", 2, written);
    CHECK(fitted.notes.empty());
    for (std::size_t b = 0; b < written.size(); ++b)
        CHECK(same_bits(fitted.blocks[b].outline, written[b].outline));
}

TEST_CASE("drawing fit: a corner of a study that lies up to two micrometres off a side is put "
          "onto it",
          "[app][drawing_fit]")
{
    for (const double off : {-1.9e-6, -5e-7, 2e-7, 1.5e-6}) {
        INFO("off by " << off << " m");
        const app::Drawing wall = app::fit_blocks("study.ini", 2, on_a_slope(off));
        CHECK(wall.notes.size() == 1);
        CHECK(scenes::notes(wall, "corners were moved by at most 0.00"));
        CHECK(scenes::common_sides(wall) == 3);
        REQUIRE(wall.blocks.size() == 3);
        REQUIRE(wall.blocks[0].outline.size() == 5);
        CHECK(wall.blocks[0].outline[0].x ==
              Approx(0.1).epsilon(1e-12)); // where it was written
        const dem::Point meet = wall.blocks[0].outline[3];
        CHECK(std::abs(meet.z - (0.1 + 0.07 * (meet.x - 0.1))) < 1e-7);
    }
}

TEST_CASE("drawing fit: a corner of a study that lies a little farther from a side is told",
          "[app][drawing_fit]")
{
    std::vector<app::DrawnBlock> written = on_a_slope(0.0);
    written[1].outline[1].z += 5e-6; // that stone leans against the other only
    const app::Drawing wall = app::fit_blocks("study.ini", 2, written);
    REQUIRE(wall.notes.size() == 1);
    CHECK_THAT(wall.notes.front(),
               Catch::Contains("up to 0.00499 mm away, and do not touch it"));
    CHECK(scenes::notes(wall, "joints need corners on the side"));
    CHECK(same_bits(wall.blocks[1].outline, written[1].outline));
}
