#include "app/drawing/write_drawing.hpp"
#include "app/text/config_error.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Original {
    std::string name, bytes;
    app::DrawingOptions options;
    int mutations = 0;
};

constexpr std::string_view kPieces[] = {
    "0",    "-1",   "1e308",    "1e-308",    "nan",     "inf",
    "[",    "]",    "{",        "}",         ",",       "\n",
    "\r",   "<",    ">",        "\"",        "</g><g>", "M",
    "z",    "C1 1", "0\nARC\n", "0\nLINE\n", "42\n1\n", "70\n0\n",
    "\xff", "\t",   "&",        "<!--",      "&#0;",    std::string_view("\0", 1)};

std::vector<Original> originals()
{
    const std::vector<scenes::Outline> outlines = scenes::running_bond(3, 3);
    const app::DrawingOptions millimetres{.unit = 1e-3};
    const app::Drawing wall =
        scenes::drawing_of("w.json", scenes::json_text(outlines), millimetres);
    std::string lines, shapes, insertions;
    for (const scenes::Outline& o : outlines) {
        for (std::size_t k = 0; k < 8; k += 2)
            lines += scenes::dxf_line(o[k], o[k + 1], o[(k + 2) % 8], o[(k + 3) % 8]);
        shapes += "<path d=\"M" + std::to_string(o[0]) + "," + std::to_string(-o[1]) + " H" +
                  std::to_string(o[2]) + " V" + std::to_string(-o[5]) + " H" +
                  std::to_string(o[0]) + " Z\"/>\n";
        insertions += "0\nINSERT\n8\n0\n2\nS\n10\n" + std::to_string(o[0]) + "\n20\n" +
                      std::to_string(o[1]) + "\n41\n" + std::to_string(o[2] - o[0]) + "\n";
    }
    const std::string stone = scenes::lwpolyline(scenes::rectangle(0, 0, 1, 100));
    const std::string blocks = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nT\n10\n0\n20\n0\n" + stone +
                               "0\nENDBLK\n0\nBLOCK\n2\nS\n0\nINSERT\n2\nT\n70\n1\n0\nENDBLK\n"
                               "0\nENDSEC\n";
    scenes::Pixels picture = scenes::pixels(48, 40);
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 48; ++column)
            picture.at(column, row) = column % 16 < 2 || row % 10 < 2 ? 0 : 0xffffff;
    return {{"w.json", scenes::json_text(outlines), millimetres, 700},
            {"w.json", app::write_drawing_json(wall.blocks), {}, 300},
            {"w.dxf", app::write_drawing_dxf(wall.blocks, 1e-3), millimetres, 400},
            {"w.dxf", scenes::dxf_text(lines), millimetres, 300},
            {"w.dxf", blocks + scenes::dxf_text(insertions), millimetres, 300},
            {"w.svg",
             "<svg viewBox=\"0 0 600 300\"><g transform=\"translate(0 300)\" id=\"a\">\n" +
                 shapes + "</g></svg>",
             millimetres, 1000},
            {"w.png",
             scenes::png_bytes(picture),
             {.width = 0.6, .height = 0.5, .simplify = 0.01},
             1000}};
}

/// A bit turned, a piece cut off, put in, taken out, doubled or moved, or digits changed.
void mutate(std::string& bytes, std::mt19937& random)
{
    const auto below = [&](std::size_t n) {
        return n == 0 ? 0 : static_cast<std::size_t>(random()) % n;
    };
    const std::size_t at = below(bytes.size() + 1),
                      length = std::min(bytes.size() - at, below(60));
    switch (below(8)) {
    case 0:
        if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
    case 1:
        bytes.resize(at);
        break;
    case 2:
        bytes.insert(at, kPieces[below(std::size(kPieces))]);
        break;
    case 3:
        bytes.erase(at, length);
        break;
    case 4:
        bytes.insert(at, bytes.substr(at, length));
        break;
    case 5:
        bytes.insert(below(bytes.size() + 1), bytes.substr(at, length));
        break;
    default:
        for (char& c : bytes)
            if (c >= '0' && c <= '9' && below(60) == 0) c = static_cast<char>('0' + below(10));
    }
}

/// Checks the promises of every drawing that was read.
void check_promises(const app::Drawing& drawing)
{
    double left = 1e9, bottom = 1e9;
    for (const app::DrawnBlock& block : drawing.blocks) {
        CHECK(scenes::area(block) > 0.0);
        for (const dem::Point& p : block.outline) {
            CHECK((std::isfinite(p.x) && std::isfinite(p.z)));
            left = std::min(left, p.x);
            bottom = std::min(bottom, p.z);
        }
    }
    CHECK(left == 0.0);
    CHECK(bottom == 0.0);
}

} // namespace

TEST_CASE("drawing fuzz: a thousand broken files of each format are read or refused",
          "[app][drawing_fuzz]")
{
    const scenes::TemporaryFolder folder;
    std::mt19937 random(1);
    std::map<std::string, int> read, refused;
    for (const Original& original : originals()) {
        CHECK(scenes::refusal(original.name, original.bytes, original.options) == "read");
        for (int i = 0; i < original.mutations; ++i) {
            std::string bytes = original.bytes;
            for (unsigned n = random() % 3 + 1; n > 0; --n) mutate(bytes, random);
            const std::filesystem::path path = folder.path / original.name;
            std::filesystem::remove(path); // to write over a file waits for the disk
            std::ofstream(path, std::ios::binary) << bytes;
            try {
                check_promises(app::read_drawing(path, original.options));
                ++read[original.name];
            } catch (const app::ConfigError& e) {
                INFO(e.what());
                CHECK(std::string_view(e.what()).starts_with(path.string()));
                ++refused[original.name];
            }
        }
    }
    for (const char* name : {"w.json", "w.dxf", "w.svg", "w.png"}) {
        INFO(name << ": " << read[name] << " read");
        CHECK(read[name] + refused[name] == 1000);
        CHECK(read[name] > 20);
        CHECK(refused[name] > 300);
    }
}

TEST_CASE("drawing fuzz: pictures of noise are walls or refused", "[app][drawing_fuzz]")
{
    std::mt19937 random(2);
    int read = 0;
    for (int i = 0; i < 60; ++i) {
        scenes::Pixels picture = scenes::pixels(30, 20, i % 2 == 0 ? 0xffffff : 0);
        for (int n = 0; n < i; ++n) {
            const int column = static_cast<int>(random() % 30),
                      row = static_cast<int>(random() % 20);
            const int colours[] = {0, 0xffffff, 0x808080, 0x400000, 0x004000};
            picture.fill(column, row, std::min(30, column + static_cast<int>(random() % 12)),
                         std::min(20, row + static_cast<int>(random() % 12)),
                         colours[random() % 5]);
        }
        const app::DrawingOptions options{
            .width = 0.6, .height = 0.4, .simplify = 0.005 * static_cast<double>(random() % 8)};
        const std::string why = scenes::refusal("w.png", scenes::png_bytes(picture), options);
        INFO(why);
        CHECK((why == "read" || why.starts_with("w.png: ")));
        if (why != "read") continue;
        ++read;
        const app::Drawing wall =
            scenes::drawing_of("w.png", scenes::png_bytes(picture), options);
        check_promises(wall);
        CHECK(scenes::area(wall) == Approx(0.24).epsilon(1e-12));
    }
    CHECK(read > 10);
}
