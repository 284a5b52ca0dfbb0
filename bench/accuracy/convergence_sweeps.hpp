#pragma once
/// The tables of docs/bench/accuracy/convergence.md: what each changes of the reference, a row
/// each.

#include "bench/sweep.hpp"

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Row {
    std::string label;
    std::function<void(Case&)> change;
};

struct Sweep {
    std::string title, text;
    std::string head; ///< of the first column
    std::vector<Row> rows;
};

/// The settings every table departs from. [MPa]
[[nodiscard]] Case reference(double stress);

[[nodiscard]] std::vector<Sweep> convergence_sweeps();

} // namespace bench
