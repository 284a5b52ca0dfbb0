#include "app/drawing/write_drawing.hpp"
#include "tests/app/drawing/drawing_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

TEST_CASE(
    "write drawing: a wall written and read again is the same to the last bit, in any unit",
    "[app][write_drawing]")
{
    std::vector<scenes::Outline> outlines = scenes::running_bond(4, 5);
    for (scenes::Outline& outline : outlines)
        for (double& x : outline) x *= 1.0 / 7.0; // no round numbers
    app::Drawing wall =
        scenes::drawing_of("w.json", scenes::json_text(outlines), {.unit = 1e-3});
    wall.blocks[1].layer = "brick \"old\" \xc3\xa9";
    for (const double unit : {1.0, 1e-3, 1e-2}) {
        const app::DrawingOptions options{.unit = unit};
        for (const app::Drawing& again :
             {scenes::drawing_of("w.json", app::write_drawing_json(wall.blocks, unit), options),
              scenes::drawing_of("w.dxf", app::write_drawing_dxf(wall.blocks, unit),
                                 options)}) {
            CHECK(again.notes.empty());
            REQUIRE(again.blocks.size() == wall.blocks.size());
            for (std::size_t i = 0; i < wall.blocks.size(); ++i) {
                const std::vector<dem::Point>&a = wall.blocks[i].outline,
                      &b = again.blocks[i].outline;
                REQUIRE(a.size() == b.size());
                for (std::size_t k = 0; k < a.size(); ++k) {
                    INFO("unit " << unit << ", block " << i << ", corner " << k);
                    if (unit == 1.0) CHECK((a[k].x == b[k].x && a[k].z == b[k].z));
                    CHECK(std::abs(a[k].x - b[k].x) <= 2.3e-16 * a[k].x);
                    CHECK(std::abs(a[k].z - b[k].z) <= 2.3e-16 * a[k].z);
                }
            }
            CHECK((again.blocks[1].layer == wall.blocks[1].layer));
            CHECK((again.blocks[0].layer.empty() || again.blocks[0].layer == "0"));
        }
    }
}

TEST_CASE("write drawing: a DXF says its unit", "[app][write_drawing]")
{
    const app::Drawing wall = scenes::drawing_of(
        "w.json", scenes::json_text(scenes::running_bond(2, 2)), {.unit = 1e-3});
    for (const auto& [unit, code] : {std::pair{1e-3, "4"},
                                     {1e-2, "5"},
                                     {1.0, "6"},
                                     {0.0254, "1"},
                                     {0.3048, "2"},
                                     {0.5, "0"}})
        CHECK(app::write_drawing_dxf(wall.blocks, unit)
                  .find(std::string("$INSUNITS\n70\n") + code + "\n0\nENDSEC") !=
              std::string::npos);
}
