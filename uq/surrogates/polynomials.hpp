#pragma once
/// Orthonormal polynomials of one variable, and the coordinates in which random variables are
/// their arguments (Xiu and Karniadakis 2002).

#include "uq/marginals/marginal.hpp"

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace uq {

struct PolynomialFamily {
    enum Kind {
        legendre, ///< of 2 F(x) - 1, uniform on (-1, 1)
        hermite,  ///< of Phi^-1(F(x)), standard normal
        jacobi,   ///< of a beta variable between -1 and 1, density (1 - c)^a (1 + c)^b
        laguerre  ///< of a gamma variable over its scale, density c^a exp(-c)
    };
    Kind kind;
    double a = 0.0, b = 0.0; ///< exponents of the density, > -1

    constexpr PolynomialFamily(Kind k, double exponent = 0.0, double other = 0.0)
        : kind(k), a(exponent), b(other)
    {
    }
    friend bool operator==(const PolynomialFamily&, const PolynomialFamily&) = default;
};

/// "legendre", "jacobi 0.5 1" with all digits of a and b
[[nodiscard]] std::string name(const PolynomialFamily& family);
/// The family of that name. @throws std::invalid_argument if there is none
[[nodiscard]] PolynomialFamily family_named(const std::string& name);

/// Jacobi for beta variables and Laguerre for gamma ones, which are linear in x; Legendre for
/// other variables with two ends (uniform, triangular, a beta that is cut off), Hermite for all
/// others.
[[nodiscard]] PolynomialFamily family_of(const Marginal& m);
[[nodiscard]] std::vector<PolynomialFamily> families_of(std::span<const Marginal> variables);

/// Coordinate of a value of the variable; beyond the ends of the variable that of the end.
[[nodiscard]] double coordinate(const Marginal& m, double x);
/// The same for a family that is not that of family_of: a file may be of an earlier version.
[[nodiscard]] double coordinate(const PolynomialFamily& family, const Marginal& m, double x);
/// @param x n x d @throws std::invalid_argument if the sizes differ or a value is NaN
[[nodiscard]] Eigen::MatrixXd coordinates(std::span<const Marginal> variables,
                                          const Eigen::MatrixXd& x);

/// Values of the polynomials of degree 0 .. most at a coordinate, with mean square 1.
[[nodiscard]] Eigen::VectorXd polynomials(const PolynomialFamily& family, int most,
                                          double coordinate);

} // namespace uq
