#include "app/photograph/stones_picture.hpp"

#include <algorithm>
#include <cstddef>

namespace app {
namespace {

void paint(Picture& picture, std::size_t pixel, int colour)
{
    std::uint8_t* const p = picture.rgba.data() + 4 * pixel;
    for (int k = 0; k < 3; ++k) p[k] = static_cast<std::uint8_t>(colour >> (16 - 8 * k) & 255);
    p[3] = 255;
}

/// No two of 262 144 stones have the same colour; none is black, or that of openings.
int colour_of_stone(int stone)
{
    constexpr unsigned kColours = 1U << 18;
    constexpr unsigned kOdd = 0x2c1b5; // odd: every number comes once
    const unsigned n = (static_cast<unsigned>(stone) + 1U) * kOdd % kColours;
    int colour = 0;
    for (int k = 0; k < 3; ++k)
        colour = colour << 8 | (64 + 3 * static_cast<int>(n >> 6 * k & 63));
    return colour;
}

} // namespace

Picture painted_picture(const Labels& labels)
{
    Picture picture{labels.columns, labels.rows,
                    std::vector<std::uint8_t>(4 * labels.label.size())};
    for (std::size_t p = 0; p < labels.label.size(); ++p) {
        const int l = labels.label[p];
        paint(picture, p,
              l == kMortar           ? 0
              : labels.is_opening[l] ? kOpeningColour
                                     : colour_of_stone(l));
    }
    return picture;
}

Picture found_picture(const FoundStones& found)
{
    constexpr int kBorder = 0xff2020;
    const Labels& labels = found.labels;
    Picture picture = found.photograph;
    for (std::size_t p = 0; p < labels.label.size(); ++p) {
        const int l = labels.label[p];
        bool border = false;
        visit_neighbours(labels, p, [&](std::size_t q) { border |= labels.label[q] != l; });
        if (l == kMortar) // darker, so that stones stand out
            for (int k = 0; k < 3; ++k) picture.rgba[4 * p + k] /= 2;
        if (l != kMortar && border) paint(picture, p, kBorder);
    }
    return picture;
}

} // namespace app
