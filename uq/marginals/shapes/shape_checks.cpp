#include "uq/marginals/shapes/shape_checks.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

void refuse(const char* what, double value, const char* allowed)
{
    std::array<char, 32> digits{}; // as few as tell the value apart
    std::to_chars(digits.data(), digits.data() + digits.size(), value);
    throw std::invalid_argument(std::string(what) + " is " + digits.data() +
                                "; allowed: " + allowed);
}

void require_finite(const char* what, double value)
{
    if (!std::isfinite(value)) refuse(what, value, "a finite number");
}

void require_positive(const char* what, double value)
{
    if (!(value > 0.0 && std::isfinite(value))) refuse(what, value, "> 0, finite");
}

void require_ends(const char* what, double lower, double upper)
{
    require_finite(what, lower);
    require_finite(what, upper);
    if (!(lower < upper)) refuse(what, upper, "above the lower end");
    require_finite(what, upper - lower);
}

void require_moments(const char* shape, double mean, double cov)
{
    const std::string name(shape);
    require_finite((name + ": mean").c_str(), mean);
    if (mean == 0.0)
        refuse((name + ": mean").c_str(), mean,
               "not 0, a coefficient of variation scales by it");
    if (!(cov > 0.0 && std::isfinite(cov)))
        refuse((name + ": coefficient of variation").c_str(), cov, "> 0");
}

void require_positive_moments(const char* shape, double mean, double cov)
{
    require_moments(shape, mean, cov);
    if (!(mean > 0.0)) refuse((std::string(shape) + ": mean").c_str(), mean, "> 0");
}

} // namespace uq
