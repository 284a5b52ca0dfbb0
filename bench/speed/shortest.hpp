#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace bench {

/// Shortest of several runs [s]: what is left of the rest of the machine is not in it.
template <class F> [[nodiscard]] double shortest(int repeats, F run)
{
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < repeats; ++i) {
        const auto start = std::chrono::steady_clock::now();
        run();
        best = std::min(
            best,
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

} // namespace bench
