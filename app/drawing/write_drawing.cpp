#include "app/drawing/write_drawing.hpp"

#include "app/drawing/outlines/drawing_file.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace app {
namespace {

/// As few digits as give back the same length, in a unit other than the metre to the last bit
/// but one: 0.6 m are 600 mm.
std::string in_units(double metres, double unit)
{
    constexpr double kLastBit = 2.3e-16; // of 1 [-]
    const double value = metres / unit, most = unit == 1.0 ? 0.0 : kLastBit * std::abs(metres);
    int digits = kAfterUnits;
    while (digits < 17 && std::abs(rounded(value, digits) * unit - metres) > most) ++digits;
    return number(value, digits);
}

/// $INSUNITS of the DXF reference of Autodesk; 0: none of its units.
int inserted_unit_code(double unit)
{
    constexpr std::array<std::pair<int, double>, 5> kCodes{
        {{1, 0.0254}, {2, 0.3048}, {4, 1e-3}, {5, 1e-2}, {6, 1.0}}};
    for (const auto& [code, length] : kCodes)
        if (std::abs(unit / length - 1.0) < 1e-9) return code;
    return 0;
}

} // namespace

std::string write_drawing_json(std::span<const DrawnBlock> blocks, double unit)
{
    std::string text = "{\"blocks\": [";
    for (const DrawnBlock& block : blocks) {
        text += &block == &blocks.front() ? "\n{" : ",\n{";
        if (!block.layer.empty())
            text += "\"layer\": " + text_of(readable_name(block.layer)) + ", ";
        text += "\"outline\": [";
        for (const dem::Point& p : block.outline) {
            text += &p == &block.outline.front() ? "[" : ", [";
            text += in_units(p.x, unit) + ", " + in_units(p.z, unit) + "]";
        }
        text += "]}";
    }
    return text + "\n]}\n";
}

std::string write_drawing_dxf(std::span<const DrawnBlock> blocks, double unit)
{
    std::string text = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n" +
                       std::to_string(inserted_unit_code(unit)) +
                       "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    for (const DrawnBlock& block : blocks) {
        const std::string layer = block.layer.empty() ? "0" : readable_name(block.layer);
        text += "0\nPOLYLINE\n8\n" + layer + "\n66\n1\n10\n0.0\n20\n0.0\n30\n0.0\n70\n1\n";
        for (const dem::Point& p : block.outline) {
            text += "0\nVERTEX\n8\n" + layer + "\n10\n" + in_units(p.x, unit) + "\n20\n" +
                    in_units(p.z, unit) + "\n30\n0.0\n";
        }
        text += "0\nSEQEND\n8\n" + layer + "\n";
    }
    return text + "0\nENDSEC\n0\nEOF\n";
}

} // namespace app
