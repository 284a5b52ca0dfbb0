#pragma once
/// The model under study: parameters in, responses out, in batches.

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace uq {

/// Row i of `x` is sample `id[i]`.
struct Samples {
    Eigen::MatrixXd x;             ///< n x d, physical units of each variable
    std::vector<std::uint64_t> id; ///< n, number of the sample in its study
};

/// Row i of `y` answers row i of the samples. A sample that fails is kept: its row of `y` is
/// NaN and must not be used, its reason says what went wrong.
struct Responses {
    Eigen::MatrixXd y;                ///< n x m
    std::vector<std::string> failure; ///< n, empty where the row is sound
};

using BlackBox = std::function<Responses(const Samples&)>;

} // namespace uq
