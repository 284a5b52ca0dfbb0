#pragma once
/// A limit state over independent standard normal variables u: passed where g(u) <= 0.
///
/// "Passed" is the event whose probability is sought; "failed" is said only of evaluations that
/// gave no answer.

#include "uq/reliability/limit_state/black_box.hpp"

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace uq {

/// Rows u (n x d, independent standard normal) to rows x (n x k, physical units).
using Map = std::function<Eigen::MatrixXd(const Eigen::MatrixXd& u)>;

enum class Passing {
    at_or_below, ///< g = response - threshold
    at_or_above  ///< g = threshold - response
};

struct LimitState {
    BlackBox model;
    Map to_physical;            ///< empty: x = u
    Eigen::Index dimension = 0; ///< of u, >= 1
    Eigen::Index response = 0;  ///< column of the answer
    double threshold = 0.0;     ///< [unit of the response], finite
    Passing passing = Passing::at_or_below;
};

/// @throws std::invalid_argument naming what is missing or out of range
void check(const LimitState& s);

struct FailedSample {
    std::uint64_t id;  ///< its number in the analysis
    Eigen::VectorXd x; ///< its parameters, physical units
    std::string reason;
};

/// Counts the evaluations of an analysis and keeps those that failed.
struct Ledger {
    std::size_t evaluations = 0; ///< samples asked for; the next one has this number
    std::size_t batches = 0;     ///< calls of the model
    std::vector<FailedSample> failed;
    std::size_t limit = std::numeric_limits<std::size_t>::max(); ///< evaluations allowed
    bool used_up = false; ///< more evaluations than allowed were wanted; they were not made
    /// g by u, for an analysis that returns to points: none is asked for twice.
    std::optional<std::map<std::vector<double>, double>> known;
};

/// g of each row of `u`, and the ledger brought up to date. A value is not a number if its
/// evaluation failed; all are if the ledger does not allow as many evaluations.
[[nodiscard]] Eigen::VectorXd limit_values(const LimitState& s, const Eigen::MatrixXd& u,
                                           Ledger& ledger);

} // namespace uq
