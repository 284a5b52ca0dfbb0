#include "app/drawing/outlines/drawing_file.hpp"
#include "app/photograph/exif_turn.hpp"
#include "app/photograph/photograph.hpp"

#include <turbojpeg.h>

#include <cstdint>
#include <memory>

namespace app {

Picture read_jpeg(const DrawingFrame& frame, std::string_view bytes)
{
    const std::unique_ptr<void, decltype(&tjDestroy)> reader(tjInitDecompress(), tjDestroy);
    const auto damaged = [&] {
        refuse(frame, 0,
               "is no JPEG that can be read (" + readable_name(tjGetErrorStr2(reader.get())) +
                   "); save the photograph as JPEG or PNG again");
    };
    const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
    int width = 0, height = 0, sampling = 0, space = 0;
    if (tjDecompressHeader3(reader.get(), data, bytes.size(), &width, &height, &sampling,
                            &space) != 0)
        damaged();
    check_pixels(frame, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
    Picture picture{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
    // a warning, as of a file that was cut off, leaves a picture to look at
    if (tjDecompress2(reader.get(), data, bytes.size(), picture.rgba.data(), width, 0, height,
                      TJPF_RGBA, 0) != 0 &&
        tjGetErrorCode(reader.get()) == TJERR_FATAL)
        damaged();
    return turned(std::move(picture), exif_orientation(bytes));
}

} // namespace app
