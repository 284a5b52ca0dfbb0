#pragma once
/// Random scenes of campaigns: the same on every machine.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace bench {

/// std::uniform_*_distribution differs between libraries; this does not.
class Draw {
  public:
    Draw(std::uint64_t seed, std::uint64_t number)
    {
        std::seed_seq words{seed, seed >> 32, number, number >> 32};
        engine_.seed(words);
    }
    [[nodiscard]] double uniform(double low, double high)
    {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    [[nodiscard]] double log_uniform(double low, double high)
    {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    [[nodiscard]] int integer(int low, int high) ///< both ends included
    {
        return std::min(high, low + static_cast<int>(uniform(0.0, high - low + 1.0)));
    }
    [[nodiscard]] bool chance(double share) { return uniform(0.0, 1.0) < share; }
    template <class T> [[nodiscard]] T one_of(std::initializer_list<T> list)
    {
        return list.begin()[integer(0, static_cast<int>(list.size()) - 1)];
    }

  private:
    std::mt19937_64 engine_;
};

} // namespace bench
