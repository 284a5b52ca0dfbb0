#pragma once
/// The law of a deviance.

namespace fragility {

/// P(X > x) for X of the chi-squared distribution. @param x >= 0, @param freedom > 0
[[nodiscard]] double chi_squared_survival(double x, double freedom);

} // namespace fragility
