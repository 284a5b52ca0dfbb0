#pragma once
/// Latin hypercubes (McKay, Beckman, Conover 1979): n rows, each of the n strata of each variable
/// holds one of them.

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace uq {

enum class Place { random, centred };

/// The stratum of u among n: floor(u n).
[[nodiscard]] std::int64_t stratum(double u, std::int64_t n);

/// Rows first .. last - 1 of n. Strata of variable j: Fisher-Yates on stream (seed, j, strata).
/// Place of row i: draw j of stream (seed, i, place_in_stratum), 30 bits, so that a row is never
/// on the edge of a stratum, also not of those of a grown design.
[[nodiscard]] Eigen::MatrixXd latin_hypercube(std::int64_t n, int d, std::uint64_t seed,
                                              Place place, std::int64_t first,
                                              std::int64_t last);

struct GrownLatin {
    Eigen::MatrixXd u; ///< m x d; the first rows are the old ones, bit for bit
    /// Of each variable: strata of m with more than one row, counting a row too many each; as many
    /// are empty. No other choice of new rows has fewer. 0: Latin. Always 0 where m is a multiple
    /// of the rows of a Latin `old`.
    std::vector<std::int64_t> doubled;
};

/// Grows a design to m rows, m > rows of `old`: each new row in an empty stratum of m. The strata
/// that stay empty where old rows share one are drawn, too.
/// @param old entries inside (0, 1); need not be Latin
/// @throws std::invalid_argument
[[nodiscard]] GrownLatin grow_latin(const Eigen::MatrixXd& old, std::int64_t m,
                                    std::uint64_t seed, Place place);

/// Rows too many in the strata of each variable, as in GrownLatin: 0 where it is Latin.
[[nodiscard]] std::vector<std::int64_t> doubled_strata(const Eigen::MatrixXd& u);

} // namespace uq
