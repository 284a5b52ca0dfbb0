#pragma once
/// The model of an event, with a note of each evaluation.

#include "uq/reliability/reliability.hpp"

#include <vector>

namespace uq {

/// Notes what the model was asked and what it said, and hands each batch on. Samples that the
/// model throws on are failed samples here already, so that they are noted, too. Until one
/// sample is sound kUntilSound are asked for at a time.
/// @param seen must outlive the model
[[nodiscard]] BlackBox noted_model(const LimitState& event, std::vector<Evaluated>& seen,
                                   const OnBatch& on_batch);

} // namespace uq
