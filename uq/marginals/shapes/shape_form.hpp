#pragma once
/// The description of a distribution of one variable.

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace uq {

/// Ends of the support.
struct Range {
    double lower, upper;
};

/// Mean and standard deviation of a distribution.
struct MeanSd {
    double mean, sd;
};

/// A parameter by which a distribution is written in text.
struct ShapeParameter {
    std::string_view name;
    bool bare = false; ///< a number without unit; else in the unit of the variable
};

/// One way to write a distribution: named parameters and what they make.
template <class S> struct ShapeForm {
    std::array<ShapeParameter, 4> parameters; ///< an empty name: no more
    S (*make)(const double* p);               ///< p: values in the order of the names
};

} // namespace uq
