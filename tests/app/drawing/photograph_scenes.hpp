#pragma once
/// Photographs of a wall of rubble that the program itself grows, so that its stones are known.

#include "app/drawing/trace/picture.hpp"

#include <array>
#include <string>

namespace scenes {

/// The stones of the wall, with mortar between them.
[[nodiscard]] app::Labels rubble_truth();

using Colour = std::array<double, 3>; ///< red, green, blue, of 255

/// How a photograph differs from a drawing.
struct Look {
    std::string name;
    Colour mortar = {70, 65, 60};
    std::array<Colour, 4> stones = {
        {{170, 150, 120}, {185, 165, 140}, {150, 135, 110}, {165, 150, 135}}};
    double spread = 0.0; ///< of the brightness of stones, standard deviation, of 255
    double blur = 0.0;   ///< [pixels]
    double dark = 1.0;   ///< brightness at the left side beside that at the right
    double noise = 0.0;  ///< standard deviation, of 255
    int quality = 90;    ///< of the JPEG file
};

/// Taken of the stones, the same in every run.
[[nodiscard]] app::Picture photograph_of(const app::Labels& truth, const Look& look);

/// The bytes of a JPEG file.
[[nodiscard]] std::string jpeg_of(const app::Picture& picture, int quality);

} // namespace scenes
