#include "app/drawing/outlines/drawing_file.hpp"

#include "app/text/config_error.hpp"
#include "app/text/text_file.hpp"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <system_error>

namespace app {

std::string read_drawing_bytes(const std::filesystem::path& path)
{
    constexpr std::size_t kLargest = 64'000'000; // [bytes]; 20 000 blocks take about 10 MB
    std::string bytes =
        read_bytes(path.string(), kLargest, "is larger than 64 MB; draw a part of the wall",
                   "give a drawing: .dxf, .json, .svg or .png");
    if (bytes.empty())
        throw ConfigError(path.string(), 0, "", "is empty; export the drawing again");
    return bytes;
}

std::string readable_name(std::string_view bytes)
{
    const bool utf8 = is_text(bytes);
    std::string name;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) {
            name += ' ';
        } else if (byte < 0x80 || utf8) {
            name += c;
        } else {
            name += static_cast<char>(0xc0 | (byte >> 6));
            name += static_cast<char>(0x80 | (byte & 0x3f));
        }
    }
    return name;
}

std::optional<double> read_number(std::string_view text)
{
    if (text.starts_with('+')) text.remove_prefix(1); // from_chars knows no plus
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace app
