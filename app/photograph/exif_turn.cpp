#include "app/photograph/exif_turn.hpp"

#include <cstddef>
#include <cstring>
#include <utility>

namespace app {
namespace {

/// Whole numbers of a file of either order of bytes; 0 beyond its end.
struct Numbers {
    std::string_view bytes;
    bool little = false;

    [[nodiscard]] std::size_t at(std::size_t place, std::size_t length) const
    {
        if (place > bytes.size() || bytes.size() - place < length) return 0;
        std::size_t n = 0;
        for (std::size_t i = 0; i < length; ++i) {
            const std::size_t k = place + (little ? length - 1 - i : i);
            n = n << 8 | static_cast<unsigned char>(bytes[k]);
        }
        return n;
    }
};

/// The part of a JPEG file that holds its EXIF; empty if there is none.
std::string_view exif_of(std::string_view jpeg)
{
    using namespace std::string_view_literals;
    const Numbers numbers{jpeg};
    std::size_t at = 2;
    while (numbers.at(at, 1) == 0xff && numbers.at(at + 1, 1) != 0xda) { // until the pixels
        const std::size_t length = numbers.at(at + 2, 2);
        if (length < 2 || length > jpeg.size() - at - 2) break;
        const std::string_view part = jpeg.substr(at + 4, length - 2);
        if (numbers.at(at + 1, 1) == 0xe1 && part.starts_with("Exif\0\0"sv))
            return part.substr(6);
        at += 2 + length;
    }
    return {};
}

} // namespace

int exif_orientation(std::string_view jpeg)
{
    constexpr std::size_t kEntry = 12; // bytes
    const Numbers numbers{exif_of(jpeg), exif_of(jpeg).starts_with("II")};
    const std::size_t table = numbers.at(4, 4), entries = numbers.at(table, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = table + 2 + kEntry * i;
        if (numbers.at(entry, 2) != 0x0112) continue;
        const std::size_t value = numbers.at(entry + 8, 2);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

Picture turned(Picture picture, int orientation)
{
    if (orientation == 1) return picture;
    const bool lying = orientation >= 5;
    const int w = picture.columns, h = picture.rows;
    const bool flip_x =
                   orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8,
               flip_y =
                   orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Picture seen{lying ? h : w, lying ? w : h, std::vector<std::uint8_t>(picture.rgba.size())};
    std::uint8_t* to = seen.rgba.data();
    for (int row = 0; row < seen.rows; ++row)
        for (int column = 0; column < seen.columns; ++column, to += 4) {
            const int x = lying ? row : column,
                      y = lying ? column : row; // before it is flipped
            const std::size_t from = static_cast<std::size_t>(flip_y ? h - 1 - y : y) * w +
                                     static_cast<std::size_t>(flip_x ? w - 1 - x : x);
            std::memcpy(to, picture.rgba.data() + 4 * from, 4);
        }
    return seen;
}

} // namespace app
