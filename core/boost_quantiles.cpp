#include "core/boost_quantiles.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>

namespace core {

double beta_probability(double a, double b, double x) { return boost::math::ibeta(a, b, x); }

double beta_quantile(double a, double b, double p) { return boost::math::ibeta_inv(a, b, p); }

double upper_beta_quantile(double a, double b, double q)
{
    return boost::math::ibetac_inv(a, b, q);
}

double upper_student_quantile(double freedom, double q)
{
    const boost::math::students_t t(freedom);
    return boost::math::quantile(boost::math::complement(t, q));
}

} // namespace core
