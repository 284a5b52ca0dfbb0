#pragma once
/// Half widths of two-sided intervals in standard errors.

namespace uq {

/// @throws std::invalid_argument if `confidence` is not in (0, 1)
void check_confidence(double confidence);
/// Of the normal distribution: 1.96 for 0.95.
[[nodiscard]] double normal_factor(double confidence);
/// Of Student's distribution; freedom > 0, else std::invalid_argument.
[[nodiscard]] double student_factor(double confidence, double freedom);

} // namespace uq
