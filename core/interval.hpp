#pragma once

#include <limits>

namespace core {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Holds the true value with the given confidence [-], in (0, 1). A bound that the data do not
/// give is infinite (or the end of what is possible: 0 and 1 for a probability).
struct Interval {
    double lower, upper, confidence;
};

} // namespace core
