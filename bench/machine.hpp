#pragma once
/// Machine that a measurement ran on: it stands above every table of timings.

#include <string>

namespace bench {

/// Processor, cores, compiler and flags, registers: "Intel(R) Xeon(R) Processor (family 6,
/// model 207), 2 cores, g++ 12.2.0 -O3 ..., AVX-512 (8 lanes)"
[[nodiscard]] std::string machine_line();

/// The command that this process was started with, to be shown under "Written by":
/// "build/release/bench/kernel docs/bench/speed/kernel.md". Folders above build/ are left out.
[[nodiscard]] std::string command_line();

/// Caches of the first core, as the system names them: "L1d 48K, L2 2048K, L3 266240K". Empty
/// where it does not.
[[nodiscard]] std::string cache_line();

/// Largest resident set of this process since the start or the last reset [MB]; 0 where
/// unknown.
[[nodiscard]] double peak_memory_mb();

/// Forgets the peak. False: not allowed, the peak stands.
bool reset_peak_memory();

} // namespace bench
