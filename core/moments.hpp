#pragma once
/// Mean and standard deviation of a sample.

#include <span>

namespace core {

struct Moments {
    double mean;
    double sd; ///< with n - 1
};
/// Two passes with compensated sums (Neumaier 1974; Chan, Golub, LeVeque 1983): right to some
/// units of the last place of the data, however small the spread.
/// @param y finite, at least 2, else std::invalid_argument
[[nodiscard]] Moments moments(std::span<const double> y);

} // namespace core
