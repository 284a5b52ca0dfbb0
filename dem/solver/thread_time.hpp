#pragma once
/// The processor time of the calling thread, which measures the cost of a run whatever else the
/// machine does.

#include <ctime>

namespace dem {

/// Processor time of this thread since some fixed moment [s].
inline double thread_seconds()
{
    timespec t{};
#if defined(__wasm__)
    clock_gettime(CLOCK_MONOTONIC, &t); // threads have no clock of their own there
#else
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
#endif
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

} // namespace dem
