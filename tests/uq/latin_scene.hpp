#pragma once
/// A plain Latin hypercube for the tests of estimates.

#include "uq/designs/stream.hpp"

#include <Eigen/Core>

#include <numeric>
#include <utility>
#include <vector>

namespace scenes {

/// n x d in (0, 1), one entry in each of n strata of every column.
inline Eigen::MatrixXd latin_hypercube(int n, int d, std::uint64_t seed)
{
    Eigen::MatrixXd u(n, d);
    for (int j = 0; j < d; ++j) {
        uq::Stream order(seed, static_cast<std::uint64_t>(j), uq::Purpose::strata);
        uq::Stream place(seed, static_cast<std::uint64_t>(j), uq::Purpose::place_in_stratum);
        std::vector<int> strata(static_cast<std::size_t>(n));
        std::iota(strata.begin(), strata.end(), 0);
        for (std::size_t i = strata.size() - 1; i > 0; --i)
            std::swap(strata[i], strata[order.below(i + 1)]);
        for (int i = 0; i < n; ++i)
            u(i, j) = (strata[static_cast<std::size_t>(i)] + place.uniform()) / n;
    }
    return u;
}

inline Eigen::MatrixXd monte_carlo(int n, int d, std::uint64_t seed)
{
    Eigen::MatrixXd u(n, d);
    for (int i = 0; i < n; ++i) {
        uq::Stream s(seed, static_cast<std::uint64_t>(i), uq::Purpose::monte_carlo);
        for (int j = 0; j < d; ++j) u(i, j) = s.uniform();
    }
    return u;
}

} // namespace scenes
