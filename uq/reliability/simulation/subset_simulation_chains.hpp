#pragma once
/// Populations of subset simulation and the chains that make them.

#include "uq/designs/stream.hpp"
#include "uq/reliability/limit_state/limit_state.hpp"

namespace uq {

/// The outcome that a failed evaluation stands for.
enum class FailedAs { safe, passed };

struct Population {
    Eigen::MatrixXd u;
    Eigen::VectorXd g;                  ///< infinite where failed: + safe, - passed
    std::vector<Eigen::Index> ancestor; ///< row of the first level
};

struct ChainState {
    std::uint64_t seed = 1;
    std::uint64_t drawn = 0; ///< samples drawn: number of the next stream
    double scale = 0.6;      ///< of the moves, of the spread of the seeds; adapted
    double acceptance = 1.0; ///< of the last level
};

[[nodiscard]] Population first_population(const LimitState& s, std::size_t n, FailedAs failed,
                                          ChainState& state, Ledger& ledger);

/// A chain from each of the rows `seeds` of `p`, all moved at once, so that the population
/// keeps its size. Every state has g <= threshold.
[[nodiscard]] Population next_population(const LimitState& s, const Population& p,
                                         const std::vector<Eigen::Index>& seeds,
                                         double threshold, FailedAs failed, ChainState& state,
                                         Ledger& ledger);

} // namespace uq
