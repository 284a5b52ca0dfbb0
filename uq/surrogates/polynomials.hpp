#pragma once
/// Orthonormal polynomials of one variable, and the coordinates in which random variables are
/// their arguments (Xiu and Karniadakis 2002).

#include "uq/marginals/marginal.hpp"

#include <Eigen/Core>

#include <span>
#include <string_view>
#include <vector>

namespace uq {

enum class PolynomialFamily {
    legendre, ///< of 2 F(x) - 1, uniform on (-1, 1)
    hermite   ///< of Phi^-1(F(x)), standard normal
};
[[nodiscard]] std::string_view name(PolynomialFamily family); ///< "legendre"

/// Legendre for variables with two ends (uniform, triangular, beta), Hermite for all others.
[[nodiscard]] PolynomialFamily family_of(const Marginal& m);
[[nodiscard]] std::vector<PolynomialFamily> families_of(std::span<const Marginal> variables);

/// Coordinate of a value of the variable; beyond the ends of the variable that of the end.
[[nodiscard]] double coordinate(const Marginal& m, double x);
/// @param x n x d @throws std::invalid_argument if the sizes differ or a value is NaN
[[nodiscard]] Eigen::MatrixXd coordinates(std::span<const Marginal> variables,
                                          const Eigen::MatrixXd& x);

/// Values of the polynomials of degree 0 .. most at a coordinate, with mean square 1.
[[nodiscard]] Eigen::VectorXd polynomials(PolynomialFamily family, int most, double coordinate);

} // namespace uq
