#pragma once
/// How much the distribution of a response depends on one input, from given samples: the index
/// of Cramer and von Mises by ranks (Gamboa, Klein and Lagnoux 2018; Chatterjee 2021).
///
///   xi = int Var(E[1(Y >= t) | X]) dF(t) / int Var(1(Y >= t)) dF(t), in [0, 1];
///   0: y does not depend on x, 1: y is a function of x

#include "uq/estimates/estimate.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace uq {

struct RankIndexOptions {
    int halves = 200; ///< random halves of the samples, >= 20
    double confidence = kConfidence;
    std::uint64_t seed = 1;
    std::uint64_t stream = 0; ///< number of the input: each has halves of its own
};

/// Estimate without any class or width to choose: neighbours in x stand for equal values of x.
/// Below 0 it says nothing. The standard error is the scatter of the estimate over halves drawn
/// without replacement: a bootstrap fails here, since its ties make neighbours equal (Lin and
/// Han 2024). The interval is normal and cut at 0 and 1.
/// @param x, y finite, of equal length, at least 10; else std::invalid_argument, also where one
/// of them does not vary
[[nodiscard]] Estimate rank_index(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                  const RankIndexOptions& options = {});

/// Probability of an index as large by chance where y does not depend on x: it is then normal
/// with mean 0 and variance 2 / (5 n) where no two y are equal, and with ties the variance of
/// Chatterjee (2021), theorem 2.2, from the ranks of y. @param y that the index is of
[[nodiscard]] double independence_p(const Estimate& rank_index, const Eigen::VectorXd& y);

/// The estimate alone. Equal values of x keep the order of the samples.
[[nodiscard]] double raw_rank_index(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

} // namespace uq
