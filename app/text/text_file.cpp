#include "app/text/text_file.hpp"

#include "app/text/config_error.hpp"

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace app {
namespace {

constexpr std::size_t kLargest = 1 << 20; // [bytes]; a study has a few thousand

/// Bytes of the character that starts at text[0], 0 if it is malformed (Unicode 15, table 3-7).
std::size_t character_length(std::string_view text)
{
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto in = [](unsigned b, unsigned low, unsigned high) {
        return low <= b && b <= high;
    };
    const unsigned b = byte(0);
    if (in(b, 0x01, 0x7f)) return 1;
    if (in(b, 0xc2, 0xdf)) return in(byte(1), 0x80, 0xbf) ? 2 : 0;
    if (in(b, 0xe0, 0xef)) {
        const bool second = in(byte(1), b == 0xe0 ? 0xa0 : 0x80, b == 0xed ? 0x9f : 0xbf);
        return second && in(byte(2), 0x80, 0xbf) ? 3 : 0;
    }
    if (in(b, 0xf0, 0xf4)) {
        const bool second = in(byte(1), b == 0xf0 ? 0x90 : 0x80, b == 0xf4 ? 0x8f : 0xbf);
        return second && in(byte(2), 0x80, 0xbf) && in(byte(3), 0x80, 0xbf) ? 4 : 0;
    }
    return 0;
}

} // namespace

bool is_text(std::string_view bytes)
{
    while (!bytes.empty()) {
        const std::size_t n = character_length(bytes);
        if (n == 0) return false;
        bytes.remove_prefix(n);
    }
    return true;
}

std::string read_bytes(const std::string& path, std::size_t most, const std::string& too_large,
                       const std::string& remedy)
{
    const auto refuse = [&](const std::string& why) { throw ConfigError(path, 0, "", why); };
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) refuse("is a directory; " + remedy);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const int cause = errno;
    if (!file)
        refuse("cannot be read (" + std::generic_category().message(cause) + "); " + remedy);
    std::string bytes, piece(1 << 16, '\0'); // bounded: a device cannot fill the memory
    while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())),
           file.gcount() > 0) {
        bytes.append(piece, 0, static_cast<std::size_t>(file.gcount()));
        if (bytes.size() > most) refuse(too_large);
    }
    if (file.bad()) refuse("cannot be read to its end");
    return bytes;
}

std::string read_small_file(const std::string& path)
{
    return read_bytes(path, kLargest, "is larger than 1 MiB; this is no study file",
                      "give a study file, such as configs/wall.ini");
}

} // namespace app
