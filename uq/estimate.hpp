#pragma once
/// No number without its doubt.

#include <cstddef>

namespace uq {

/// An interval that holds the true value with the given confidence [-].
struct Interval {
    double lower, upper, confidence;
};

struct Estimate {
    double value;
    double std_error;       ///< of `value`, same unit
    std::size_t n;          ///< sound samples used
    std::size_t failed = 0; ///< samples asked for that gave no answer
    Interval interval{};
};

} // namespace uq
