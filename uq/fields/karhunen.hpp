#pragma once
/// Karhunen-Loeve: the few modes that carry most of a field's variance.
///
/// Over sites, not over a continuum: the modes are the eigenvectors of the correlation matrix
/// (principal components), each site counts the same.

#include "uq/fields/field_basis.hpp"

namespace uq {

struct KarhunenOptions {
    double share = 0.99;    ///< of the variance kept, mean over the sites [-], in (0, 1]
    Eigen::Index modes = 0; ///< kept; 0: as many as `share` needs. Else `share` is not used
    /// Scale each site back to unit variance: the marginal is then the one asked for, and the
    /// correlations are those of the kept part. Off: the variance dropped is missing.
    bool unit_variance = true;
};

/// All eigenvalues, descending, negative rounding set to 0.
/// @param correlation symmetric, ones on the diagonal, entries in [-1, 1]
/// @throws std::invalid_argument if it is not
[[nodiscard]] Eigen::VectorXd karhunen_eigenvalues(const Eigen::MatrixXd& correlation);

/// Smallest number of modes that keeps `share` of the variance.
/// @param eigenvalues descending  @param share in (0, 1], else std::invalid_argument
[[nodiscard]] Eigen::Index modes_for(const Eigen::VectorXd& eigenvalues, double share);

/// Sites of correlation exactly 1 count as one for the modes (they share a value anyway), so
/// one value for all gives its coordinate back unchanged; independent sites have one mode each,
/// in their order. The largest entry of a mode is positive.
/// @throws std::invalid_argument as above, for options out of range, for an eigenvalue below
/// -kLargestNugget, or if unit variance is asked for and a site has none left
[[nodiscard]] FieldBasis karhunen_basis(const Eigen::MatrixXd& correlation,
                                        const KarhunenOptions& options = {});

} // namespace uq
