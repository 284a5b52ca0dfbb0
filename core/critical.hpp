#pragma once
/// Half widths of two-sided intervals in standard errors.

namespace core {

/// @throws std::invalid_argument if `confidence` is not in (0, 1)
void check_confidence(double confidence);
/// Half width under the normal distribution: 1.96 for 0.95.
[[nodiscard]] double normal_factor(double confidence);
/// Half width under Student's distribution.
/// @throws std::invalid_argument also if `freedom` is not > 0
[[nodiscard]] double student_factor(double confidence, double freedom);

} // namespace core
