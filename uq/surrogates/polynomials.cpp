#include "uq/surrogates/polynomials.hpp"

#include <cmath>
#include <stdexcept>

namespace uq {

std::string_view name(PolynomialFamily family)
{
    return family == PolynomialFamily::legendre ? "legendre" : "hermite";
}

PolynomialFamily family_of(const Marginal& m)
{
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

double coordinate(const Marginal& m, double x)
{
    return family_of(m) == PolynomialFamily::legendre ? 2.0 * cdf(m, x) - 1.0 : to_normal(m, x);
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

Eigen::VectorXd polynomials(PolynomialFamily family, int most, double c)
{
    Eigen::VectorXd p(most + 1);
    p(0) = 1.0;
    if (family == PolynomialFamily::hermite) { // sqrt(k + 1) p_k+1 = c p_k - sqrt(k) p_k-1
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
