#include "app/drawing/outlines/drawing.hpp"
#include "app/photograph/photograph.hpp"
#include "app/photograph/stones_picture.hpp"
#include "app/text/config_error.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/app/drawing/photograph_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

using scenes::Look;

namespace {

app::DrawingFrame frame()
{
    app::DrawingFrame f;
    f.file = "wall.jpg";
    return f;
}

app::FoundStones found_in(const std::string& jpeg,
                          app::StoneMethod method = app::StoneMethod::best)
{
    return app::find_photographed(frame(), app::read_jpeg(frame(), jpeg), method);
}

std::string refusal(const app::Picture& picture)
{
    try {
        static_cast<void>(app::find_photographed(frame(), picture, app::StoneMethod::best));
    } catch (const app::ConfigError& error) {
        return error.what();
    }
    return "found";
}

const app::Labels& truth()
{
    static const app::Labels labels = scenes::rubble_truth();
    return labels;
}

std::vector<double> areas(const app::Labels& labels)
{
    std::vector<double> area(static_cast<std::size_t>(labels.stones));
    for (const int l : labels.label)
        if (l != app::kMortar) area[l] += 1.0;
    return area;
}

/// The stone that was found where each stone of the wall is, by the most pixels in common.
std::vector<int> matches(const app::Labels& found)
{
    std::vector<std::map<int, int>> common(static_cast<std::size_t>(truth().stones));
    for (std::size_t p = 0; p < found.label.size(); ++p)
        if (truth().label[p] != app::kMortar && found.label[p] != app::kMortar)
            ++common[truth().label[p]][found.label[p]];
    std::vector<int> match;
    for (const std::map<int, int>& c : common) {
        const auto most =
            std::ranges::max_element(c, {}, [](const auto& n) { return n.second; });
        match.push_back(most == c.end() ? app::kMortar : most->first);
    }
    return match;
}

const std::vector<Look> kLooks = {
    {.name = "compressed", .quality = 30},
    {.name = "noise", .noise = 20.0},
    {.name = "blur", .blur = 2.0},
    {.name = "light from one side", .dark = 0.4},
    {.name = "colour",
     .mortar = {128, 128, 128},
     .stones = {{{190, 110, 80}, {110, 150, 70}, {80, 120, 190}, {170, 120, 150}}}},
    {.name = "bright mortar",
     .mortar = {205, 200, 185},
     .stones = {{{110, 100, 90}, {120, 105, 90}, {100, 100, 95}, {115, 95, 90}}}},
    {.name = "all", .spread = 10.0, .blur = 1.2, .dark = 0.5, .noise = 8.0, .quality = 60}};

/// Reads so many files that were broken at random, or is refused.
void read_broken(int files)
{
    app::Picture small{48, 40, std::vector<std::uint8_t>(4 * 48 * 40, 255)};
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 48; ++column)
            if (column % 16 < 3 || row % 10 < 3)
                std::fill_n(small.rgba.data() + 4 * (row * 48 + column), 3, std::uint8_t{40});
    const std::string whole = scenes::jpeg_of(small, 70);
    std::mt19937 random(1);
    int read = 0, refused = 0;
    for (int i = 0; i < files; ++i) {
        std::string bytes = whole;
        for (unsigned n = 1 + random() % 4; n > 0; --n) {
            const std::size_t at = random() % bytes.size();
            switch (random() % 4) {
            case 0:
                bytes[at] = static_cast<char>(random());
                break;
            case 1:
                bytes.resize(at + 1);
                break;
            case 2:
                bytes.erase(at, random() % 20);
                break;
            default:
                bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 20));
            }
            if (bytes.empty()) bytes = "x";
        }
        try {
            const app::FoundStones found =
                found_in(bytes, static_cast<app::StoneMethod>(i % 4));
            CHECK(found.labels.label.size() == found.photograph.rgba.size() / 4);
            ++read;
        } catch (const app::ConfigError& error) {
            CHECK(std::string(error.what()).starts_with("wall.jpg: "));
            ++refused;
        }
    }
    CHECK(read > files / 10);
    CHECK(refused > files / 10);
}

} // namespace

TEST_CASE("photograph: every stone of a rubble wall is found, within 5 % of its area",
          "[slow][app][photograph]")
{
    const Look look = GENERATE(from_range(kLooks));
    INFO(look.name);
    const app::FoundStones found =
        found_in(scenes::jpeg_of(scenes::photograph_of(truth(), look), look.quality));
    CHECK(found.labels.stones == truth().stones);
    const std::vector<double> area = areas(found.labels), wanted = areas(truth());
    const std::vector<int> match = matches(found.labels);
    double all = 0.0, all_wanted = 0.0;
    for (std::size_t s = 0; s < match.size(); ++s) {
        REQUIRE(match[s] != app::kMortar);
        CHECK(std::abs(area[match[s]] / wanted[s] - 1.0) < 0.05);
        all += area[match[s]];
        all_wanted += wanted[s];
    }
    CHECK(std::abs(all / all_wanted - 1.0) < 0.02);
}

TEST_CASE("photograph: each method finds the stones of an easy picture",
          "[app][photograph][repeats]")
{
    const auto method = GENERATE(app::StoneMethod::threshold, app::StoneMethod::kmeans,
                                 app::StoneMethod::watershed);
    const app::FoundStones found =
        found_in(scenes::jpeg_of(scenes::photograph_of(truth(), {}), 90), method);
    CHECK(found.method == method);
    CHECK(found.labels.stones == truth().stones);
}

TEST_CASE("photograph: the picture of the stones is read as these stones again",
          "[slow][app][photograph]")
{
    const app::FoundStones found = found_in(
        scenes::jpeg_of(scenes::photograph_of(truth(), {.name = "", .noise = 6.0}), 80));
    // with mortar between them, and touching
    for (const app::Labels& labels :
         {found.labels, app::grow_stones(found.labels, {1.0, 1.0})}) {
        std::vector<std::string> notes;
        const app::Labels again =
            app::find_stones(frame(), app::painted_picture(labels), {1.0, 1.0}, 0.0, notes);
        CHECK(again.stones == labels.stones);
        CHECK(again.label == labels.label);
    }
}

TEST_CASE("photograph: a magenta area is an opening, before and after",
          "[slow][app][photograph]")
{
    app::Picture picture = scenes::photograph_of(truth(), {.name = "", .noise = 4.0});
    for (int row = 200; row < 400; ++row)
        for (int column = 150; column < 300; ++column) {
            std::uint8_t* const p = picture.rgba.data() + 4 * (row * picture.columns + column);
            p[0] = p[2] = 255;
            p[1] = 0;
        }
    const app::FoundStones found = found_in(scenes::jpeg_of(picture, 85));
    const app::Labels& labels = found.labels;
    REQUIRE(std::ranges::count(labels.is_opening, 1) == 1);
    const auto opening = std::ranges::find(labels.is_opening, 1) - labels.is_opening.begin();
    CHECK(areas(labels)[static_cast<std::size_t>(opening)] ==
          Approx(200.0 * 150.0).epsilon(0.03));
    const scenes::TemporaryFolder folder;
    const std::string file = (folder.path / "stones.png").string();
    std::ofstream(file, std::ios::binary) << app::png_of(app::painted_picture(labels));
    const app::Drawing drawing =
        app::read_drawing(file, {.width = 1.0, .height = 1.0, .simplify = 0.004});
    double area = 0.0;
    for (const app::DrawnBlock& b : drawing.blocks)
        for (std::size_t i = 0; i < b.outline.size(); ++i) {
            const dem::Point p = b.outline[i], q = b.outline[(i + 1) % b.outline.size()];
            area += 0.5 * (p.x * q.z - q.x * p.z);
        }
    CHECK(1.0 - area == Approx(200.0 * 150.0 / (720.0 * 720.0)).epsilon(0.05));
    CHECK(static_cast<int>(drawing.blocks.size()) == labels.stones - 1);
}

TEST_CASE("photograph: pictures without stones are refused with what to do",
          "[app][photograph]")
{
    std::mt19937 random(3);
    app::Picture picture{300, 200, std::vector<std::uint8_t>(4 * 300 * 200, 255)};
    const int kind = GENERATE(0, 1, 2); // noise, one colour, a gradient
    for (std::size_t p = 0; p < picture.rgba.size() / 4; ++p)
        for (std::size_t k = 0; k < 3; ++k)
            picture.rgba[4 * p + k] = kind == 0 ? static_cast<std::uint8_t>(random() % 256)
                                      : kind == 1
                                          ? 120
                                          : static_cast<std::uint8_t>(p % 300 * 255 / 300);
    INFO(kind);
    const std::string why = refusal(picture);
    CHECK(why.find("wall.jpg: shows no stones that differ from their mortar") == 0);
    CHECK(why.find("--method threshold, kmeans or watershed") != std::string::npos);
}

TEST_CASE("photograph: a small flat picture loses no method to a piece without pixels",
          "[app][photograph]")
{
    app::Picture picture{200, 150, std::vector<std::uint8_t>(4 * 200 * 150, 255)};
    const auto grey = [](int x, int z) {
        const bool upper = z >= 10 && z <= 60 && x >= 10 && x <= 190 && (x <= 90 || x >= 100),
                   lower = z >= 70 && z <= 140 && x >= 10 && x <= 190 && (x <= 60 || x >= 70);
        return upper || lower ? 255 : 126;
    };
    for (int z = 0; z < 150; ++z)
        for (int x = 0; x < 200; ++x)
            for (int k = 0; k < 3; ++k)
                picture.rgba[4 * (200 * z + x) + k] = static_cast<std::uint8_t>(grey(x, z));
    CHECK(refusal(picture).find("Assertion") == std::string::npos); // of OpenCV
}

TEST_CASE("photograph: EXIF turns it upright", "[app][photograph]")
{
    app::Picture picture{64, 32, std::vector<std::uint8_t>(4 * 64 * 32, 255)};
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 64; ++column) // the upper left quarter is black
            if (row < 16 && column < 32)
                std::fill_n(picture.rgba.data() + 4 * (row * 64 + column), 3, std::uint8_t{0});
    const auto [orientation, x, y] = GENERATE(table<int, int, int>({{1, 0, 0},
                                                                    {2, 1, 0},
                                                                    {3, 1, 1},
                                                                    {4, 0, 1},
                                                                    {5, 0, 0},
                                                                    {6, 1, 0},
                                                                    {7, 1, 1},
                                                                    {8, 0, 1}}));
    INFO(orientation);
    std::string jpeg = scenes::jpeg_of(picture, 95);
    const std::string exif{
        '\xff', '\xe1', 0, 34, 'E', 'x', 'i', 'f', 0, 0,
        'M',    'M',    0, 42, 0,   0,   0,   8,   0, 1,
        1,      0x12,   0, 3,  0,   0,   0,   1,   0, static_cast<char>(orientation),
        0,      0,      0, 0,  0,   0};
    jpeg.insert(2, exif);
    const app::Picture upright = app::read_jpeg(frame(), jpeg);
    CHECK(upright.columns == (orientation < 5 ? 64 : 32));
    CHECK(upright.rows == (orientation < 5 ? 32 : 64));
    const int column = upright.columns / 4 * (2 * x + 1), row = upright.rows / 4 * (2 * y + 1);
    const auto at = [&](int c, int r) {
        return int{upright.rgba[4 * static_cast<std::size_t>(r * upright.columns + c)]};
    };
    CHECK(at(column, row) < 20);
    CHECK(at(upright.columns - 1 - column, row) > 235);
    CHECK(at(column, upright.rows - 1 - row) > 235);
}

TEST_CASE("photograph: broken files are read or refused", "[app][photograph]")
{
    read_broken(40);
}

TEST_CASE("photograph: five hundred broken files are read or refused",
          "[slow][app][photograph]")
{
    read_broken(500);
}
