#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

using scenes::area;
using scenes::drawing_of;
using scenes::notes;
using scenes::Pixels;
using scenes::pixels;
using scenes::png_bytes;

namespace {

constexpr int kWhite = 0xffffff;

using SideKey = std::tuple<double, double, double, double>;

/// Every side is a side of another block too, to the bit, or lies on the frame: all there is of
/// it.
void check_fills(const app::Drawing& drawing, double width, double height)
{
    std::map<SideKey, int> sides;
    for (const app::DrawnBlock& block : drawing.blocks) {
        CHECK(area(block) > 0.0);
        for (std::size_t i = 0; i < block.outline.size(); ++i) {
            const dem::Point a = block.outline[i],
                             b = block.outline[(i + 1) % block.outline.size()];
            CHECK(++sides[{a.x, a.z, b.x, b.z}] == 1);
        }
    }
    double frame = 0.0;
    for (const auto& [side, n] : sides) {
        const auto& [ax, az, bx, bz] = side;
        if (sides.contains({bx, bz, ax, az})) continue;
        CHECK(((ax == bx && (ax == 0.0 || ax == width)) ||
               (az == bz && (az == 0.0 || az == height))));
        frame += std::hypot(bx - ax, bz - az);
    }
    CHECK(frame == Approx(2.0 * (width + height)).epsilon(1e-12));
    CHECK(std::abs(area(drawing) - width * height) < 1e-12 * width * height);
}

double turn(const SideKey& s, double x, double z)
{
    const auto& [ax, az, bx, bz] = s;
    return (bx - ax) * (z - az) - (bz - az) * (x - ax);
}

/// Pairs of sides that cross, each with each.
int crossings(const app::Drawing& drawing)
{
    std::vector<SideKey> sides;
    for (const app::DrawnBlock& block : drawing.blocks)
        for (std::size_t i = 0; i < block.outline.size(); ++i) {
            const dem::Point a = block.outline[i],
                             b = block.outline[(i + 1) % block.outline.size()];
            sides.emplace_back(a.x, a.z, b.x, b.z);
        }
    int n = 0;
    for (const SideKey& s : sides)
        for (const SideKey& t : sides) {
            const auto& [ax, az, bx, bz] = s;
            const auto& [cx, cz, dx, dz] = t;
            n += turn(s, cx, cz) * turn(s, dx, dz) < -1e-24 &&
                         turn(t, ax, az) * turn(t, bx, bz) < -1e-24
                     ? 1
                     : 0;
        }
    return n;
}

bool contains(const app::DrawnBlock& block, double x, double z)
{
    bool inside = false;
    for (std::size_t i = 0; i < block.outline.size(); ++i) {
        const dem::Point a = block.outline[i],
                         b = block.outline[(i + 1) % block.outline.size()];
        if ((a.z > z) != (b.z > z) && x < a.x + (z - a.z) / (b.z - a.z) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

struct Seed {
    double x = 0.0, y = 0.0;
};

/// Seeds at random, the same in every run.
std::vector<Seed> seeds(int n, double width, double height)
{
    std::vector<Seed> all;
    unsigned state = 7;
    const auto random = [&] {
        state = state * 1664525U + 1013904223U;
        return static_cast<double>(state >> 8) / 16777216.0;
    };
    for (int i = 0; i < n; ++i) {
        const double x = width * random();
        all.push_back({x, height * random()});
    }
    return all;
}

/// Rubble: cells around seeds; mortar where the two nearest seeds are almost equally near.
/// @param mortar width of it [pixels]
/// @param bright colour of the stone of a seed
template <class Colour>
Pixels rubble(int columns, int rows, int stones, double mortar, const Colour& bright)
{
    const std::vector<Seed> all = seeds(stones, columns, rows);
    Pixels picture = pixels(columns, rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            std::vector<std::pair<double, int>> near;
            for (int i = 0; i < stones; ++i)
                near.emplace_back(std::hypot(all[static_cast<std::size_t>(i)].x - column,
                                             all[static_cast<std::size_t>(i)].y - row),
                                  i);
            std::partial_sort(near.begin(), near.begin() + 2, near.end());
            if (near[1].first - near[0].first >= mortar)
                picture.at(column, row) = bright(near[0].second);
        }
    return picture;
}

} // namespace

TEST_CASE("picture drawing: white stones grow to the middle of the mortar and fill the picture",
          "[app][picture_drawing]")
{
    Pixels picture = pixels(200, 100);
    picture.fill(0, 0, 90, 50, kWhite);    // upper left
    picture.fill(110, 4, 200, 50, kWhite); // upper right
    picture.fill(0, 60, 200, 100, kWhite); // below
    picture.fill(50, 53, 52, 55, kWhite);  // dirt
    const app::Drawing wall = drawing_of("w.png", png_bytes(picture),
                                         {.width = 2.0, .height = 1.0, .simplify = 0.03});
    REQUIRE(wall.blocks.size() == 3);
    check_fills(wall, 2.0, 1.0);
    const auto has = [&](std::size_t block, double x, double z) {
        const std::vector<dem::Point>& o = wall.blocks[block].outline;
        return std::any_of(o.begin(), o.end(),
                           [&](const dem::Point& p) { return p.x == x && p.z == z; });
    };
    CHECK(
        (has(0, 1.0, 1.0) && has(1, 1.0, 1.0))); // the middle of the mortar between 90 and 110
    CHECK((has(0, 0.0, 0.45) && has(2, 0.0, 0.45))); // between 50 and 60
    CHECK((has(1, 2.0, 0.45) && has(2, 2.0, 0.45)));
    CHECK(scenes::notes(wall, "bright stones (grey 255 of 255) on dark mortar (0)"));
    CHECK(scenes::notes(wall, "3 stones cover 1.664 m2 of 2 m2 (83.2 %)"));
    CHECK(scenes::notes(wall, "1 area smaller than 36 cm2 was taken as dirt"));
}

TEST_CASE("picture drawing: stones of one colour each may touch, and black is mortar",
          "[app][picture_drawing]")
{
    Pixels picture = pixels(100, 100);
    picture.fill(0, 0, 50, 48, 0xa04020);
    picture.fill(50, 0, 100, 48, 0xa04021);
    picture.fill(0, 52, 100, 100, 0x3060c0);
    const app::Drawing wall = drawing_of("w.png", png_bytes(picture),
                                         {.width = 1.0, .height = 1.0, .simplify = 0.02});
    REQUIRE(wall.blocks.size() == 3);
    check_fills(wall, 1.0, 1.0);
    CHECK(area(wall.blocks[0]) == Approx(0.25).epsilon(1e-12));
    CHECK(scenes::notes(wall, "each connected area of one colour is a stone"));
}

TEST_CASE("picture drawing: every pixel of a rubble wall is in exactly one block, and stones "
          "keep their shape",
          "[app][picture_drawing]")
{
    const Pixels picture = rubble(240, 200, 40, 6.0, [](int) { return kWhite; });
    const app::DrawingOptions options{.width = 1.2, .height = 1.0, .simplify = 0.01};
    const app::Drawing wall = drawing_of("w.png", png_bytes(picture), options);
    CHECK(wall.blocks.size() > 25);
    check_fills(wall, 1.2, 1.0);
    CHECK(crossings(wall) == 0);
    int stones = 0, mixed = 0;
    for (int row = 0; row < picture.rows; row += 3)
        for (int column = 0; column < picture.columns; column += 3) {
            int in = 0;
            for (const app::DrawnBlock& block : wall.blocks)
                in +=
                    contains(block, 0.005 * (column + 0.5), 0.005 * (picture.rows - row - 0.5))
                        ? 1
                        : 0;
            mixed += in == 1 ? 0 : 1;
            ++stones;
        }
    CHECK(stones > 5000);
    CHECK(mixed == 0);
}

TEST_CASE("picture drawing: borders do not cross, however coarse they are",
          "[app][picture_drawing]")
{
    const Pixels picture =
        rubble(120, 100, 60, 2.0, [](int i) { return 0x203040 + 0x010301 * i; });
    for (const double simplify : {0.0, 0.004, 0.02, 0.05}) {
        INFO(simplify);
        const app::Drawing wall = drawing_of(
            "w.png", png_bytes(picture), {.width = 1.2, .height = 1.0, .simplify = simplify});
        check_fills(wall, 1.2, 1.0);
        CHECK(crossings(wall) == 0);
    }
}

TEST_CASE("picture drawing: stones thinner than the tolerance keep their place between others",
          "[app][picture_drawing]")
{
    Pixels picture = pixels(200, 100, 0x600000);
    picture.fill(0, 50, 200, 100, 0x006000);
    for (int column = 20; column < 180;
         ++column) { // a lens: its two borders have the same ends
        const int half = 1 + static_cast<int>(3.0 * std::sin(3.14 * (column - 20) / 160.0));
        picture.fill(column, 50 - half, column + 1, 50 + half, 0x000060);
    }
    const app::Drawing wall = drawing_of("w.png", png_bytes(picture),
                                         {.width = 2.0, .height = 1.0, .simplify = 0.06});
    CHECK(wall.blocks.size() == 3);
    check_fills(wall, 2.0, 1.0);
    CHECK(crossings(wall) == 0);
    CHECK(scenes::notes(wall, "simplified less, to keep clear of others"));
}

TEST_CASE("picture drawing: stones that grow stay in one piece", "[app][picture_drawing]")
{
    Pixels picture = pixels(40, 40); // the tip of one cell hangs by the corner of a pixel
    int colour = 0x400000;
    for (const auto& [left, top, right, bottom] : {std::array{11, 1, 20, 11},
                                                   {5, 23, 15, 36},
                                                   {20, 19, 36, 30},
                                                   {0, 11, 12, 21},
                                                   {14, 14, 21, 17}})
        picture.fill(left, top, right, bottom, colour += 0x100000);
    const app::Drawing wall =
        drawing_of("w.png", png_bytes(picture), {.width = 1.0, .height = 1.0, .simplify = 0.0});
    CHECK(wall.blocks.size() == 5);
    check_fills(wall, 1.0, 1.0);
}

TEST_CASE("picture drawing: a stone of three borders keeps them, however short",
          "[app][picture_drawing]")
{
    Pixels picture = pixels(100, 100, 0x600000);
    picture.fill(20, 0, 100, 50, 0x006000);
    picture.fill(20, 50, 100, 100, 0x606000);
    for (int column = 20; column < 80; ++column) {
        const int half = (80 - column) / 12;
        picture.fill(column, 50 - half, column + 1, 50 + half, 0x000060);
    }
    const app::Drawing wall = drawing_of("w.png", png_bytes(picture),
                                         {.width = 1.0, .height = 1.0, .simplify = 0.051});
    CHECK(wall.blocks.size() == 4);
    check_fills(wall, 1.0, 1.0);
    CHECK_FALSE(scenes::notes(wall, "closed to"));
}

TEST_CASE("picture drawing: a short border stays where a stone would touch itself",
          "[app][picture_drawing]")
{
    Pixels picture = pixels(100, 100, 0x600000); // around a pocket whose neck is 20 mm wide
    picture.fill(70, 0, 100, 100, 0x006000);
    picture.fill(20, 20, 60, 80, 0x000060);
    picture.fill(20, 60, 60, 80, 0x606000);
    picture.fill(60, 49, 70, 51, 0x000060);
    const app::Drawing wall = drawing_of("w.png", png_bytes(picture),
                                         {.width = 1.0, .height = 1.0, .simplify = 0.015});
    CHECK(wall.blocks.size() == 4);
    check_fills(wall, 1.0, 1.0);
}

TEST_CASE("picture drawing: borders much shorter than the tolerance are closed to points",
          "[app][picture_drawing]")
{
    Pixels picture = pixels(100, 100);
    picture.fill(0, 0, 50, 50, 0x400000);
    picture.fill(50, 0, 100, 52, 0x500000);
    picture.fill(0, 50, 50, 100, 0x600000);
    picture.fill(50, 52, 100, 100, 0x700000);
    const auto wall = [&](double simplify) {
        return drawing_of("w.png", png_bytes(picture),
                          {.width = 1.0, .height = 1.0, .simplify = simplify});
    };
    CHECK(scenes::common_sides(wall(0.009)) ==
          5); // the short one, of 20 mm, has a side of its own
    CHECK(scenes::common_sides(wall(0.011)) == 4); // 22 mm
    CHECK(scenes::notes(wall(0.011), "1 border shorter than 22 mm was closed to a point"));
    check_fills(wall(0.011), 1.0, 1.0);
}

TEST_CASE("picture drawing: pictures of no wall are refused", "[app][picture_drawing]")
{
    const app::DrawingOptions metre{.width = 1.0, .height = 1.0};
    const auto why = [&](const std::string& bytes, const app::DrawingOptions& options) {
        return scenes::refusal("w.png", bytes, options);
    };
    Pixels island = pixels(100, 100);
    island.fill(0, 0, 100, 100, kWhite);
    island.fill(30, 30, 70, 70, 0);
    island.fill(40, 40, 60, 60, kWhite);
    const std::string good = png_bytes(rubble(40, 40, 4, 2.0, [](int) { return kWhite; }));
    CHECK(why(good, metre) == "read");
    CHECK(why(good, {}).starts_with("w.png: is a picture of 0 x 0 m; give the size"));
    CHECK(why(good, {.width = 1000.0, .height = 1200.0}).find("wall.picture_width") !=
          std::string::npos);
    CHECK(why(good.substr(0, good.size() / 2), metre)
              .starts_with("w.png: is no PNG that can be read"));
    CHECK(why("GIF89a", metre).starts_with("w.png: is no PNG that can be read"));
    CHECK(why(png_bytes(pixels(50, 50)), metre).find("stones cover 0.0 % of it") !=
          std::string::npos);
    CHECK(why(png_bytes(island), metre)
              .starts_with("w.png: one stone encloses another at pixel ("));
}

TEST_CASE("picture drawing: a rubble wall drawn by others becomes a wall",
          "[app][picture_drawing]")
{
    // Drawings of other programs are not part of this repository: their folder is named by the
    // environment.
    const char* folder = std::getenv("DRYSTONE_DRAWINGS");
    if (folder == nullptr) return;
    const app::Drawing wall = app::read_drawing(std::filesystem::path(folder) / "WR1_100.png",
                                                {.width = 1.0, .height = 1.2});
    CHECK(wall.blocks.size() == 48);
    check_fills(wall, 1.0, 1.2);
    CHECK(crossings(wall) == 0);
}

TEST_CASE("picture drawing: bed joints are level where head joints meet them, however wide the "
          "mortar is",
          "[app][picture_drawing]")
{
    constexpr int kLength = 100, kHeight = 50; // of a stone [pixels]
    // the last course has its head joints 15 pixels beside those below, within the width of the
    // mortar
    for (const int mortar : {2, 4, 8, 20}) {
        INFO(mortar);
        Pixels picture = pixels(300, 200);
        for (int course = 0; course < 4; ++course)
            for (int from = course % 2 == 0 ? 0
                            : course == 1   ? -50
                                            : -65;
                 from < 300; from += kLength)
                picture.fill(
                    std::max(0, from == 0 ? 0 : from + mortar / 2),
                    course * kHeight + (course == 0 ? 0 : mortar / 2),
                    std::min(300, from + kLength == 300 ? 300 : from + kLength - mortar / 2),
                    (course + 1) * kHeight - (course == 3 ? 0 : mortar / 2), kWhite);
        const app::Drawing wall = drawing_of("w.png", png_bytes(picture),
                                             {.width = 3.0, .height = 2.0, .simplify = 0.005});
        CHECK(wall.blocks.size() == 14);
        check_fills(wall, 3.0, 2.0);
        for (const app::DrawnBlock& block : wall.blocks)
            for (const dem::Point& p : block.outline) {
                const double level = 0.5 * std::round(p.z / 0.5);
                CHECK(std::abs(p.z - level) < 1e-4); // the middle of mortar was 25 mm off
            }
    }
}

TEST_CASE(
    "picture drawing: straight borders of a wall that leans stay straight where others end",
    "[app][picture_drawing]")
{
    // two stones above one, divided by mortar of 16 mm under 7 degrees
    const double slope = std::tan(0.122);
    Pixels picture = pixels(300, 200);
    for (int row = 0; row < 200; ++row)
        for (int column = 0; column < 300; ++column) {
            const double over = 120.0 + slope * (column - 150.0) - row; // above the bed
            if (over < -8.0 || (over > 8.0 && std::abs(column - 150 + slope * over) > 8.0))
                picture.at(column, row) = kWhite;
        }
    const app::Drawing wall = drawing_of("w.png", png_bytes(picture),
                                         {.width = 3.0, .height = 2.0, .simplify = 0.01});
    REQUIRE(wall.blocks.size() == 3);
    check_fills(wall, 3.0, 2.0);
    for (const dem::Point& p : wall.blocks[2].outline) {
        if (p.z == 0.0) continue;
        const double bed = 0.8 - slope * (p.x - 1.5);
        CHECK(std::abs(p.z - bed) <
              0.008); // a pixel is 10 mm; the middle of mortar was 20 mm off
    }
}

TEST_CASE("picture drawing: rubble in wide mortar fills the picture, and nothing crosses",
          "[app][picture_drawing][repeats]")
{
    const double mortar = GENERATE(4.0, 10.0, 13.0);
    const double simplify = GENERATE(0.002, 0.01, 0.03);
    INFO(mortar << ' ' << simplify);
    const Pixels picture = rubble(240, 200, 30, mortar, [](int) { return kWhite; });
    const app::Drawing wall = drawing_of("w.png", png_bytes(picture),
                                         {.width = 1.2, .height = 1.0, .simplify = simplify});
    check_fills(wall, 1.2, 1.0);
    CHECK(crossings(wall) == 0);
}

namespace {

/// How a program makes one pixel of two: weights of the six around the middle, and whether it
/// mixes light.
struct Halving {
    std::array<double, 3> weights; ///< from the middle outwards, of either side
    bool light = false;
};
constexpr Halving kMeans{{0.5, 0.0, 0.0}}, kLight{{0.5, 0.0, 0.0}, true},
    kSoft{{0.3, 0.15, 0.05}}, kSharpened{{0.52, 0.04, -0.06}};

/// A picture of half the size, with smooth edges.
Pixels halved(const Pixels& large, const Halving& by)
{
    Pixels small = pixels(large.columns / 2, large.rows / 2);
    const auto decoded = [&](int value) {
        return by.light ? std::pow(value / 255.0, 2.2) : value / 255.0;
    };
    for (int row = 0; row < small.rows; ++row)
        for (int column = 0; column < small.columns; ++column)
            for (const int shift : {16, 8, 0}) {
                double sum = 0.0;
                for (int i = -3; i < 3; ++i)
                    for (int k = -3; k < 3; ++k) {
                        const int r = std::clamp(2 * row + 1 + i, 0, large.rows - 1),
                                  c = std::clamp(2 * column + 1 + k, 0, large.columns - 1);
                        const int value =
                            large.colour[static_cast<std::size_t>(r * large.columns + c)];
                        sum += by.weights[static_cast<std::size_t>(i < 0 ? -1 - i : i)] *
                               by.weights[static_cast<std::size_t>(k < 0 ? -1 - k : k)] *
                               decoded(value >> shift & 0xff);
                    }
                sum = std::clamp(sum, 0.0, 1.0);
                const double stored = by.light ? std::pow(sum, 1.0 / 2.2) : sum;
                small.at(column, row) |= static_cast<int>(std::lround(255.0 * stored)) << shift;
            }
    return small;
}

/// Stones in courses, each in a colour of its own, twice as large as the picture will be: their
/// edges at even and at odd pixels. @param mortar [pixels]
Pixels coloured_courses(int mortar)
{
    constexpr int kHeights[] = {61, 58, 63, 60, 58};
    Pixels picture = pixels(600, 300);
    unsigned state = 3;
    int top = 0;
    for (const int height : kHeights) {
        const int bottom = std::min(300, top + height);
        for (int from = 0, i = 0; from < 600; ++i) {
            const int to = std::min(600, from + 83 + 7 * i + (top % 3) * 9);
            state = state * 1664525U + 1013904223U;
            picture.fill(from, top, to - mortar, bottom - mortar,
                         static_cast<int>(0x303030 + (state >> 8 & 0xbfbfbf)));
            from = to;
        }
        top = bottom;
    }
    return picture;
}

} // namespace

TEST_CASE("picture drawing: smooth edges of coloured stones are no stones",
          "[app][picture_drawing]")
{
    const app::DrawingOptions options{.width = 3.0, .height = 1.5, .simplify = 0.02};
    const auto areas = [](const app::Drawing& wall) {
        std::vector<double> all;
        for (const app::DrawnBlock& block : wall.blocks) all.push_back(area(block));
        std::sort(all.begin(), all.end());
        return all;
    };
    for (const int mortar : {0, 1, 5, 6}) {
        const Pixels large = coloured_courses(mortar);
        const app::Drawing sharp = drawing_of("w.png", png_bytes(large), options);
        CHECK_FALSE(scenes::notes(sharp, "smooth edges"));
        for (const Halving& halving : {kMeans, kLight, kSoft, kSharpened}) {
            INFO(mortar << ' ' << halving.weights[0] << ' ' << halving.light);
            const std::string bytes = png_bytes(halved(large, halving));
            if (mortar == 1 && halving.weights[0] == kSharpened.weights[0]) {
                // mortar of half a pixel, darker and brighter than it is: what it is nobody can
                // tell
                CHECK(scenes::refusal("w.png", bytes, options)
                          .find("paint them without smooth edges") != std::string::npos);
                continue;
            }
            const app::Drawing wall = drawing_of("w.png", bytes, options);
            CHECK(scenes::notes(wall, "were taken as smooth edges, not as stones"));
            for (const std::string& note : wall.notes) UNSCOPED_INFO(note);
            REQUIRE(wall.blocks.size() == sharp.blocks.size());
            check_fills(wall, 3.0, 1.5);
            const std::vector<double> found = areas(wall), drawn = areas(sharp);
            for (std::size_t i = 0; i < found.size(); ++i) // half a pixel on all sides
                CHECK(std::abs(found[i] - drawn[i]) < 0.005 * 1.7);
        }
    }
}

TEST_CASE("picture drawing: a stone as thin as an edge stays a stone", "[app][picture_drawing]")
{
    const app::DrawingOptions options{.width = 3.0, .height = 1.5, .simplify = 0.01};
    const auto stones = [&](const Pixels& picture) {
        return drawing_of("w.png", png_bytes(picture), options).blocks.size();
    };
    // four large stones, and below the upper two a thin one
    const auto wall = [](int scale, int mortar, int thin) {
        Pixels p = pixels(300 * scale, 150 * scale);
        const auto fill = [&](int left, int top, int right, int bottom, int colour) {
            p.fill(left * scale, top * scale, right * scale, bottom * scale, colour);
        };
        fill(0, 0, 150 - mortar, 70, 0xc04020);
        fill(150, 0, 300, 70, 0x40a060);
        fill(0, 70 + mortar, 300, 73 + mortar, thin);
        fill(0, 73 + 2 * mortar, 180 - mortar, 150, 0x3060c0);
        fill(180, 73 + 2 * mortar, 300, 150, 0xd0b040);
        return p;
    };
    for (const int thin : {0xe0e0e0, 0x702080, 0x303030})
        for (const int mortar : {0, 4}) {
            INFO(thin << ' ' << mortar);
            CHECK(stones(wall(1, mortar, thin)) == 5);
        }
    const Pixels smooth = halved(wall(2, 4, 0xe0e0e0), kSoft); // its own edges are none
    CHECK(stones(smooth) == 5);
    CHECK(scenes::notes(drawing_of("w.png", png_bytes(wall(1, 4, 0xe0e0e0)), options),
                        "1 stone is at most 4 pixels wide, such as the one at pixel (0, 74)"));
}

TEST_CASE(
    "picture drawing: magenta areas are openings, which no block fills and nothing grows into",
    "[app][picture_drawing]")
{
    const int other = GENERATE(0xffffff, 0x4080c0); // two greys; a colour for each stone
    const int red = GENERATE(0xff00ff, 0xff01ff);   // and a colour that is none of an opening
    Pixels picture = pixels(120, 100);
    picture.fill(0, 0, 58, 48, 0xffffff);
    picture.fill(62, 0, 120, 48, other);
    picture.fill(0, 52, 38, 100, other);
    picture.fill(82, 52, 120, 100, 0xffffff);
    picture.fill(42, 52, 78, 100, red);
    const app::Drawing drawing = drawing_of("w.png", png_bytes(picture),
                                            {.width = 1.2, .height = 1.0, .simplify = 0.005});
    const bool opening = red == 0xff00ff;
    CHECK(drawing.blocks.size() == (opening ? 4 : 5));
    CHECK(area(drawing) == Approx(1.2 - (opening ? 0.36 * 0.48 : 0.0)).epsilon(1e-9));
    CHECK(notes(drawing, "1 magenta area of 0.1728 m2 is an opening.") == opening);
    CHECK(notes(drawing, "1 stone is nearly magenta, such as the one at pixel (42, 52)") ==
          !opening);
}
