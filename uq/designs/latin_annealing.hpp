#pragma once
/// Latin hypercubes whose rows keep their distance: simulated annealing of phi_50 by exchanges of
/// one coordinate between two rows (Morris and Mitchell 1995), which keep the Latin property.

#include <Eigen/Core>

#include <cstdint>

namespace uq {

struct AnnealingOptions {
    int exchanges = 100000; ///< tried, >= 0
    double hot = 10.0;      ///< first temperature: of ln phi, times 1 / n^2 [-], > 0; tuned
    double cold = 0.025;    ///< last temperature, in (0, hot]; tuned
};

/// Rows as arranged best in one descent from hot to cold, or in as many as leave 6 n^2 d exchanges
/// for each (few rows have few good arrangements, hard to find; tuned) by phi_50; never worse than `u`. Exchanges are tried
/// among rows `fixed` .. n - 1 alone, distances to the rows before count. Cost of one: 2 n distances,
/// whatever the number of variables. Draws from stream (seed, n, annealing).
/// @throws std::invalid_argument for more than 4096 rows (16 n^2 bytes are used) or options out
/// of range
[[nodiscard]] Eigen::MatrixXd spread_rows(Eigen::MatrixXd u, Eigen::Index fixed,
                                          std::uint64_t seed,
                                          const AnnealingOptions& options = {});

} // namespace uq
