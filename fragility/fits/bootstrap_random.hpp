#pragma once
/// Random numbers for bootstraps, passed as an argument.

#include <cstdint>
#include <functional>

namespace fragility {

/// 64 random bits: draw `draw` of replicate `replicate`. A pure function, so that replicates
/// can run in any order.
using RandomBits = std::function<std::uint64_t(std::uint64_t replicate, std::uint64_t draw)>;

/// A number in (0, 1), never 0 or 1: (k + 1/2) / 2^52.
[[nodiscard]] inline double uniform(std::uint64_t bits)
{
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

} // namespace fragility
