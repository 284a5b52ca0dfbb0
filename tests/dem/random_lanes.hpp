#pragma once
/// Random numbers for every lane of a register, and whether all lanes have the same bits.

#include "bits.hpp"
#include "dem/contact/pack.hpp"

#include <cstddef>
#include <random>
#include <vector>

namespace random_lanes {

/// In [-1, 1).
inline double number(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
}

template <class Real> std::vector<Real> numbers(std::size_t n, std::mt19937_64& random)
{
    std::vector<Real> v(n);
    for (Real& x : v)
        for (int i = 0; i < dem::lanes<Real>; ++i) dem::set_lane(x, i, number(random));
    return v;
}

template <class Real> bool same(const Real& a, const Real& b)
{
    bool all = true;
    for (int i = 0; i < dem::lanes<Real>; ++i)
        all = all && bits::same(dem::lane(a, i), dem::lane(b, i));
    return all;
}

} // namespace random_lanes
