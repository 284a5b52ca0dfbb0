#pragma once
/// Small records in each format, written for the tests: a wave of `n` samples.

#include <string>
#include <vector>

namespace record_texts {

/// Rounded as the formats round: multiples of 0.001 in units of the file.
[[nodiscard]] std::vector<double> wave(int n, double peak);

[[nodiscard]] std::string at2(int n);
[[nodiscard]] std::string old_at2(int n);
[[nodiscard]] std::string columns(int n);
[[nodiscard]] std::string v1(int n);
[[nodiscard]] std::string v2(int n);  ///< two components
[[nodiscard]] std::string v2a(int n); ///< two components
[[nodiscard]] std::string smc(int n);
[[nodiscard]] std::string esm(int n);
[[nodiscard]] std::string cosmos(int n);
/// Counts of 2000 gal / 8388608, from a zero of their own.
[[nodiscard]] std::string knet(int n);
/// Its values: less their mean [gal].
[[nodiscard]] std::vector<double> knet_wave(int n);
[[nodiscard]] std::string usgs(int n);

struct Sample {
    std::string text, format;
    double unit; ///< [m/s2]
    std::size_t components;
    std::vector<double> values; ///< of the first one, in its unit
    double step;                ///< [s]
};
[[nodiscard]] std::vector<Sample> all(int n);

} // namespace record_texts
