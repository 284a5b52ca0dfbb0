#pragma once
/// Limit states with known probabilities, for active learning.

#include "uq/reliability/limit_state/limit_state.hpp"

#include <string>
#include <vector>

namespace active_bench {

struct BenchProblem {
    std::string name;
    std::string source;
    uq::LimitState limit;
    double exact;      ///< by quadrature, to four digits or better
    bool slow = false; ///< repeated a fifth as often
};

[[nodiscard]] std::vector<BenchProblem> bench_problems();

} // namespace active_bench
