#pragma once
/// The linear map that correlates independent standard normal coordinates: g = map z.

#include <Eigen/Core>

#include <vector>

namespace uq {

struct FieldBasis {
    Eigen::MatrixXd map; ///< sites x coordinates; g = map z, z standard normal
    /// Added to the diagonal (then all scaled back to unit variance) because the matrix was
    /// singular to working precision; correlations are that much smaller [-]. 0: not needed.
    double nugget = 0.0;
};

/// Largest nugget that passes for rounding.
constexpr double kLargestNugget = 1e-8;

/// Lower triangular factor of the correlation. Sites of correlation exactly 1 share one row and
/// one coordinate. A field with one value for all sites therefore has one coordinate and
/// returns it unchanged; independent sites return their coordinates unchanged.
/// @param correlation symmetric, ones on the diagonal, entries in [-1, 1]
/// @throws std::invalid_argument if it is not, or if it is indefinite beyond kLargestNugget
[[nodiscard]] FieldBasis cholesky_basis(const Eigen::MatrixXd& correlation);

/// How sites are represented: site i has the value of distinct site `of[i]`, which is site
/// `first[of[i]]`.
struct DistinctSites {
    std::vector<Eigen::Index> of, first;
};
/// @throws std::invalid_argument if `correlation` is no correlation matrix
[[nodiscard]] DistinctSites distinct_sites(const Eigen::MatrixXd& correlation);
/// Rows and columns of the distinct sites.
[[nodiscard]] Eigen::MatrixXd reduced(const Eigen::MatrixXd& correlation,
                                      const DistinctSites& sites);
/// Rows of the distinct sites handed out to all sites.
[[nodiscard]] Eigen::MatrixXd expanded(const Eigen::MatrixXd& rows, const DistinctSites& sites);

} // namespace uq
