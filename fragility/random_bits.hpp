#pragma once
/// Randomness of bootstraps, as an argument.

#include <cstdint>
#include <functional>

namespace fragility {

/// 64 random bits: draw `draw` of replicate `replicate`. A pure function, so that replicates can
/// run in any order.
using RandomBits = std::function<std::uint64_t(std::uint64_t replicate, std::uint64_t draw)>;

/// In (0, 1), never 0 or 1: (k + 1/2) / 2^52.
[[nodiscard]] inline double uniform(std::uint64_t bits)
{
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

/// In 0 .. n - 1, n >= 1; biased by less than n / 2^52.
[[nodiscard]] inline std::uint64_t below(std::uint64_t bits, std::uint64_t n)
{
    const auto k = static_cast<std::uint64_t>(uniform(bits) * static_cast<double>(n));
    return k < n ? k : n - 1;
}

} // namespace fragility
