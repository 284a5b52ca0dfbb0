#include "uq/marginals/shapes/uniform.hpp"

#include "uq/marginals/shapes/shape_checks.hpp"

#include <numbers>

namespace uq {

void check(const Uniform& s) { require_ends("uniform: upper end", s.lower, s.upper); }

Range support(const Uniform& s) { return {s.lower, s.upper}; }
double density(const Uniform& s, double) { return 1.0 / (s.upper - s.lower); }
double lower_tail(const Uniform& s, double x)
{
    if (x <= s.lower) return 0.0;
    return x >= s.upper ? 1.0 : (x - s.lower) / (s.upper - s.lower);
}
double upper_tail(const Uniform& s, double x)
{
    if (x <= s.lower) return 1.0;
    return x >= s.upper ? 0.0 : (s.upper - x) / (s.upper - s.lower);
}
double at_lower(const Uniform& s, double p) { return s.lower + p * (s.upper - s.lower); }
double at_upper(const Uniform& s, double q) { return s.upper - q * (s.upper - s.lower); }
MeanSd mean_sd(const Uniform& s)
{
    return {s.lower + 0.5 * (s.upper - s.lower),
            (s.upper - s.lower) / (2.0 * std::numbers::sqrt3)};
}

std::span<const ShapeForm<Uniform>> forms(const Uniform*)
{
    static constexpr ShapeForm<Uniform> all[] = {
        {{{{"lower"}, {"upper"}}}, [](const double* p) {
             return Uniform{p[0], p[1]};
         }}};
    return all;
}

} // namespace uq
