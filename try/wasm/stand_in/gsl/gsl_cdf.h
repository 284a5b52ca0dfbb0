#pragma once
/// Stands in for the GNU Scientific Library, which has no build for WebAssembly: the functions that
/// draws of walls call, by the standard library.

#include <cmath>
#include <numbers>

inline double gsl_cdf_ugaussian_P(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }
inline double gsl_cdf_ugaussian_Q(double x) { return 0.5 * std::erfc(x / std::numbers::sqrt2); }
