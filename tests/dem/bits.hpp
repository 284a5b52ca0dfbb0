#pragma once
/// Numbers compared bit by bit.

#include <bit>
#include <cmath>
#include <cstdint>

namespace bits {

inline std::uint64_t of(double x) { return std::bit_cast<std::uint64_t>(x); }

template <class T> bool same(T a, T b) { return of(a) == of(b); }

/// The same bits, or both not a number: which operand's NaN survives a sum is the compiler's
/// choice.
template <class T> bool same_number(T a, T b)
{
    return same(a, b) || (std::isnan(a) && std::isnan(b));
}

} // namespace bits
