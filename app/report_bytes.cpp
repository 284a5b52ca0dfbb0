#include "app/report_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <zlib.h>

namespace app {

std::string base64(std::span<const std::uint8_t> bytes)
{
    static constexpr char kDigits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= n ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes)
{
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::uint8_t> out(size);
    if (compress2(out.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), 9) != Z_OK)
        throw std::runtime_error("report: no memory to compress");
    out.resize(size);
    return out;
}

std::vector<std::uint8_t> differences(std::span<const double> numbers, std::size_t length,
                                      double step, int order)
{
    if (!(step > 0.0) || length == 0 || numbers.size() % length != 0)
        throw std::invalid_argument("differences: a positive step and whole series are needed");
    const std::size_t n = numbers.size();
    std::vector<std::uint16_t> v(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double steps = std::isfinite(numbers[i]) ? numbers[i] / step : 0.0;
        v[i] = static_cast<std::uint16_t>(
            static_cast<std::int32_t>(std::lround(std::clamp(steps, -32767.0, 32767.0))));
    }
    for (int pass = 0; pass < order; ++pass)
        for (std::size_t i = n; i-- > 0;)
            if (i % length != 0) v[i] = static_cast<std::uint16_t>(v[i] - v[i - 1]);
    std::vector<std::uint8_t> bytes(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
        bytes[i] = static_cast<std::uint8_t>(v[i] & 0xff);
        bytes[n + i] = static_cast<std::uint8_t>(v[i] >> 8);
    }
    return bytes;
}

} // namespace app
