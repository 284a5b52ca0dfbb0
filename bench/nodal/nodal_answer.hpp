#pragma once
/// The paper's own scheme run and read like any other.

#include "bench/sweep.hpp"

namespace bench {

/// One wall per thread at a time, at constant speed.
[[nodiscard]] std::vector<Answer> run_nodal(const std::vector<Case>& cases,
                                            double steps_per_mm);

} // namespace bench
