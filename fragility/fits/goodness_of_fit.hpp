#pragma once
/// Distances of the data from a fitted law, and how often data drawn from that law lie further
/// away.

#include "fragility/fits/bootstrap_random.hpp"
#include "fragility/fits/censored_fit.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace fragility {

/// Distances between empirical and fitted distribution, up to the highest value of all. With
/// right-censored values the empirical distribution is Kaplan and Meier's; stopped at one
/// common value this is Pettitt and Stephens (1976, Biometrika 63, 291-298).
struct Distances {
    double kolmogorov_smirnov = 0.0; ///< D: largest difference
    double cramer_von_mises = 0.0;   ///< W^2: n times the mean squared difference
    double anderson_darling = 0.0;   ///< A^2: the same, weighed by 1 / (F (1 - F))
    double two_heaps =
        0.0; ///< H: see fragility/fits/two_heaps.hpp; 0 where a value is censored
};

/// Nothing is returned for data with left- or interval-censored values, with weights other than
/// 1, or without an observed value.
[[nodiscard]] std::optional<Distances> distances(const Distribution& law,
                                                 std::span<const Observation> data);

/// Walls drawn behind one p-value, at most: of many walls fewer samples are drawn, and not
/// fewer than kFewestReplicates, which tell p < 0.01.
constexpr std::size_t kMostDraws = 10'000'000;
constexpr std::size_t kFewestReplicates = 199;

/// p: share of samples of the fitted law, refitted, that lie further away. Since the parameters
/// are fitted, tables for given parameters do not hold (Lilliefors 1967).
struct GoodnessOfFit {
    bool available = false;
    std::string reason; ///< why not
    Distances distance;
    double p_kolmogorov_smirnov = 0.0; ///< in (0, 1], (k + 1) / (replicates + 1)
    double p_cramer_von_mises = 0.0;
    double p_anderson_darling = 0.0;
    double p_two_heaps = 1.0;   ///< 1 where a value is censored
    std::size_t replicates = 0; ///< that could be fitted
    std::size_t failed = 0;
};

constexpr double kRejected = 0.01; ///< level of each of the tests [-]

/// The smallest p-value of the tests; 1 without tests.
[[nodiscard]] double least_p(const GoodnessOfFit& tests);

/// @param seen told how far it is after each sample [0 to 1], if given
[[nodiscard]] GoodnessOfFit goodness_of_fit(const Fit& fit, std::span<const Observation> data,
                                            const RandomBits& bits,
                                            std::size_t replicates = 1000,
                                            const std::function<void(double)>& seen = {});

} // namespace fragility
