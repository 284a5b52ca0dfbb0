#pragma once
/// Numbers as bytes and text that a page can carry.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace app {

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

/// zlib stream (RFC 1950), what a browser reads as "deflate".
[[nodiscard]] std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes);

/// Largest size of the numbers that are finite; 0 if there is none.
[[nodiscard]] double largest_size(std::span<const double> numbers);

/// Numbers rounded to multiples of `step`, as 16 bits each, high bytes after low bytes: of a
/// smooth series nearly all of them are 0. Signs are folded in: 0 -1 1 -2 2 are written 0 1 2 3
/// 4.
///   order 0: the numbers   1: differences from the one before   2: differences of these
/// Series begin anew every `length` numbers. Arithmetic modulo 2^16, so that sums give back
/// every number exactly; beyond +-32767 steps it is held at the end.
/// @throws std::invalid_argument if step <= 0 or the numbers do not fill whole series
[[nodiscard]] std::vector<std::uint8_t> differences(std::span<const double> numbers,
                                                    std::size_t length, double step, int order);

} // namespace app
