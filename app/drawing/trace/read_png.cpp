#include "app/drawing/outlines/drawing_file.hpp"
#include "app/drawing/trace/picture.hpp"

#include <png.h>

#include <memory>

namespace app {

void check_pixels(const DrawingFrame& frame, std::uint64_t columns, std::uint64_t rows)
{
    constexpr std::uint64_t kMostPixels = 40'000'000;
    if (columns * rows > kMostPixels)
        refuse(frame, 0,
               "has " + std::to_string(columns) + " x " + std::to_string(rows) +
                   " pixels, more than 40 million; make it smaller");
}

Picture read_png(const DrawingFrame& frame, std::string_view bytes)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&image, png_image_free);
    const auto damaged = [&] {
        refuse(frame, 0,
               "is no PNG that can be read (" + readable_name(image.message) +
                   "); save the picture as PNG again");
    };
    if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) damaged();
    check_pixels(frame, image.width, image.height);
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    image.format = PNG_FORMAT_RGBA;
    picture.rgba.resize(PNG_IMAGE_SIZE(image));
    if (!png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr)) damaged();
    return picture;
}

} // namespace app
