#include "bench/speed/core_speed.hpp"

#include "bench/speed/shortest.hpp"
#include "dem/contact/pack.hpp"

#include <vector>

namespace bench {

double multiply_add_peak()
{
    constexpr int kChains = 12; // two units, four cycles each: 8 at least; 12 fit 16 registers
    constexpr int kRounds = 100'000;
    const dem::Pack a(0.5), b(0.5);
    const double seconds = shortest(40, [&] {
        dem::Pack x[kChains];
        for (int j = 0; j < kChains; ++j) x[j] = dem::Pack(j);
        for (int i = 0; i < kRounds; ++i) {
#pragma GCC unroll 16
            for (int j = 0; j < kChains; ++j) x[j] = multiply_add(a, x[j], b);
        }
        double sum = 0.0;
        for (int j = 0; j < kChains; ++j) sum += dem::lane(x[j], 0);
        asm volatile("" : : "r"(&sum) : "memory"); // the result is used
    });
    return 1.0 * kChains * kRounds * dem::lanes<dem::Pack> / seconds;
}

double sweep_bandwidth(std::size_t bytes)
{
    std::vector<dem::Pack> x(bytes / sizeof(dem::Pack), dem::Pack(1.0));
    const dem::Pack a(0.999);
    const double seconds = shortest(200, [&] {
        for (dem::Pack& value : x) value = a * value;
        asm volatile("" : : "r"(x.data()) : "memory"); // every sweep reaches memory
    });
    return 2.0 * static_cast<double>(x.size() * sizeof(dem::Pack)) / seconds;
}

} // namespace bench
