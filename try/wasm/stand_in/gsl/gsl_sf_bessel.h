#pragma once
/// As gsl_cdf.h beside it.

#include <boost/math/special_functions/bessel.hpp>

#include <cmath>

inline double gsl_sf_bessel_lnKnu(double nu, double x)
{
    return std::log(boost::math::cyl_bessel_k(nu, x));
}
