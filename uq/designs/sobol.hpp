#pragma once
/// Sobol' points: direction numbers of Joe and Kuo (2008), as Boost.Random has them, up to 3667
/// dimensions; scrambled by a random lower triangular binary matrix for each dimension
/// and a digital shift (Matousek 1998): every point is uniform on the cube, the balance of the
/// points in binary boxes is kept, and seeds give independent estimates.
///
/// GSL's generator ends at 40 dimensions, NLopt does not export its own.

#include <Eigen/Core>

#include <cstdint>

namespace uq {

constexpr int kSobolDimensions = 3667;

enum class Scramble { none, matrix_and_shift };

/// Points first .. last - 1 of the sequence; any of them is reached at once. Entries are
/// (k + 1/2) / 2^52, so that point 0 without scrambling is 2^-53 away from the origin.
/// @throws std::invalid_argument for d outside [1, 3667]
[[nodiscard]] Eigen::MatrixXd sobol(std::int64_t first, std::int64_t last, int d,
                                    std::uint64_t seed,
                                    Scramble scramble = Scramble::matrix_and_shift);

} // namespace uq
