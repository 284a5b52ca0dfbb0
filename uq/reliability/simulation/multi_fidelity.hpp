#pragma once
/// Mean of a response, or probability of a limit state, of an expensive model with the help of
/// cheap ones.

#include "uq/reliability/limit_state/limit_state.hpp"
#include "uq/reliability/simulation/control_variate.hpp"
#include "uq/reliability/simulation/multi_fidelity_plan.hpp"

#include <functional>
#include <optional>

namespace uq {

struct CheapModel {
    BlackBox model;    ///< of the same parameters
    double cost = 0.0; ///< of a sample, in the unit of the expensive one's; 0: measured
    Eigen::Index response = 0;
    double threshold = 0.0; ///< of its own; not used for a mean
};

enum class Quantity {
    mean,       ///< of the response
    probability ///< that it passes its threshold
};

struct MultiFidelityOptions {
    Quantity quantity = Quantity::mean;
    double budget = 0.0;         ///< [unit of cost], pilot included
    double expensive_cost = 1.0; ///< of a sample; 0: measured, in seconds
    /// First samples, asked of every model, that tell correlations (and costs); they are part
    /// of the answer. >= 10
    std::size_t pilot = 20;
    double confidence = 0.95;
    std::uint64_t seed = 1;
    std::function<double()> now; ///< [s], for measured costs; empty: a steady clock
};

struct MultiFidelityResult {
    Estimate estimate{};
    /// Probability: if every failed expensive sample is safe, or passes. Mean: the value,
    /// twice.
    double lower = 0.0, upper = 0.0;
    EffortPlan plan;
    std::string reason;                    ///< why the cheap models do not pay
    Eigen::VectorXd correlation;           ///< in the pilot, of every cheap model
    Eigen::VectorXd cost;                  ///< of a sample: expensive, then every cheap model
    double plain_std_error = 0.0;          ///< of the same expensive samples without help
    double spent = 0.0;                    ///< [unit of cost]
    Ledger expensive;                      ///< of the expensive model
    std::vector<std::size_t> cheap_failed; ///< of every cheap model
};

/// With a cost of 0 the split depends on how long the pilot took: then two runs need not be
/// equal.
///
/// A failed sample of a cheap model counts as the mean of its pilot (as safe, for a
/// probability): any fixed number will do, since its mean need not be known. A failed sample of
/// the expensive model is imputed from samples with similar responses of the cheap models.
/// @param s expensive limit state; for a mean its threshold is not used
/// @throws std::invalid_argument naming what is missing or out of range, or a budget that does
/// not reach for the pilot; std::runtime_error if fewer than 3 expensive samples of the pilot
/// are sound
[[nodiscard]] MultiFidelityResult multi_fidelity(const LimitState& s,
                                                 const std::vector<CheapModel>& cheap,
                                                 const MultiFidelityOptions& o);

} // namespace uq
