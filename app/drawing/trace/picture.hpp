#pragma once
/// Pictures of stones: pixels, and which stone each belongs to. Rows count from the top.

#include "app/drawing/outlines/raw_drawing.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct Picture {
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> rgba; ///< four bytes per pixel, row by row
};

/// @throws ConfigError if there are more than 40 million pixels
void check_pixels(const DrawingFrame& frame, std::uint64_t columns, std::uint64_t rows);

/// @throws ConfigError if it is no PNG, is damaged, or has more than 40 million pixels
[[nodiscard]] Picture read_png(const DrawingFrame& frame, std::string_view bytes);

/// The same pixels as a PNG file.
[[nodiscard]] std::string png_of(const Picture& picture);

constexpr int kMortar = -1;              ///< label of what is no stone
constexpr int kOpeningColour = 0xff00ff; ///< magenta: a door, a window, or no wall at all

/// Stones are numbered from 0 in the order of their first pixels.
struct Labels {
    int columns = 0, rows = 0, stones = 0;
    std::vector<int> label;       ///< of each pixel, row by row
    std::vector<char> is_opening; ///< of each stone: it is an opening, and no stone

    [[nodiscard]] std::size_t pixel(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    /// kMortar outside of the picture.
    [[nodiscard]] int at(int column, int row) const
    {
        const bool inside = column >= 0 && column < columns && row >= 0 && row < rows;
        return inside ? label[pixel(column, row)] : kMortar;
    }
};

/// Calls visit(index) for the pixels beside pixel p.
template <class Visit>
void visit_neighbours(const Labels& labels, std::size_t p, const Visit& visit)
{
    const auto columns = static_cast<std::size_t>(labels.columns);
    if (p % columns > 0) visit(p - 1);
    if (p % columns + 1 < columns) visit(p + 1);
    if (p >= columns) visit(p - columns);
    if (p + columns < labels.label.size()) visit(p + columns);
}

/// The connected pixels of one kind that `first` is one of. Those that are seen are passed
/// over, and these are seen then.
/// @param kind of each pixel
[[nodiscard]] std::vector<std::size_t> connected(const Labels& labels,
                                                 const std::vector<int>& kind,
                                                 std::size_t first, std::vector<char>& seen);

/// Size of a pixel.
struct PixelSize {
    double width = 0.0, height = 0.0; ///< [m]
};

/// The stones of a picture. A grey picture of two greys (docs/drawings.md) has bright stones on
/// dark mortar; in any other, each connected area of one colour is a stone, and black and
/// transparent pixels are mortar. In both, areas of the colour of openings are openings. Areas
/// smaller than `dirt` become mortar. Notes say what was understood.
/// @param dirt [m2]
/// @throws ConfigError if there are no stones, or too many
[[nodiscard]] Labels find_stones(const DrawingFrame& frame, const Picture& picture,
                                 PixelSize pixel, double dirt, std::vector<std::string>& notes);

/// Where stones are painted.
struct Painted {
    int columns = 0, rows = 0;
    std::vector<char> stone; ///< of each pixel, row by row
};
[[nodiscard]] Painted painted_stones(const Labels& labels);

/// The distance of a point from the nearest pixel of a stone [m].
/// @param at from the lower left corner of the picture [m]
[[nodiscard]] double distance_to_stone(const Painted& painted, PixelSize pixel, dem::Point at);

/// Stones grow over the mortar: each pixel goes to the stone nearest to its centre. Each stone
/// is one piece afterwards, its pixels connected through their sides. Openings do not grow.
/// @param labels with one stone at least
[[nodiscard]] Labels grow_stones(Labels labels, PixelSize pixel);

} // namespace app
