#pragma once
/// Latin hypercubes whose rows keep their distance: simulated annealing of phi_50 by exchanges
/// of one coordinate between two rows (Morris and Mitchell 1995), which keep the Latin
/// property.

#include <Eigen/Core>

#include <cstdint>

namespace uq {

struct AnnealingOptions {
    int exchanges = 100000; ///< number of exchanges tried, >= 0
    double hot = 10.0;      ///< first temperature of ln phi, times n^2 [-], > 0; tuned
    double cold = 0.025;    ///< last temperature, in (0, hot]; tuned
};

/// The best arrangement of the rows, by phi_50, found by simulated annealing; never worse than
/// `u`. Small designs get several runs from hot to cold, each of at least 6 n^2 d exchanges,
/// because few rows have few good arrangements, which are hard to find (tuned). Only rows
/// `fixed` .. n - 1 are exchanged; their distances to the rows before count. An exchange costs
/// 2 n distances, whatever the number of variables. Random numbers come from the stream (seed,
/// n, annealing).
/// @throws std::invalid_argument for more than 4096 rows (16 n^2 bytes are used) or options out
/// of range
[[nodiscard]] Eigen::MatrixXd spread_rows(Eigen::MatrixXd u, Eigen::Index fixed,
                                          std::uint64_t seed,
                                          const AnnealingOptions& options = {});

} // namespace uq
