#include "app/drawing/trace/picture.hpp"

#include <png.h>

#include <stdexcept>

namespace app {

std::string png_of(const Picture& picture)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.columns);
    image.height = static_cast<png_uint_32>(picture.rows);
    image.format = PNG_FORMAT_RGBA;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgba.data(), 0,
                                   nullptr))
        throw std::runtime_error(std::string("a picture cannot be written: ") + image.message);
    bytes.resize(size);
    return bytes;
}

} // namespace app
