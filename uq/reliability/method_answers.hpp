#pragma once
/// Parts of the answer that every method makes in the same way.

#include "uq/reliability/limit_state/exceedance.hpp"
#include "uq/reliability/reliability.hpp"

#include <cstddef>
#include <string>

namespace uq {

/// Evaluations that are left of the budget.
[[nodiscard]] std::size_t left(const ReliabilityProblem& p, const ReliabilityAnswer& a);

/// Counts evaluations and failed samples.
void take(const Ledger& ledger, ReliabilityAnswer& a);

/// A probability from samples, its warnings and its evaluations. Where all or none passed it is
/// a bound.
void add(const std::string& method, const Exceedance& e, ReliabilityAnswer& a);

} // namespace uq
