#pragma once
/// Highest speeds of one core: the roofs a kernel is held against.

#include <cstddef>

namespace bench {

/// Multiply-adds per second in registers of doubles, all lanes counted: independent chains,
/// best of many short repeats.
[[nodiscard]] double multiply_add_peak();

/// Bytes per second read and written by x = a x over a working set, best of many sweeps.
[[nodiscard]] double sweep_bandwidth(std::size_t bytes);

} // namespace bench
