#pragma once
/// The ways to a small probability, by name.

namespace uq {

enum class ReliabilityMethod {
    monte_carlo,
    form,
    importance,
    subset,
    multi_fidelity,
    sobol,
    active
};

} // namespace uq
