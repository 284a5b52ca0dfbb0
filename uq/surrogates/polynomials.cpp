#include "uq/surrogates/polynomials.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace uq {

namespace {

constexpr std::array<std::string_view, 4> kNames = {"legendre", "hermite", "jacobi",
                                                    "laguerre"}; // as Kind

/// " 0.5", with as many digits as tell the number from all others.
std::string shortest(double x)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
    return " " + std::string(text.data(), end);
}

constexpr double kNothingCut = 1e-12; // of the probability: orthonormal to rounding

/// Whether the limits of a variable cut off a part of its shape. Keys have limits of their own.
template <class ShapeOf> bool is_cut(const Marginal& m, const ShapeOf& shape)
{
    const double below = std::isinf(m.lower) ? 0.0 : lower_tail(shape, m.lower);
    const double above = std::isinf(m.upper) ? 0.0 : upper_tail(shape, m.upper);
    return below + above > kNothingCut;
}

/// Coefficients of sqrt(next) p_k+1 = (c - middle) p_k - sqrt(last) p_k-1 (Gautschi 2004, table
/// 1.1).
struct Recurrence {
    double middle, last, next;
};

Recurrence laguerre_recurrence(double a, int k)
{
    return {2.0 * k + 1.0 + a, k * (k + a), (k + 1.0) * (k + 1.0 + a)};
}

Recurrence jacobi_recurrence(double a, double b, int k)
{
    const auto square = [a, b](double n) {
        const double s = 2.0 * n + a + b;
        if (n == 0.0) return 0.0;
        if (n == 1.0)
            return 4.0 * (1.0 + a) * (1.0 + b) / (s * s * (s + 1.0)); // a + b may be -1
        return 4.0 * n * (n + a) * (n + b) * (n + a + b) / (s * s * (s + 1.0) * (s - 1.0));
    };
    const double s = 2.0 * k + a + b;
    return {k == 0 ? (b - a) / (s + 2.0) : (b * b - a * a) / (s * (s + 2.0)), square(k),
            square(k + 1.0)};
}

} // namespace

std::string name(const PolynomialFamily& f)
{
    std::string text(kNames[f.kind]);
    if (f.kind == PolynomialFamily::jacobi) text += shortest(f.a) + shortest(f.b);
    if (f.kind == PolynomialFamily::laguerre) text += shortest(f.a);
    return text;
}

PolynomialFamily family_named(const std::string& text)
{
    std::istringstream in(text);
    std::string first;
    in >> first;
    const auto at = std::ranges::find(kNames, first);
    const bool known = at != kNames.end();
    PolynomialFamily f(known ? static_cast<PolynomialFamily::Kind>(at - kNames.begin())
                             : PolynomialFamily::legendre);
    if (f.kind == PolynomialFamily::jacobi) in >> f.a >> f.b;
    if (f.kind == PolynomialFamily::laguerre) in >> f.a;
    if (!known || !in || !(f.a > -1.0 && f.b > -1.0))
        throw std::invalid_argument("'" + text + "' is no family of polynomials");
    return f;
}

PolynomialFamily family_of(const Marginal& m)
{
    if (const Beta* beta = std::get_if<Beta>(&m.shape); beta != nullptr && !is_cut(m, *beta))
        return {PolynomialFamily::jacobi, beta->beta - 1.0, beta->alpha - 1.0};
    if (const Gamma* gamma = std::get_if<Gamma>(&m.shape);
        gamma != nullptr && !is_cut(m, *gamma))
        return {PolynomialFamily::laguerre, gamma->shape - 1.0};
    const bool two_ends = std::holds_alternative<Uniform>(m.shape) ||
                          std::holds_alternative<Triangular>(m.shape) ||
                          std::holds_alternative<Beta>(m.shape);
    return two_ends ? PolynomialFamily::legendre : PolynomialFamily::hermite;
}

std::vector<PolynomialFamily> families_of(std::span<const Marginal> variables)
{
    std::vector<PolynomialFamily> families;
    for (const Marginal& m : variables) families.push_back(family_of(m));
    return families;
}

double coordinate(const Marginal& m, double x) { return coordinate(family_of(m), m, x); }

double coordinate(const PolynomialFamily& family, const Marginal& m, double x)
{
    switch (family.kind) {
    case PolynomialFamily::legendre:
        return 2.0 * cdf(m, x) - 1.0;
    case PolynomialFamily::jacobi: {
        const Beta& beta = std::get<Beta>(m.shape);
        const double place = (x - beta.lower) / (beta.upper - beta.lower);
        return std::clamp(2.0 * place - 1.0, -1.0, 1.0);
    }
    case PolynomialFamily::laguerre:
        return std::max(0.0, x / std::get<Gamma>(m.shape).scale);
    case PolynomialFamily::hermite:
        break;
    }
    return to_normal(m, x);
}

Eigen::MatrixXd coordinates(std::span<const Marginal> variables, const Eigen::MatrixXd& x)
{
    if (x.cols() != static_cast<Eigen::Index>(variables.size()))
        throw std::invalid_argument("coordinates: one column for each variable");
    Eigen::MatrixXd c(x.rows(), x.cols());
    for (Eigen::Index j = 0; j < x.cols(); ++j)
        for (Eigen::Index i = 0; i < x.rows(); ++i) c(i, j) = coordinate(variables[j], x(i, j));
    return c;
}

Eigen::VectorXd polynomials(const PolynomialFamily& family, int most, double c)
{
    Eigen::VectorXd p(most + 1);
    p(0) = 1.0;
    const bool jacobi = family.kind == PolynomialFamily::jacobi;
    if (jacobi || family.kind == PolynomialFamily::laguerre) {
        for (int k = 0; k < most; ++k) {
            const Recurrence r = jacobi ? jacobi_recurrence(family.a, family.b, k)
                                        : laguerre_recurrence(family.a, k);
            p(k + 1) = ((c - r.middle) * p(k) - (k > 0 ? std::sqrt(r.last) * p(k - 1) : 0.0)) /
                       std::sqrt(r.next);
        }
        return p;
    }
    if (family.kind == PolynomialFamily::hermite) { // sqrt(k + 1) p_k+1 = c p_k - sqrt(k) p_k-1
        for (int k = 0; k < most; ++k)
            p(k + 1) =
                (c * p(k) - (k > 0 ? std::sqrt(k) * p(k - 1) : 0.0)) / std::sqrt(k + 1.0);
        return p;
    }
    for (int k = 0; k < most; ++k) // (k + 1) P_k+1 = (2 k + 1) c P_k - k P_k-1
        p(k + 1) = ((2.0 * k + 1.0) * c * p(k) - (k > 0 ? k * p(k - 1) : 0.0)) / (k + 1.0);
    for (int k = 0; k <= most; ++k) p(k) *= std::sqrt(2.0 * k + 1.0);
    return p;
}

} // namespace uq
