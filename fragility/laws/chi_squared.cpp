#include "fragility/laws/chi_squared.hpp"

#include <boost/math/special_functions/gamma.hpp>

namespace fragility {

double chi_squared_survival(double x, double freedom)
{
    return boost::math::gamma_q(0.5 * freedom, 0.5 * x);
}

} // namespace fragility
