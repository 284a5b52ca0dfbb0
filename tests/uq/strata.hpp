#pragma once
/// How far a design is from a Latin hypercube.

#include "uq/designs/latin.hpp"

#include <algorithm>
#include <vector>

namespace scenes {

/// Rows beyond the first in the strata of each variable, as many strata as rows; 0: Latin.
inline std::vector<std::int64_t> doubled_strata(const Eigen::MatrixXd& u)
{
    std::vector<std::int64_t> doubled;
    for (Eigen::Index j = 0; j < u.cols(); ++j) {
        std::vector<std::int64_t> count(static_cast<std::size_t>(u.rows()));
        for (Eigen::Index i = 0; i < u.rows(); ++i)
            ++count[static_cast<std::size_t>(uq::stratum(u(i, j), u.rows()))];
        std::int64_t sum = 0;
        for (const std::int64_t c : count) sum += std::max<std::int64_t>(0, c - 1);
        doubled.push_back(sum);
    }
    return doubled;
}

} // namespace scenes
