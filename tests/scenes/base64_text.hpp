#pragma once
/// Base64 read back, for tests of what a page carries.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenes {

/// RFC 4648; stops at the padding.
inline std::vector<std::uint8_t> bytes_of_base64(std::string_view text)
{
    const std::string digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos) break;
        group = group << 6 | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<std::uint8_t>(group >> bits & 0xff));
    }
    return bytes;
}

} // namespace scenes
