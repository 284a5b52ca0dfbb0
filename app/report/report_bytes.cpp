#include "app/report/report_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <zlib.h>

namespace app {
namespace {

// Films of the paper's walls, kB each and ms to deflate: level 4: 6.9, 0.5; 6: 6.7, 1.1; 9:
// 6.7, 5.1. Without the fold of differences(): 4: 10.1, 0.8; 6: 9.5, 2.2; 9: 9.3, 24.
constexpr int kLevel = 6;

/// 0 -1 1 -2 2 ... become 0 1 2 3 4 ...
std::uint16_t folded(std::uint16_t v)
{
    return static_cast<std::uint16_t>(v << 1 ^ (v >> 15 != 0 ? 0xffff : 0));
}

} // namespace

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
    z_stream z{};
    if (deflateInit2(&z, kLevel, Z_DEFLATED, 15, 8, Z_FILTERED) != Z_OK)
        throw std::runtime_error("report: no memory to compress");
    std::vector<std::uint8_t> out(deflateBound(&z, static_cast<uLong>(bytes.size())));
    z.next_in = const_cast<Bytef*>(bytes.data()); // only read
    z.avail_in = static_cast<uInt>(bytes.size());
    z.next_out = out.data();
    z.avail_out = static_cast<uInt>(out.size());
    const int outcome = deflate(&z, Z_FINISH);
    out.resize(z.total_out);
    deflateEnd(&z);
    if (outcome != Z_STREAM_END) throw std::runtime_error("report: cannot compress");
    return out;
}

double largest_size(std::span<const double> numbers)
{
    double largest = 0.0;
    for (const double x : numbers)
        if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
    return largest;
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
        const std::uint16_t f = folded(v[i]);
        bytes[i] = static_cast<std::uint8_t>(f & 0xff);
        bytes[n + i] = static_cast<std::uint8_t>(f >> 8);
    }
    return bytes;
}

} // namespace app
