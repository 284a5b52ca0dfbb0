#pragma once
/// As gsl_cdf.h beside it.

#include <cmath>

inline double gsl_sf_lngamma(double x) { return std::lgamma(x); }
