#pragma once
/// Tables of the answer to a question of reliability.

#include "app/output/table/table.hpp"
#include "app/reliability/event.hpp"
#include "uq/reliability/reliability.hpp"

#include <string>
#include <vector>

namespace app {

/// The problem, and how its numbers are shown.
struct Question {
    uq::ReliabilityProblem problem;
    std::vector<ShownNumber> inputs;
    ShownNumber response;
    std::string model; ///< what its answers depend on
};

/// "5 % quantile of the ultimate drift under 1.00 MPa"
[[nodiscard]] std::string quantile_words(const uq::ReliabilityProblem& p);

/// The table of the question that was asked.
[[nodiscard]] Table answer_table(const Question& q, const uq::ReliabilityAnswer& a);

/// One line for each input and measure.
[[nodiscard]] Table sensitivity_table(const uq::ReliabilityAnswer& a);

[[nodiscard]] Table point_table(const Question& q, const uq::ReliabilityAnswer& a);

[[nodiscard]] Table evaluation_table(const Question& q, const std::vector<uq::Evaluated>& seen);

} // namespace app
