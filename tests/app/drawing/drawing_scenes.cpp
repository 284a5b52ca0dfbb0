#include "tests/app/drawing/drawing_scenes.hpp"

#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "scenes/temporary_folder.hpp"

#include <png.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>
#include <tuple>

namespace scenes {

Outline rectangle(double left, double bottom, double right, double top)
{
    return {left, bottom, right, bottom, right, top, left, top};
}

app::Drawing drawing_of(const std::string& name, std::string_view text,
                        const app::DrawingOptions& options)
{
    const TemporaryFolder folder;
    std::ofstream(folder.path / name, std::ios::binary) << text;
    return app::read_drawing(folder.path / name, options);
}

std::string refusal(const std::string& name, std::string_view text,
                    const app::DrawingOptions& options)
{
    try {
        (void)drawing_of(name, text, options);
    } catch (const app::ConfigError& e) {
        const std::string what = e.what();
        const std::size_t at = what.find(name);
        return at == std::string::npos ? what : what.substr(at);
    }
    return "read";
}

std::string json_text(const std::vector<Outline>& outlines)
{
    std::string text = "{\"blocks\": [";
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        text += i == 0 ? "\n[" : ",\n[";
        for (std::size_t k = 0; k + 1 < outlines[i].size(); k += 2)
            text += (k == 0 ? "[" : ", [") + app::number(outlines[i][k], 17) + ", " +
                    app::number(outlines[i][k + 1], 17) + "]";
        text += "]";
    }
    return text + "\n]}\n";
}

std::string dxf_text(const std::string& entities)
{
    return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

std::string lwpolyline(const Outline& outline, bool closed, const std::string& layer)
{
    std::string text = "0\nLWPOLYLINE\n8\n" + layer + "\n90\n" +
                       std::to_string(outline.size() / 2) + "\n70\n" + (closed ? "1" : "0") +
                       "\n";
    for (std::size_t k = 0; k + 1 < outline.size(); k += 2)
        text += "10\n" + app::number(outline[k], 17) + "\n20\n" +
                app::number(outline[k + 1], 17) + "\n";
    return text;
}

std::string dxf_line(double x, double y, double to_x, double to_y, const std::string& layer)
{
    return "0\nLINE\n8\n" + layer + "\n10\n" + app::number(x, 17) + "\n20\n" +
           app::number(y, 17) + "\n11\n" + app::number(to_x, 17) + "\n21\n" +
           app::number(to_y, 17) + "\n";
}

std::vector<Outline> running_bond(int units, int courses)
{
    std::vector<Outline> blocks;
    for (int c = 0; c < courses; ++c) {
        std::vector<double> joints{0.0};
        for (int u = 0; u <= units; ++u) {
            const double x = 200.0 * u + (c % 2 == 1 ? 100.0 : 0.0);
            if (x > joints.back()) joints.push_back(std::min(x, 200.0 * units));
        }
        for (std::size_t j = 0; j + 1 < joints.size(); ++j)
            if (joints[j + 1] > joints[j])
                blocks.push_back(
                    rectangle(joints[j], 100.0 * c, joints[j + 1], 100.0 * (c + 1)));
    }
    return blocks;
}

Pixels pixels(int columns, int rows, int colour)
{
    return {columns, rows, std::vector<int>(static_cast<std::size_t>(columns * rows), colour)};
}

void Pixels::fill(int left, int top, int right, int bottom, int value)
{
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) at(column, row) = value;
}

std::string png_bytes(const Pixels& picture)
{
    std::vector<unsigned char> rgb;
    for (const int c : picture.colour)
        for (const int shift : {16, 8, 0})
            rgb.push_back(static_cast<unsigned char>(c >> shift & 0xff));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.columns);
    image.height = static_cast<png_uint_32>(picture.rows);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    if (!png_image_write_to_memory(&image, nullptr, &size, 0, rgb.data(), 0, nullptr))
        throw std::runtime_error(image.message);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr))
        throw std::runtime_error(image.message);
    return bytes;
}

double area(const app::DrawnBlock& block)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < block.outline.size(); ++i) {
        const dem::Point a = block.outline[i],
                         b = block.outline[(i + 1) % block.outline.size()];
        twice += a.x * b.z - a.z * b.x;
    }
    return twice / 2.0;
}

double area(const app::Drawing& drawing)
{
    double sum = 0.0;
    for (const app::DrawnBlock& block : drawing.blocks) sum += area(block);
    return sum;
}

int common_sides(const app::Drawing& drawing)
{
    std::map<std::tuple<double, double, double, double>, int> sides;
    int common = 0;
    for (const app::DrawnBlock& block : drawing.blocks)
        for (std::size_t i = 0; i < block.outline.size(); ++i) {
            const dem::Point a = block.outline[i],
                             b = block.outline[(i + 1) % block.outline.size()];
            common += sides.contains({b.x, b.z, a.x, a.z}) ? 1 : 0;
            sides[{a.x, a.z, b.x, b.z}] = 1;
        }
    return common;
}

bool notes(const app::Drawing& drawing, std::string_view text)
{
    for (const std::string& note : drawing.notes)
        if (note.find(text) != std::string::npos) return true;
    return false;
}

} // namespace scenes
