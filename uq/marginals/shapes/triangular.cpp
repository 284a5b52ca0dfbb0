#include "uq/marginals/shapes/triangular.hpp"

#include "uq/marginals/shapes/shape_checks.hpp"

#include <cmath>

namespace uq {
namespace {

/// P(X <= mode)
double rising_share(const Triangular& s) { return (s.mode - s.lower) / (s.upper - s.lower); }

double rising(const Triangular& s, double p)
{
    return s.lower + std::sqrt(p * (s.upper - s.lower)) * std::sqrt(s.mode - s.lower);
}

double falling(const Triangular& s, double q)
{
    return s.upper - std::sqrt(q * (s.upper - s.lower)) * std::sqrt(s.upper - s.mode);
}

} // namespace

void check(const Triangular& s)
{
    require_ends("triangular: upper end", s.lower, s.upper);
    if (!(s.lower <= s.mode && s.mode <= s.upper))
        refuse("triangular: mode", s.mode, "between the ends or at one of them");
}

// Squares of the distance to the ends, on either side of the mode.
Range support(const Triangular& s) { return {s.lower, s.upper}; }
double density(const Triangular& s, double x)
{
    const double height = 2.0 / (s.upper - s.lower);
    if (x == s.mode) return height;
    return x < s.mode ? height * ((x - s.lower) / (s.mode - s.lower))
                      : height * ((s.upper - x) / (s.upper - s.mode));
}
double lower_tail(const Triangular& s, double x)
{
    if (x <= s.lower) return 0.0;
    if (x > s.mode) return 1.0 - upper_tail(s, x);
    return (x - s.lower) / (s.upper - s.lower) * ((x - s.lower) / (s.mode - s.lower));
}
double upper_tail(const Triangular& s, double x)
{
    if (x >= s.upper) return 0.0;
    if (x <= s.mode) return 1.0 - lower_tail(s, x);
    return (s.upper - x) / (s.upper - s.lower) * ((s.upper - x) / (s.upper - s.mode));
}
double at_lower(const Triangular& s, double p)
{
    return p <= rising_share(s) ? rising(s, p) : falling(s, 1.0 - p);
}
double at_upper(const Triangular& s, double q)
{
    return q < 1.0 - rising_share(s) ? falling(s, q) : rising(s, 1.0 - q);
}
double between(const Triangular& s, double x, double y)
{
    if (x < s.mode && s.mode < y) return between(s, x, s.mode) + between(s, s.mode, y);
    return 0.5 * (density(s, x) + density(s, y)) * (y - x);
}
double kink(const Triangular& s) { return s.mode; }
MeanSd mean_sd(const Triangular& s)
{
    const double width = s.upper - s.lower, rise = s.mode - s.lower;
    return {s.lower + (width + rise) / 3.0,
            std::sqrt((width * width + rise * rise - width * rise) / 18.0)};
}

std::span<const ShapeForm<Triangular>> forms(const Triangular*)
{
    static constexpr ShapeForm<Triangular> all[] = {
        {{{{"lower"}, {"mode"}, {"upper"}}}, [](const double* p) {
             return Triangular{p[0], p[1], p[2]};
         }}};
    return all;
}

} // namespace uq
