#pragma once
/// Latin hypercubes (McKay, Beckman, Conover 1979): n rows, each of the n strata of each
/// variable holds one of them.

#include <Eigen/Core>

#include <cstdint>

namespace uq {

enum class Place { random, centred };

/// The stratum of u among n: floor(u n).
[[nodiscard]] std::int64_t stratum(double u, std::int64_t n);

/// Rows first .. last - 1 of n. The strata of variable j are shuffled (Fisher-Yates) by the
/// stream (seed, j, strata). The place of row i in its stratum is draw j of the stream (seed,
/// i, place_in_stratum); it has 30 bits, so that a row is never on the edge of a stratum, not
/// even of one of a grown design.
[[nodiscard]] Eigen::MatrixXd latin_hypercube(std::int64_t n, int d, std::uint64_t seed,
                                              Place place, std::int64_t first,
                                              std::int64_t last);

/// Grows a design to m rows, m > rows of `old`: each new row in an empty stratum of m. The
/// strata that stay empty because old rows share one are drawn, too. No other choice of new
/// rows fills more strata; the result is Latin if `old` is Latin and m is a multiple of its
/// rows.
/// @param old entries inside (0, 1); need not be Latin
/// @return m x d; the first rows are the old ones, bit for bit
/// @throws std::invalid_argument if an entry of `old` or m is out of range
[[nodiscard]] Eigen::MatrixXd grow_latin(const Eigen::MatrixXd& old, std::int64_t m,
                                         std::uint64_t seed, Place place);

} // namespace uq
