#pragma once
/// Rows drawn in proportion to weights.

#include "uq/designs/stream.hpp"

#include <Eigen/Core>

#include <vector>

namespace uq {

/// `count` rows, each as often as count x weight / sum of weights, up or down to a whole number
/// (systematic resampling, Kitagawa 1996), in the order of the rows.
/// @param weight >= 0, not all zero
[[nodiscard]] inline std::vector<Eigen::Index> pick_evenly(const Eigen::VectorXd& weight,
                                                           Eigen::Index count, Stream& random)
{
    std::vector<Eigen::Index> rows;
    const double step = weight.sum() / static_cast<double>(count);
    double passed = weight(0), at = random.uniform() * step;
    for (Eigen::Index i = 0, k = 0; k < count; ++k, at += step) {
        while (passed < at && i + 1 < weight.size()) passed += weight(++i);
        rows.push_back(i);
    }
    return rows;
}

} // namespace uq
