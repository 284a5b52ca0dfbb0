#pragma once
/// Samples in the unit cube: n x d, rows are samples, entries inside (0, 1).

#include "uq/designs/design_kind.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace uq {

struct Design {
    DesignKind kind = DesignKind::latin_random;
    /// Numbers of rows, ascending: the design has the first size, then grows to the second, and
    /// so on. Rows of a size stay as they are, bit for bit, when a further size is added. At
    /// most 2^20 rows for Latin hypercubes, 2^32 otherwise.
    std::vector<std::int64_t> sizes;
    int d = 1; ///< variables, >= 1
    std::uint64_t seed = 0;
};

/// @throws std::invalid_argument naming what is out of range
void check(const Design& design);
/// Checks the design, and that 0 <= first <= last <= rows.
void check(const Design& design, std::int64_t first, std::int64_t last);

[[nodiscard]] std::int64_t rows(const Design& design); ///< rows of the last size

/// All rows.
[[nodiscard]] Eigen::MatrixXd unit_cube(const Design& design);

/// Rows first .. last - 1 of the design, the same bits. Cost: Monte Carlo and Sobol' compute
/// only the requested rows. A Latin hypercube of one size computes all strata but only these
/// rows' positions. Optimised or grown designs are computed in full.
[[nodiscard]] Eigen::MatrixXd unit_cube(const Design& design, std::int64_t first,
                                        std::int64_t last);

} // namespace uq
