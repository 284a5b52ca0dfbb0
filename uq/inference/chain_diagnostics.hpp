#pragma once
/// Whether Markov chains have found the same distribution, and how much their draws are worth.

#include <Eigen/Core>

namespace uq {

struct ChainDiagnostics {
    double r_hat;     ///< 1 where all chains agree; above 1.01 they do not yet
    double effective; ///< independent draws that would give the mean as exactly
};

/// Split, rank-normalised R-hat and effective size by the initial monotone sequence of Geyer
/// (Vehtari, Gelman, Simpson, Carpenter, Burkner 2021).
/// @param draws of one quantity: a column for each chain, at least 8 rows
/// @throws std::invalid_argument for fewer rows
[[nodiscard]] ChainDiagnostics diagnose(const Eigen::MatrixXd& draws);

} // namespace uq
