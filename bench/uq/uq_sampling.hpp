#pragma once
/// Designs and what they are timed against.

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <string>
#include <vector>

namespace bench {

constexpr int kManySamples = 10000,
              kManyVariables = 185;                ///< a value for each joint of the wall
constexpr int kFewSamples = 50, kFewVariables = 5; ///< the paper's

/// Alternating normal (mean 1, cov 0.25) and lognormal (mean 3.7, cov 0.30).
constexpr double kNormalMean = 1.0, kNormalCov = 0.25, kLognormalMean = 3.7,
                 kLognormalCov = 0.30;

/// Median CPU time of the whole process [ms]: threads cannot hide work.
template <class F> [[nodiscard]] double median_cpu_ms(int repeats, F run)
{
    std::vector<double> ms;
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t start = std::clock();
        run(i);
        ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    const auto middle = ms.begin() + static_cast<std::ptrdiff_t>(ms.size() / 2);
    std::nth_element(ms.begin(), middle, ms.end());
    return *middle;
}

struct SamplingTimes {
    std::string name;                                           ///< empty: not installed
    double few_latin, many_latin, many_independent, many_sobol; ///< [ms], in physical units
    double spread;                                              ///< [ms], 50 x 5 optimised
    Eigen::VectorXd distance; ///< smallest of each optimised design
};

/// The same of OpenTURNS, on one thread.
[[nodiscard]] SamplingTimes openturns_times(int repeats);

} // namespace bench
