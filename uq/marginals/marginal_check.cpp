#include "uq/marginals/marginal.hpp"

#include "uq/marginals/marginal_cut.hpp"
#include "uq/marginals/marginal_refusal.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace uq {
namespace {

void finite(const char* what, double value)
{
    if (!std::isfinite(value)) refuse(what, value, "a finite number");
}

void positive(const char* what, double value)
{
    if (!(value > 0.0 && std::isfinite(value))) refuse(what, value, "> 0, finite");
}

void ends(const char* shape, double lower, double upper)
{
    finite(shape, lower);
    finite(shape, upper);
    if (!(lower < upper)) refuse(shape, upper, "above the lower end");
    finite(shape, upper - lower);
}

void check_shape(const Constant& s) { finite("constant: value", s.value); }

void check_shape(const Normal& s)
{
    finite("normal: mean", s.mean);
    positive("normal: sd", s.sd);
}

void check_shape(const Lognormal& s)
{
    finite("lognormal: mu_log", s.mu_log);
    positive("lognormal: sigma_log", s.sigma_log);
}

void check_shape(const Uniform& s) { ends("uniform: upper end", s.lower, s.upper); }

void check_shape(const Triangular& s)
{
    ends("triangular: upper end", s.lower, s.upper);
    if (!(s.lower <= s.mode && s.mode <= s.upper))
        refuse("triangular: mode", s.mode, "between the ends or at one of them");
}

void check_shape(const Beta& s)
{
    positive("beta: alpha", s.alpha);
    positive("beta: beta", s.beta);
    ends("beta: upper end", s.lower, s.upper);
}

void check_shape(const Gamma& s)
{
    positive("gamma: shape", s.shape);
    positive("gamma: scale", s.scale);
}

void check_shape(const Weibull& s)
{
    positive("weibull: shape", s.shape);
    positive("weibull: scale", s.scale);
}

void check_shape(const Gumbel& s)
{
    finite("gumbel: location", s.location);
    positive("gumbel: scale", s.scale);
}

void check_shape(const Empirical& s)
{
    if (s.sorted.empty())
        throw std::invalid_argument("empirical: no observations; one at least");
    for (const double x : s.sorted) finite("empirical: an observation", x);
    if (!std::ranges::is_sorted(s.sorted))
        throw std::invalid_argument("empirical: observations are not in ascending order");
}

bool leaves(const Constant& s, const Marginal& m)
{
    return m.lower <= s.value && s.value <= m.upper;
}

bool leaves(const Empirical& s, const Marginal& m)
{
    return std::ranges::any_of(s.sorted,
                               [&](double x) { return m.lower <= x && x <= m.upper; });
}

template <class S> bool leaves(const S& s, const Marginal& m)
{
    constexpr double kSmallest = 1e-290; // below it quotients of probabilities lose digits
    return shape::cut(s, m.lower, m.upper).mass >= kSmallest;
}

} // namespace

void check(const Marginal& m)
{
    std::visit([](const auto& s) { check_shape(s); }, m.shape);
    if (std::isnan(m.lower) || std::isnan(m.upper) || m.lower > m.upper)
        refuse("cut: upper end", m.upper, "a number, not below the lower end of the cut");
    if (!std::visit([&](const auto& s) { return leaves(s, m); }, m.shape)) {
        std::ostringstream text;
        text << "cut: nothing of the distribution is left between " << m.lower << " and "
             << m.upper;
        throw std::invalid_argument(text.str());
    }
}

} // namespace uq
