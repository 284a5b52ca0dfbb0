#pragma once
/// Samples in the unit cube: n x d, rows are samples, entries inside (0, 1).

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace uq {

enum class DesignKind {
    monte_carlo,     ///< independent rows
    latin_random,    ///< one row in each stratum of each variable, anywhere in it
    latin_centred,   ///< in the middle of the stratum
    latin_optimised, ///< latin_random, strata arranged so that no two rows are close
    sobol            ///< scrambled, see uq/designs/sobol.hpp
};

struct Design {
    DesignKind kind = DesignKind::latin_random;
    /// Rows, ascending: first those of the first size, then those by which it grew to the second
    /// and so on. Rows of a size stay as they are, bit for bit, when a further size is added.
    /// At most 2^20 rows for Latin hypercubes, 2^32 otherwise.
    std::vector<std::int64_t> sizes;
    int d = 1; ///< variables, >= 1
    std::uint64_t seed = 0;
};

/// @throws std::invalid_argument naming what is out of range
void check(const Design& design);
/// As above, and 0 <= first <= last <= rows.
void check(const Design& design, std::int64_t first, std::int64_t last);

[[nodiscard]] bool is_latin(DesignKind kind);
[[nodiscard]] std::int64_t rows(const Design& design); ///< of the last size

/// All rows.
[[nodiscard]] Eigen::MatrixXd unit_cube(const Design& design);

/// Rows first .. last - 1 of it, the same bits. Of independent rows and of Sobol' only these are
/// computed; of a Latin hypercube of one size all strata, only these rows' places; of an optimised
/// or grown one everything.
[[nodiscard]] Eigen::MatrixXd unit_cube(const Design& design, std::int64_t first,
                                        std::int64_t last);

} // namespace uq
