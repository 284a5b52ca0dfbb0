#pragma once
/// Refusals of parameters, with the value found and the values that are allowed.

namespace uq {

/// All functions below throw std::invalid_argument: "normal: mean is nan; allowed: a finite
/// number".
[[noreturn]] void refuse(const char* what, double value, const char* allowed);

void require_finite(const char* what, double value);
void require_positive(const char* what, double value);
/// Both ends finite, lower < upper, and their distance finite.
void require_ends(const char* what, double lower, double upper);

/// @param shape name of the distribution, for the message
void require_moments(const char* shape, double mean, double cov);
/// As above, and mean > 0.
void require_positive_moments(const char* shape, double mean, double cov);

} // namespace uq
